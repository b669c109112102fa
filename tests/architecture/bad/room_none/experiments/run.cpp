// SPDX-License-Identifier: BSD-3-Clause
int rounds = 2;
