// SPDX-License-Identifier: BSD-3-Clause
//
// Parts of a run that are to be put together: they must be dealt from one plan.
#pragma once

#include <filesystem>
#include <string>

#include "driver/campaign/campaign.hpp"

namespace kreisel {

/// The plan that parts are dealt from, as far as their manifests tell.
class PlanOfParts {
  public:
    PlanOfParts() = default;
    /// The plan of a run that is to write such a part.
    explicit PlanOfParts(std::string digest) : whose_("this run"), digest_(std::move(digest)) {}

    /// A manifest and the digest in it. Other manifests than those of parts are passed over. Throws UsageError if the
    /// part is of another plan.
    void add(const std::filesystem::path& manifest, const std::string& digest);
    /// A text if there were parts of older versions, which have no digest; else empty.
    const std::string& warning() const { return warning_; }

  private:
    std::string whose_, digest_, warning_;
};

/// Nothing for runs that are not a part, or that overwrite. Throws UsageError if the folder holds a part of another
/// plan; returns a warning if it holds parts whose plan is not known.
std::string check_parts(const std::filesystem::path& folder, const Plan& plan, const RunSettings& settings);

}  // namespace kreisel
