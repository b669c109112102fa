// SPDX-License-Identifier: BSD-3-Clause
// Source: [known1900, eq. 3], [nobody1999].
#pragma once
