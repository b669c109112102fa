# SPDX-License-Identifier: BSD-3-Clause
#
# Values as the colours of places between two axes of names or numbers; the values stand in the places while they fit. A
# map for each metric, one below the other.
# Called with the settings file, the figure's path without extension and the folder of these scripts.
settings = ARG1
target = ARG2
scripts = ARG3
load scripts . '/style.gp'
load settings
data = 'plotdata/' . figure_name . '.dat'
letter_scale = font_size / 7.5
least_height = 2.8 * letter_scale  # of the scale of colours
place_height = 0.62 * letter_scale
if (place_height * |y_value| < least_height) { place_height = least_height / |y_value| }
if (axes_height > 0) { place_height = axes_height / |y_value| }
slanted = widest_x_cm > 0.95 * place_width
bottom_cm = slanted ? 1.0 * letter_scale + 0.65 * widest_x_cm : 1.1 * letter_scale
title_cm = ((strlen(figure_title) ? 0.5 : 0) + (strlen(figure_note) ? 0.5 : 0)) * letter_scale
top_cm = 0.35
maps = |value_label|
page_width = left_cm + place_width * |x_value| + right_cm
map_height = bottom_cm + place_height * |y_value| + top_cm
page_height = maps * map_height + title_cm
values_fit = place_width > 0.85 * letter_scale && place_height > 0.25 * letter_scale
full_title = figure_title
if (strlen(figure_note)) { full_title = figure_title . (strlen(figure_title) ? "\n" : '') . '{/*0.85 ' . figure_note . '}' }
# White letters on dark places, black ones on bright.
array middle[maps]
do for [m = 1:maps] {
    stats data index m - 1 using (log_scale ? log10($3) : $3) nooutput
    middle[m] = (STATS_min + 2 * STATS_max) / 3.0
}
letter(v, m) = (log_scale ? log10(v) : v) < middle[m] ? 0xffffff : 0x000000
below(m) = (maps - m) * map_height  # cm
do for [format in 'pdf svg png'] {
    load scripts . '/terminal.gp'
    value_font = sprintf(',%g', 5.5 * letter_scale * letter_points)
    set lmargin at screen left_cm / page_width
    set rmargin at screen 1 - right_cm / page_width
    set border 3 lw 0.7
    set tics nomirror out scale 0
    unset xtics
    unset ytics
    set xtics () norotate center
    # Slanted, they are labels: of slanted tics gnuplot warns that they want room, whatever the margin.
    do for [i = 1:|x_value|] {
        if (slanted) { set label 2 + i x_value[i] at first i, graph 0 right rotate by 40 offset 0, -0.6
        } else { set xtics add (x_value[i] i) }
    }
    set ytics ()
    do for [j = 1:|y_value|] { set ytics add (y_value[j] j) }
    if (slanted) { unset xtics } else { set xtics nomirror scale 0 }
    set ytics nomirror scale 0
    set xrange [0.5:|x_value| + 0.5]
    set yrange [0.5:|y_value| + 0.5]
    set palette defined (0 '#440154', 1 '#482878', 2 '#3e4989', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', 6 '#35b779', 7 '#6ece58', 8 '#b5de2b')
    if (log_scale) {
        set logscale cb
        set format cb '10^{%L}'
    }
    set style fill solid 1 noborder
    unset key
    if (maps > 1) { set multiplot }
    do for [m = 1:maps] {
        set bmargin at screen (below(m) + bottom_cm) / page_height
        set tmargin at screen (below(m) + map_height - top_cm) / page_height
        if (m == 1 && strlen(full_title)) { set title full_title } else { unset title }
        set label 1 x_label at screen (left_cm / page_width + 1 - right_cm / page_width) / 2, \
            screen (below(m) + 0.3 * letter_scale) / page_height center
        set label 2 y_label at screen 0.35 * letter_scale / page_width, \
            screen (below(m) + (bottom_cm + map_height - top_cm) / 2) / page_height center rotate by 90
        set cblabel value_label[m] offset 2, 0
        plot data index m - 1 using 1:2:(0.5):(0.5):3 with boxxyerror lc palette, \
             data index m - 1 using 1:2:(values_fit ? strcol(4) : ''):(letter($3, m)) \
             with labels font value_font tc rgb variable
    }
    if (maps > 1) { unset multiplot }
    unset output
}
