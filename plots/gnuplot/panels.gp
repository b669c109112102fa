# SPDX-License-Identifier: BSD-3-Clause
#
# Small multiples of curves, each panel with its legend below. All data drawn are in plotdata/.
# Axis labels and legends are placed on the page by themselves: gnuplot's own key and labels depend on each terminal's
# estimate of letter sizes, and lie beyond the page in SVG.
page_width = width_cm
page_height = height_cm
letter_scale = font_size / 7.5  # of what stands beside letters
full_title = figure_title
if (strlen(figure_note)) {  # what is wanting of the results
    full_title = figure_title . (strlen(figure_title) ? "\n" : '') . '{/*0.85 ' . figure_note . '}'
}
# Dashed curves are drawn over solid ones, which would hide them where both coincide.
is_dashed(style) = dashes[1 + ((style - 1) + (style - 1) / 7) % 5] != 1
array drawn[|curve_file|]
do for [p = 1:panels] {
    k = first_curve[p]
    do for [dashed = 0:1] {
        do for [c = first_curve[p]:last_curve[p]] {
            if (is_dashed(curve_style[c]) == dashed) {
                drawn[k] = c
                k = k + 1
            }
        }
    }
}
do for [format in 'pdf svg png'] {
    load scripts . '/terminal.gp'
    small_font = sprintf(',%g', 6.5 * letter_scale * letter_points)
    if (strlen(full_title)) {
        set multiplot title full_title
    } else {
        set multiplot
    }
    set border 3 lw 0.7
    set grid x y ls 100001
    set tics nomirror out scale 0.5, 0.25
    # SVG has them lower than the other formats, near the label of the axis.
    if (format eq 'svg') { set xtics offset 0, 0.45 } else { set xtics offset 0, 0 }
    do for [p = 1:panels] {
        set lmargin at screen panel_left[p]
        set rmargin at screen panel_right[p]
        set bmargin at screen panel_bottom[p]
        set tmargin at screen panel_top[p]
        set title panel_title[p] offset 0, -0.5
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
        # Of a short axis powers of ten alone would label one place or none.
        set xtics autofreq
        decades = log_x[p] ? log10(x_high[p] / x_low[p]) : 0
        if (decades > 0 && (panel_right[p] - panel_left[p]) * width_cm > 4 * letter_scale * decades) {
            set xtics ()
            do for [k = floor(log10(x_low[p])):ceil(log10(x_high[p]))] {
                power = sprintf('10^{%s%d}', k < 0 ? '−' : '', abs(k))
                set xtics add (power 10.0 ** k)
                do for [m in '2 5'] { set xtics add (m . '·' . power real(m) * 10.0 ** k) }
                do for [m in '3 4 6 7 8 9'] { set xtics add ('' real(m) * 10.0 ** k 1) }
            }
        }
        set xrange [x_low[p]:x_high[p]]
        set yrange [y_low[p]:y_high[p]]
        unset label
        unset arrow
        set label 1001 x_label[p] at screen (panel_left[p] + panel_right[p]) / 2, screen panel_bottom[p] - 0.75 * letter_scale / height_cm center
        set label 1002 y_label[p] at screen panel_left[p] - 1.34 * letter_scale / width_cm, screen (panel_bottom[p] + panel_top[p]) / 2 center rotate by 90
        do for [m = first_mark[p]:last_mark[p]] {
            set label m mark_text[m] at mark_x[m], mark_y[m] center textcolor rgb '#555555' font small_font
        }
        unset key
        if (legend_rows[p]) {
            do for [c = first_curve[p]:last_curve[p]] {
                k = c - first_curve[p]
                entry_x = panel_left[p] + (k / legend_rows[p] * legend_width[p] - 1.5 * letter_scale) / width_cm
                entry_y = legend_top[p] - (k % legend_rows[p] + 0.5) * legend_row / height_cm
                if (curve_with ne 'points') {
                    set arrow 2000 + c from screen entry_x, screen entry_y to screen entry_x + 0.75 * letter_scale / width_cm, screen entry_y nohead ls curve_style[c]
                }
                set label 2000 + c curve_label[c] at screen entry_x + 0.9 * letter_scale / width_cm, screen entry_y left
                if (curve_with ne 'lines' || bears_marks[c]) {
                    set label 3000 + c '' at screen entry_x + 0.375 * letter_scale / width_cm, screen entry_y point ls curve_style[c]
                }
            }
        }
        guides = has_guides[p] ? "'plotdata/' . figure_name . '.guides' . p . '.dat' with lines ls 100000 notitle, " : ''
        curves = "for [k = first_curve[p]:last_curve[p]] 'plotdata/' . curve_file[drawn[k]] with " . curve_with . ' ls curve_style[drawn[k]]'
        # Lines of one colour bear marks, each between those of the others: dashes do not show on a line of their colour.
        bears = curve_with eq 'lines' && last_marks[p] >= first_marks[p]
        offsets = bears ? ", for [k = first_marks[p]:last_marks[p]] 'plotdata/' . marks_file[k] with points ls marks_style[k]" : ''
        eval 'plot ' . guides . curves . offsets
    }
    unset multiplot
    unset output
}
