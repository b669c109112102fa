// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/planned.hpp"

namespace kreisel {

Cell PlannedCell::cell() const {
    Cell cell = run->cell;
    cell.parameters = run->problems->parameters(point);
    cell.steps = steps;
    cell.tolerance = tolerance;
    return cell;
}

CellIdentity PlannedCell::identity() const {
    CellIdentity identity = run->identity;
    identity.label = label();
    identity.parameters = run->problems->parameters_text(point);
    identity.cell = hash();
    identity.steps = steps;
    identity.h = steps > 0 ? (identity.t_end - identity.t_begin) / static_cast<double>(steps) : 0;
    identity.tolerance = tolerance;
    identity.controller = tolerance > 0 ? run->cell.controller : "";
    return identity;
}

}  // namespace kreisel
