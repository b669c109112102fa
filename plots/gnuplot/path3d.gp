# SPDX-License-Identifier: BSD-3-Clause
#
# The path of a mass centre in space, coloured by time, with its shadow on the floor; a circle at the start, a disc at
# the end.
# Called with the settings file, the figure's path without extension and the folder of these scripts.
settings = ARG1
target = ARG2
scripts = ARG3
load scripts . '/style.gp'
load settings
load scripts . '/space.gp'
data = 'plotdata/' . figure_name
page_width = width_cm
page_height = 7.6 / 8.5 * width_cm
do for [format in 'pdf svg png'] {
    load scripts . '/terminal.gp'
    splot data . '.shadow.dat' using 1:2:3 with lines ls 100001, \
          data . '.path.dat' using 1:2:3:4 with lines lw 1.2 lc palette, \
          data . '.ends.dat' index 0 using 1:2:3 with points pt 6 ps 0.7 lw 1.2 lc rgb 'black', \
          data . '.ends.dat' index 1 using 1:2:3 with points pt 7 ps 0.7 lc rgb 'black'
    unset output
}
