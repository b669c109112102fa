# SPDX-License-Identifier: BSD-3-Clause
#
# The motion as a sequence of drawn tops, coloured by time, over the path of the mass centre and its shadow.
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
          data . '.path.dat' using 1:2:3 with lines ls 100000, \
          data . '.tops.dat' using 1:2:3:4 with lines lw 0.9 lc palette
    unset output
}
