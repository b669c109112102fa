# SPDX-License-Identifier: BSD-3-Clause
#
# Panels of points without lines.
# Called with the settings file, the figure's path without extension and the folder of these scripts.
settings = ARG1
target = ARG2
scripts = ARG3
load scripts . '/style.gp'
load settings
curve_with = 'points'
load scripts . '/panels.gp'
