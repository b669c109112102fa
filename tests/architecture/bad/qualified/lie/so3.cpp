// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
template <class T>
T norm(T x) { return std::sqrt(x * x); }
