# SPDX-License-Identifier: BSD-3-Clause
#
# What accuracies cost, from the table work_precision of an experiment as CSV: a row per formulation and method, a column per
# accuracy. -v metric=error.position -v cost=evaluations.

NR == 1 { read_titles($0); next }

{
    fields_of($0, field)
    if (field[at["metric"]] != metric || field[at["cost"]] != cost) next
    formulation = at["formulation"] ? field[at["formulation"]] : ""
    row = formulation SUBSEP field[at["method"]]
    if (!(row in seen)) { seen[row] = 1; rows[++count] = row; if (formulation != rows_of) { rows_of = formulation; ++groups } }
    accuracy = field[at["accuracy"]]
    if (!(accuracy in known)) { known[accuracy] = 1; accuracies[++columns] = accuracy }
    bound = field[at["bound"]]
    cell[row, accuracy] = bound == "not reached" ? "--" : (bound == "at most" ? "$\\le$\\," : "") rounded(field[at["value"]]) \
        (field[at["lowest"]] == "yes" ? "*" : "")
}

END {
    named = groups > 1
    printf "\\begin{tabular}{%sl", named ? "l" : ""
    for (c = 1; c <= columns; ++c) printf "r"
    printf "}\n\\toprule\n%smethod", named ? "formulation & " : ""
    for (c = 1; c <= columns; ++c) { split(sprintf("%.0e", accuracies[c]), part, "e"); printf " & $10^{%d}$\\,m", part[2] }
    print "\\\\"
    for (r = 1; r <= count; ++r) {
        split(rows[r], part, SUBSEP)
        if (part[1] != before) { print "\\midrule"; before = part[1] } else if (r == 1) print "\\midrule"
        printf "%s\\code{%s}", named ? escaped(part[1]) " & " : "", escaped(part[2])
        for (c = 1; c <= columns; ++c) printf " & %s", cell[rows[r], accuracies[c]]
        print "\\\\"
    }
    print "\\bottomrule\n\\end{tabular}"
}
