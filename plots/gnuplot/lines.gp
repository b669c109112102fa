# SPDX-License-Identifier: BSD-3-Clause
#
# Panels of curves over time, drawn as lines.
# Called with the settings file, the figure's path without extension and the folder of these scripts.
settings = ARG1
target = ARG2
scripts = ARG3
load scripts . '/style.gp'
load settings
curve_with = 'lines'
load scripts . '/panels.gp'
