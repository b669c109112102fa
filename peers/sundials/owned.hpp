// SPDX-License-Identifier: BSD-3-Clause
//
// What SUNDIALS [hindmarsh2005] allocates, each with the function that frees it.
#pragma once

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>

#include <memory>
#include <new>
#include <type_traits>

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Throws std::bad_alloc if there is nothing to own.
template <class Handle>
class Owned {
  public:
    using Free = void (*)(Handle);
    Owned() : handle_(nullptr, nullptr) {}
    Owned(Handle handle, Free free) : handle_(handle, free) {
        if (!handle_) throw std::bad_alloc();
    }
    Handle get() const { return handle_.get(); }

  private:
    std::unique_ptr<std::remove_pointer_t<Handle>, Free> handle_;
};

/// Errors are values here, and nothing is printed.
inline Owned<SUNContext> sundials_context() {
    SUNContext context = nullptr;
    SUNContext_Create(nullptr, &context);
    return {context, [](SUNContext c) { SUNContext_Free(&c); }};
}

/// The n reals at `data`, which outlive the vector.
inline Owned<N_Vector> vector_of(Real* data, std::size_t n, SUNContext context) {
    return {N_VMake_Serial(static_cast<sunindextype>(n), data, context), N_VDestroy};
}

inline void say_nothing(int, const char*, const char*, char*, void*) {}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
