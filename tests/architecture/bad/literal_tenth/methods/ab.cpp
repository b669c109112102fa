// SPDX-License-Identifier: BSD-3-Clause
namespace kreisel {
inline namespace KREISEL_PRECISION {
const Real weight = 0.1;
}
}
