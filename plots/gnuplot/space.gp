# SPDX-License-Identifier: BSD-3-Clause
#
# Axes of the figures in space: one scale for all three, the floor at the bottom of the box.
set xrange [low_1:high_1]
set yrange [low_2:high_2]
set zrange [low_3:high_3]
set cbrange [t_first:t_last]
set view elevation, azimuth, 1.12
set view equal xyz
set xyplane at low_3
set border 127 + 256 + 512 lw 0.5 lc rgb '#999999'
set grid x y ls 100001
set tics nomirror scale 0.5 textcolor rgb 'black'
# Some four intervals of 1, 2 or 5 times a power of ten.
quarter = (high_1 - low_1) / 4
power = 10 ** floor(log10(quarter))
leading = quarter / power
interval = power * (leading < 1.5 ? 1 : leading < 3.5 ? 2 : leading < 7.5 ? 5 : 10)
set xtics interval
set ytics interval
set ztics interval
set xlabel 'x_1 [m]' offset 0, -0.3
set ylabel 'x_2 [m]' offset 0, -0.3
set label 2 'x_3 [m]' at screen 0.14, screen 0.8 center
set label 1 't [s]' at screen 0.93, screen 0.82 center
set colorbox user origin 0.87, 0.34 size 0.025, 0.42
set pm3d scansforward  # what is last in time lies over what was before
# viridis: even in lightness, distinguishable with any colour vision
set palette defined (0 '#440154', 1 '#482878', 2 '#3e4989', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', 6 '#35b779', 7 '#6ece58', 8 '#b5de2b')
if (strlen(figure_title)) { set title figure_title }
if (strlen(figure_note)) { set label 3 '{/*0.85 ' . figure_note . '}' at screen 0.02, screen 0.03 left }
unset key
