// SPDX-License-Identifier: BSD-3-Clause
//
// Memory in which workers tell how far they are: nothing is sent, and a worker that is killed leaves its last number.
#pragma once

#include <array>
#include <cstddef>

#include "support/watch.hpp"

namespace kreisel {

/// Places that this process shares with those it forks afterwards. Their numbers only inform: where the system refuses
/// the memory, and beyond the last place, there is none.
class Shares {
  public:
    Shares();
    ~Shares();
    Shares(const Shares&) = delete;
    Shares& operator=(const Shares&) = delete;

    /// Null where there is none.
    Share* place(std::size_t number) const { return places_ && number < places ? &(*places_)[number] : nullptr; }

  private:
    static constexpr std::size_t places = 1024;
    using Places = std::array<Share, places>;
    Places* places_ = nullptr;
};

}  // namespace kreisel
