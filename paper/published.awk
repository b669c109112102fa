# SPDX-License-Identifier: BSD-3-Clause
#
# Published numbers beside ours, from the table of `kreisel published` as CSV.

BEGIN {
    name["published_bicycle"] = "benchmark bicycle, 5\\,m/s"
    name["published_detest_b5"] = "DETEST B5, $t=20$"
    name["published_tumbling_brick"] = "tumbling brick, $t=30$\\,s"
    name["published_pendulum"] = "simple pendulum, $t=10$\\,s"
    name["published_slider_crank_01"] = "slider-crank, $t=0.1$\\,s"
    name["published_slider_crank_02"] = "slider-crank, $t=0.2$\\,s"
    name["published_slider_crank_10"] = "slider-crank, $t=1$\\,s"
    part_of["real"] = "Re"; part_of["imaginary"] = "Im"
    print "\\begin{tabular}{llrrrl}\n\\toprule\nproblem & quantity & printed & ours & digits & source\\\\\n\\midrule"
}

NR == 1 { read_titles($0); next }

# "eigenvalue.3.real", "final.top.omega.1 [rad/s]".
function quantity(text,   part) {
    sub(/ \[.*/, "", text)
    split(text, part, ".")
    if (part[1] == "eigenvalue") return "$\\mathrm{" part_of[part[3]] "}\\,\\lambda_{" part[2] "}$"
    return "$" (part[3] == "omega" ? "\\omega" : part[3]) "_{" part[4] "}$ of the " (part[2] ~ /^mass/ ? "mass" : part[2])
}

# "meijaard2007, Table 2", "hull1972, enrightpryce1987", or words.
function source(text,   part, n) {
    n = split(text, part, ", ")
    if (part[1] !~ /^[a-z]+[0-9]+$/) return "\\citep{gonzalez2006}, " escaped(part[n] ~ /A01/ ? "A01" : part[n])
    return part[2] ~ /^[a-z]+[0-9]+$/ ? "\\citep{" part[1] "," part[2] "}" : n > 1 ? "\\citep[" part[2] "]{" part[1] "}" : \
        "\\citep{" part[1] "}"
}

{
    fields_of($0, field)
    config = field[at["config"]]
    digits = field[at["digits"]]; sub(/ of /, "/", digits)
    printed = field[at["printed"]]; ours = field[at["here"]]
    sub(/^'/, "", printed); sub(/^'/, "", ours)
    printf "%s & %s & $%s$ & $%s$ & %s & %s\\\\\n", config == before ? "" : (config in name ? name[config] : escaped(config)),
        quantity(field[at["quantity"]]), printed, ours, digits, source(field[at["source"]])
    before = config
}

END { print "\\bottomrule\n\\end{tabular}" }
