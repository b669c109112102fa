# SPDX-License-Identifier: BSD-3-Clause
$pdf_mode = 1;
$bibtex_use = 1.5;
