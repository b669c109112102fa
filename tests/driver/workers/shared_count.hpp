// SPDX-License-Identifier: BSD-3-Clause
//
// Counts that worker processes share with the test that started them.
#pragma once

#include <sys/mman.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <new>
#include <stdexcept>

namespace kreisel {

/// An object in memory that children made by fork share.
template <class Value>
class InSharedMemory {
  public:
    InSharedMemory() {
        void* place = ::mmap(nullptr, sizeof(Value), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (place == MAP_FAILED) { throw std::runtime_error("no shared memory"); }
        value_ = new (place) Value{};
    }
    ~InSharedMemory() { ::munmap(value_, sizeof(Value)); }
    InSharedMemory(const InSharedMemory&) = delete;
    InSharedMemory& operator=(const InSharedMemory&) = delete;
    Value& operator*() const { return *value_; }
    Value* operator->() const { return value_; }

  private:
    Value* value_ = nullptr;
};

class SharedCount {
  public:
    operator int() const { return *count_; }  // NOLINT(google-explicit-constructor): it stands for the number
    SharedCount& operator++() { return ++*count_, *this; }

  private:
    InSharedMemory<std::atomic<int>> count_;
};

/// At most 1000 numbers.
class SharedNumbers {
  public:
    void push_back(long number) const { numbers_->values.at(numbers_->count++) = number; }
    std::size_t size() const { return numbers_->count; }
    long operator[](std::size_t i) const { return numbers_->values.at(i); }
    const long* begin() const { return numbers_->values.data(); }
    const long* end() const { return begin() + size(); }

  private:
    struct Numbers {
        std::atomic<std::size_t> count;
        std::array<long, 1000> values;
    };
    InSharedMemory<Numbers> numbers_;
};

}  // namespace kreisel
