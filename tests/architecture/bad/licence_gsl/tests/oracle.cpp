// SPDX-License-Identifier: BSD-3-Clause
#include <gsl/gsl_sf_elljac.h>
