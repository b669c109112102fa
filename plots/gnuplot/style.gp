# SPDX-License-Identifier: BSD-3-Clause
#
# Line styles of all figures. Fonts are given for the page: 7.5 points in a column 8.5 cm wide.
# Colours of Okabe and Ito, distinguishable with any colour vision; point and dash types differ as well.
font_size = 7.5
pixels_per_cm = 80.0

array colour[7] = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#000000']
array mark[9] = [6, 4, 8, 10, 12, 2, 1, 14, 3]
array dashes[5] = [1, 10, 11, 12, 13]

set dashtype 10 (8, 3)
set dashtype 11 (2, 2)
set dashtype 12 (10, 3, 2, 3)
set dashtype 13 (10, 3, 2, 3, 2, 3)

do for [i = 1:630] {
    set style line i lc rgb colour[1 + (i - 1) % 7] pt mark[1 + (i - 1) % 9] ps 0.65 lw 1.3 dt dashes[1 + ((i - 1) + (i - 1) / 7) % 5]
}
set style line 100000 lc rgb '#777777' lw 0.8 dt 1
set style line 100001 lc rgb '#bbbbbb' lw 0.5 dt 1
set encoding utf8
set minussign
