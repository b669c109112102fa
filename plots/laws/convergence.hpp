// SPDX-License-Identifier: BSD-3-Clause
//
// Errors and observed orders of the cells of a convergence study.
#pragma once

#include "plots/tables/names.hpp"
#include "records/fits/order.hpp"

namespace kreisel {

/// Scale: the size of the final state of the finest cell. Error of the reference: the largest of the cells that are ok
/// and hold the metric.
OrderLimits limits_of(const CellGroup& group, const std::string& metric);

/// The errors of one metric over the cells of a group that are ok and hold it, and their observed order. Steps to a
/// tolerance have none, and no points here.
ObservedOrder order_of(const CellGroup& group, const std::string& metric);

/// The cell with most steps, or with the smallest tolerance, of those that are ok; null where none is.
const ResultRow* finest(const CellGroup& group);

/// The error.* metrics that occur, in the order of the catalogue, each before its maximum over samples.
std::vector<std::string> error_metrics(const std::vector<ResultRow>& rows);

}  // namespace kreisel
