// SPDX-License-Identifier: BSD-3-Clause
bool small(double x);
bool tiny() { return small(1e-14); }
