# SPDX-License-Identifier: BSD-3-Clause
#
# What steps preserve, from the table structure of the experiment of that name as CSV: a row per method, for each problem and
# formulation a pair of columns.

NR == 1 { read_titles($0); next }

{
    fields_of($0, field)
    system_ = field[at["problem"]] ", " field[at["formulation"]]
    method = field[at["method"]]
    if (!(system_ in known)) { known[system_] = 1; systems[++columns] = system_ }
    if (!(method in seen)) { seen[method] = 1; methods[++count] = method }
    verdict = field[at["verdict"]]
    if (sub(/^h\^/, "", verdict)) verdict = "$h^{" verdict "}$"
    cell[method, system_, field[at["metric"]]] = verdict
    if (verdict != "-") told[method] = 1
}

function value(method, column, metric,   text) {
    text = cell[method, systems[column], metric]
    return text == "" || text == "-" ? "--" : text
}

END {
    printf "\\begin{tabular}{l"
    for (c = 1; c <= columns; ++c) printf "ll"
    print "}\n\\toprule"
    for (c = 1; c <= columns; ++c) {
        split(systems[c], part, ", "); name = part[1]; gsub(/_/, " ", name)
        printf " & \\multicolumn{2}{l}{%s}", name
    }
    print "\\\\"
    for (c = 1; c <= columns; ++c) {
        split(systems[c], part, ", ")
        printf " & \\multicolumn{2}{l}{%s}", part[2] == "SO3" ? "$\\SO$" : part[2] == "SE3" ? "$\\SE$" : "$\\R^3\\times\\SO$"
    }
    print "\\\\"
    for (c = 1; c <= columns; ++c) printf " & $\\omega$ & $\\leftrightarrow$"
    print "\\\\\n\\midrule"
    for (m = 1; m <= count; ++m) {
        if (!(methods[m] in told)) continue
        printf "\\code{%s}", escaped(methods[m])
        for (c = 1; c <= columns; ++c)
            printf " & %s & %s", value(methods[m], c, "structure.symplectic"), value(methods[m], c, "structure.reversal")
        print "\\\\"
    }
    print "\\bottomrule\n\\end{tabular}"
}
