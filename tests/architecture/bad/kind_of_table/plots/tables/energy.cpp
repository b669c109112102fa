// SPDX-License-Identifier: BSD-3-Clause
namespace {
TextTable drift_table() { return cell_table("drift"); }
bool is_long(const Results& results) { return results.kind == "drift"; }
}  // namespace

KREISEL_TABLE({.name = "drift", .is_printed = is_long, .make = drift_table});
