// SPDX-License-Identifier: BSD-3-Clause
//
// What a worker prints: the first 4 kB, in memory, readable by whoever holds it when the worker has crashed.
#pragma once

#include <string>

#include "support/files.hpp"

namespace kreisel {

/// A sealed file in memory that can be written but cannot grow: a method that prints for ever fills no memory and meets
/// no full pipe.
class Printed {
  public:
    /// Not valid if the system refuses it; errno says why.
    static Printed make();
    explicit Printed(Descriptor file) : file_(std::move(file)) {}

    bool valid() const { return file_.valid(); }
    int number() const { return file_.number(); }
    /// Makes it standard output and error of this process, unbuffered, so that a crash loses nothing.
    void divert() const;
    /// What was printed since the last call, on one line. All descriptors of it share one position.
    std::string take() const;

  private:
    Descriptor file_;
};

}  // namespace kreisel
