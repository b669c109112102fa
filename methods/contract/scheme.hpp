// SPDX-License-Identifier: BSD-3-Clause
//
// How a method combines its slopes, as data that it declares. Nothing here is evaluated: the engine of a family runs
// its data, and the test file of the family (tests/judges/families/) evaluates one step and the order conditions from
// them, independently.
#pragma once

#include <any>
#include <concepts>
#include <utility>
#include <vector>

#include "methods/tableaus/tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The data of any family, whose type tells the family.
class Scheme {
  public:
    template <class Family>
    requires(!std::same_as<Family, Scheme>) explicit Scheme(Family data) : data_(std::move(data)) {}

    /// The data of this family; null if the scheme is of another.
    template <class Family>
    const Family* as() const {
        return std::any_cast<Family>(&data_);
    }

  private:
    std::any data_;
};

/// methods/rkmk/rkmk.hpp.
struct MuntheKaasScheme {
    Tableau tableau;
};

/// methods/crouch_grossman/crouch_grossman.hpp.
struct CrouchGrossmanScheme {
    Tableau tableau;
};

/// A product of exponentials of combinations of slopes, appended to the point of an earlier stage:
///   y_from exp(h sum_j f_1j K_j) exp(h sum_j f_2j K_j) ...;
/// trailing zeros of a factor may be left out. y_1 = y_n; a row that begins with the product of another starts `from`
/// it, which saves those exponentials.
struct ExponentialProduct {
    int from = 1;
    std::vector<std::vector<Coefficient>> factors = {};
};

/// methods/commutator_free/commutator_free.hpp.
struct CommutatorFreeScheme {
    std::vector<ExponentialProduct> stages;  ///< y_i; the first is empty
    ExponentialProduct result;               ///< y_{n+1}
    ExponentialProduct embedded = {};        ///< of a pair, the solution it is compared with; no factors: none
};

/// A combination of slopes and of single brackets of them, k = h K:  sum_j a_j k_j + sum c [k_left, k_right].
struct BracketTerm {
    int left, right;  ///< stages, from 1
    Coefficient coefficient;
};
struct BracketSum {
    std::vector<Coefficient> weights = {};
    std::vector<BracketTerm> brackets = {};
};

/// methods/rkmk/few_commutators.hpp. As printed, for Y' = A(Y) Y.
struct FewCommutatorsScheme {
    std::vector<BracketSum> stages;  ///< u_i; the first is empty
    BracketSum result;
};

/// methods/extrapolation/base.hpp, the rule on the group.
struct GroupExtrapolationScheme {
    int columns;  ///< k, of rows with 2, 4, ..., 2k substeps
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
