// SPDX-License-Identifier: BSD-3-Clause
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include "lie/real.hpp"
