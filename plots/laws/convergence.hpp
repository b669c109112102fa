// SPDX-License-Identifier: BSD-3-Clause
//
// Errors and observed orders of the cells of a convergence study.
#pragma once

#include "plots/tables/names.hpp"
#include "records/fits/order.hpp"

namespace kreisel {

/// The errors of one metric over the cells of a group that are ok and hold it, and their observed order. The scale is
/// the size of the final state of the finest cell; the reference's error is the largest of the group.
ObservedOrder order_of(const CellGroup& group, const std::string& metric);

/// The cell with most steps of those that are ok; null where none is.
const ResultRow* finest(const CellGroup& group);

/// The error.* metrics that occur, in the order of the contract.
std::vector<std::string> error_metrics(const std::vector<ResultRow>& rows);

}  // namespace kreisel
