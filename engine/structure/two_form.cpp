// SPDX-License-Identifier: BSD-3-Clause
#include "engine/structure/two_form.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

MatX two_form(const Group& group, const VecX& mu, const MatX& xi, const MatX& d, const Real& sign) {
    MatX form = xi.transpose() * d;
    form = (form - form.transpose()).eval();
    VecX bracket(xi.rows());
    for (Eigen::Index i = 0; i < xi.cols(); ++i)
        for (Eigen::Index j = i + 1; j < xi.cols(); ++j) {
            group.bracket(xi.col(i).data(), xi.col(j).data(), bracket.data());
            const Real moved = sign * mu.dot(bracket);
            form(i, j) += moved, form(j, i) -= moved;
        }
    return form;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
