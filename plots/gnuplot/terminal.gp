# SPDX-License-Identifier: BSD-3-Clause
#
# Opens the output. Reads: format (pdf, svg, png), target (file without extension), page_width and page_height (cm),
# font_size (points on the page).
letter_points = format eq 'svg' ? 1 / 0.75 : 1.0  # of a letter of one point
face = sprintf('DejaVu Sans,%g', font_size)
if (format eq 'pdf') {
    set terminal pdfcairo enhanced size page_width * 1.0 cm, page_height * 1.0 cm font face fontscale 0.75 linewidth 1
}
if (format eq 'svg') {
    set terminal svg enhanced size page_width * 37.8, page_height * 37.8 font sprintf('DejaVu Sans,%g', font_size * letter_points) linewidth 1.3 background rgb 'white'
}
if (format eq 'png') {
    set terminal pngcairo enhanced size page_width * pixels_per_cm, page_height * pixels_per_cm font face fontscale pixels_per_cm / 37.8 linewidth 2 pointscale 2
}
set output target . '.' . format
