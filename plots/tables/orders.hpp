// SPDX-License-Identifier: BSD-3-Clause
//
// Errors and observed orders of the cells of a convergence study.
#pragma once

#include "plots/tables/cells.hpp"
#include "records/fits/order.hpp"

namespace kreisel {

/// The errors of one metric over the cells of a group that are ok and hold it, and their observed order. The scale is
/// the size of the final state of the finest cell; the reference's error is the largest of the group.
ObservedOrder order_of(const CellGroup& group, const std::string& metric);

/// The error.* metrics that occur, in the order of the contract.
std::vector<std::string> error_metrics(const std::vector<ResultRow>& rows);

/// One row per group and metric, with window, slopes and reason.
TextTable orders_in_full(const Results& results);
/// One row per group, one column per metric: "3.99 ± 0.02 [256–4096]", or the reason in short.
TextTable orders_in_brief(const Results& results);
/// One row per cell: steps, step size and the error of each metric.
TextTable errors_in_full(const Results& results);
/// The finest cell of each group.
TextTable errors_in_brief(const Results& results);

}  // namespace kreisel
