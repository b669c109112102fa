# SPDX-License-Identifier: BSD-3-Clause
#
# Small multiples of curves, each panel with its legend below. Everything that is drawn stands in plotdata/.
page_width = width_cm
page_height = height_cm
do for [format in 'pdf svg png'] {
    load scripts . '/terminal.gp'
    if (strlen(figure_title)) {
        set multiplot title figure_title
    } else {
        set multiplot
    }
    set border 3 lw 0.7
    set grid x y ls 101
    set tics nomirror out scale 0.5, 0.25
    do for [p = 1:panels] {
        set lmargin at screen panel_left[p]
        set rmargin at screen panel_right[p]
        set bmargin at screen panel_bottom[p]
        set tmargin at screen panel_top[p]
        set title panel_title[p] offset 0, -0.5
        set xlabel x_label[p] offset 0, 0.4
        set ylabel y_label[p]
        unset logscale
        set format '%g'
        if (log_x[p]) {
            set logscale x
            set format x '10^{%L}'
            set mxtics 10
        } else {
            set mxtics default
        }
        if (log_y[p]) {
            set logscale y
            set format y '10^{%L}'
        }
        set xrange [x_low[p]:x_high[p]]
        set yrange [y_low[p]:y_high[p]]
        unset label
        do for [m = first_mark[p]:last_mark[p]] {
            set label m mark_text[m] at mark_x[m], mark_y[m] center textcolor rgb '#555555' font ',6.5'
        }
        if (legend_rows[p]) {
            set key at screen panel_left[p] - 1.5 / width_cm, screen legend_top[p] left top Left reverse vertical \
                maxrows legend_rows[p] samplen 2.2 spacing 1.05 width 0.5 height 0
        } else {
            unset key
        }
        if (has_guides[p]) {
            plot 'plotdata/' . figure_name . '.guides' . p . '.dat' with lines ls 100 notitle, \
                 for [c = first_curve[p]:last_curve[p]] 'plotdata/' . curve_file[c] \
                 with @curve_with ls curve_style[c] title curve_label[c]
        } else {
            plot for [c = first_curve[p]:last_curve[p]] 'plotdata/' . curve_file[c] \
                 with @curve_with ls curve_style[c] title curve_label[c]
        }
    }
    unset multiplot
    unset output
}
