// SPDX-License-Identifier: BSD-3-Clause
#include "records/diff/recorded_number.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "support/number_text.hpp"

// 113 bits without the quad library: the C library converts and finds neighbours, the compiler subtracts and divides.
// The headers of the C library hide both functions from compilers other than GCC (clang-tidy).
extern "C" {
__float128 strtof128(const char*, char**) noexcept;
__float128 nextafterf128(__float128, __float128) noexcept;
}

namespace kreisel {

namespace {

using Binary128 = __float128;

Binary128 read_binary128(const std::string& decimal) { return ::strtof128(decimal.c_str(), nullptr); }

double size_of(double x) { return std::fabs(x); }
Binary128 size_of(Binary128 x) { return x < 0 ? -x : x; }
double next_smaller(double x) { return std::nextafter(x, 0.0); }
Binary128 next_smaller(Binary128 x) { return ::nextafterf128(x, 0); }

// Each is divided by the spacing, a power of two, before they are subtracted: their difference could be infinite.
template <class Float>
NumberDistance distance_of(Float a, Float b) {
    if (a == b) { return {}; }
    const Float larger = size_of(a) < size_of(b) ? size_of(b) : size_of(a);
    const Float spacing = larger - next_smaller(larger);
    NumberDistance result;
    result.absolute = static_cast<double>(size_of(a - b));
    result.relative = static_cast<double>(size_of(a / larger - b / larger));
    result.ulps = static_cast<double>(size_of(a / spacing - b / spacing));
    return result;
}

}  // namespace

std::string RecordedNumber::text() const { return quad.empty() ? exact_text(value) : quad; }

RecordedNumber quad_number(const std::string& decimal) {
    char* end = nullptr;
    const double value = std::strtod(decimal.c_str(), &end);
    if (decimal.empty() || *end != '\0' || !std::isfinite(value)) {
        throw std::invalid_argument("expected a number, got \"" + decimal + "\"");
    }
    return {value, decimal};
}

NumberDistance distance(const RecordedNumber& a, const RecordedNumber& b) {
    if (a.quad.empty() || b.quad.empty()) { return distance_of(a.value, b.value); }
    return distance_of(read_binary128(a.quad), read_binary128(b.quad));
}

}  // namespace kreisel
