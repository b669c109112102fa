// SPDX-License-Identifier: BSD-3-Clause
namespace kreisel {
Real twice(Real x) { return 2 * x; }
}
