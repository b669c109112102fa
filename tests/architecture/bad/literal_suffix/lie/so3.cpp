// SPDX-License-Identifier: BSD-3-Clause
const auto half = 0.5f;
