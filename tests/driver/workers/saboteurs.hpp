// SPDX-License-Identifier: BSD-3-Clause
//
// The fake engine with methods that attack the process they run in. They are linked into this test program only.
#pragma once

#include "tests/driver/fake_engine.hpp"

namespace kreisel {

/// Methods sabotage/NAME: segfault, abort, terminate, exit, overflow (of the stack), loop, hoard (all memory it gets),
/// greedy (100 MB, then it is good), throw, print (and is good), flood (prints 1 MB), close (all descriptors), kill
/// (its process, the first time only), sleep (ten minutes, whatever it is asked). The problem free_top does the like in
/// its reference if its mass is 1 (segfault), 2 (loop), 3 (hoard), 4 (throw).
class Saboteurs final : public FakeEngine {
  public:
    using FakeEngine::reference;
    using FakeEngine::run;
    std::vector<MethodDescription> methods() const override;
    /// Saboteurs run for the usual mass only.
    std::string skip_reason(const Cell&) const override;
    Outcome run(const Cell&, const Reference* reference, const Watch&, SampleSink* samples) const override;
    Reference reference(const std::string& problem, const ParameterValues&, const BeginState* begin, double t_end,
                        long samples, const Watch&) const override;

    mutable SharedCount killed;       ///< by sabotage/kill
    mutable SharedNumbers processes;  ///< of sabotage/sleep
};

}  // namespace kreisel
