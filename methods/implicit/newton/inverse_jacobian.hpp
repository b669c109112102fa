// SPDX-License-Identifier: BSD-3-Clause
//
// H = I + sum u_i p_i^T, an approximate inverse of a Jacobian J near the identity, from pairs with J s = p that come
// one after another: each update makes H p = s hold and leaves H as it was on all that is orthogonal to p (Broyden's
// second method [broyden1965]; several orthogonal p at a time make it Anderson's mixing [fangsaad2009]).
// Few unknowns keep the matrix; many keep the last pairs, whose number does not grow with the unknowns.
#pragma once

#include <vector>

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class InverseJacobian {
  public:
    /// Keeps at most `most` pairs, if it keeps pairs.
    InverseJacobian(Eigen::Index unknowns, Eigen::Index most);

    void clear();
    /// Whether it keeps the matrix, and thus every pair.
    bool keeps_all() const { return u_.cols() == 0; }
    /// out = H r; other storage than r.
    void apply(const VecX& r, VecX& out) const;
    /// H += u p^T with |p| = 1. If more than `keep` pairs would be kept, the oldest is dropped, but what it knows of
    /// the directions of younger ones is passed on to them.
    void add(const VecX& u, const VecX& p, Eigen::Index keep);

  private:
    void add_product(const VecX& r, VecX& out) const;
    void drop_oldest();

    MatX matrix_;                      // H - I, or nothing
    MatX u_, p_;                       // pairs as columns, or nothing
    std::vector<Eigen::Index> order_;  // columns in use, the oldest first
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
