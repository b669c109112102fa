// SPDX-License-Identifier: BSD-3-Clause
//
// Values that many rows of results hold alike, such as options and names, kept once.
#pragma once

#include <memory>
#include <set>
#include <utility>

namespace kreisel {

/// A value that is not changed, only replaced. Copies hold it together.
template <class Value>
class Shared {
  public:
    Shared() = default;
    Shared(Value value) : value_(std::make_shared<const Value>(std::move(value))) {}  // NOLINT: it stands for the value

    const Value& operator*() const {
        static const Value none{};
        return value_ == nullptr ? none : *value_;
    }
    const Value* operator->() const { return &**this; }
    operator const Value&() const { return **this; }  // NOLINT: likewise

    friend bool operator==(const Shared& a, const Shared& b) { return a.value_ == b.value_ || *a == *b; }
    friend bool operator<(const Shared& a, const Shared& b) { return *a < *b; }

  private:
    std::shared_ptr<const Value> value_;  // null: that of Value{}
};

/// The first of all equal values that it has met.
template <class Value>
class Pool {
  public:
    /// Replaces the value by the one that is kept.
    void share(Shared<Value>& value) { value = *known_.insert(value).first; }

  private:
    std::set<Shared<Value>> known_;
};

}  // namespace kreisel
