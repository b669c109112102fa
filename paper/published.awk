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
    name["published_exudyn"] = "fast heavy top, $t=1$\\,s"
    name["published_simo_wong"] = "top of Simo and Wong"
    name["published_dmv"] = "free body, preprocessed DMV"
    name["published_rattlie"] = "RATTLie"
    name["published_bliedf"] = "BLieDF"
    name["published_generalised_alpha"] = "generalised-$\\alpha$"
    name["published_multiplier_transient"] = "generalised-$\\alpha$"
    part_of["real"] = "Re"; part_of["imaginary"] = "Im"
    print "\\begin{tabular}{llrrrl}\n\\toprule\nproblem & quantity & printed & ours & digits & source\\\\\n\\midrule"
}

NR == 1 { read_titles($0); next }

# What a row is of: "formulation=SE3 steps=1000 final.top.omega.1 [rad/s]" has the cells before the quantity.
function cells(text,   part, n, i, all) {
    n = split(text, part, /[ ,;]+/)
    for (i = 1; i <= n; ++i) {
        if (part[i] !~ /=/) continue
        sub(/^[a-z.]+=/, "", part[i]); sub(/^[a-z_]+\//, "", part[i])
        all = all (all == "" ? "" : ", ") escaped(part[i])
    }
    return all == "" ? "" : " (" all ")"
}

# "eigenvalue.3.real", "final.top.omega.1 [rad/s]", "order.error.position", "initial.energy [J]".
function quantity(text,   part, n, which) {
    which = cells(text)
    sub(/ \[.*/, "", text)
    n = split(text, part, /[ ,;]+/)
    for (i = 1; i <= n; ++i) if (part[i] !~ /=/ && part[i] ~ /[.]/) text = part[i]
    n = split(text, part, ".")
    if (part[1] == "eigenvalue") return "$\\mathrm{" part_of[part[3]] "}\\,\\lambda_{" part[2] "}$"
    if (part[1] == "order") return "order of " part[3] (part[4] == "max" ? ", maximum" : "") which
    if (n < 4) return escaped(part[n]) which
    return "$" (part[3] == "omega" ? "\\omega" : part[3]) "_{" part[4] "}$ of the " (part[2] ~ /^mass/ ? "mass" : part[2]) which
}

# "meijaard2007, Table 2", "hull1972, enrightpryce1987", or words.
function source(text,   part, n) {
    n = split(text, part, /[,;] /)
    if (part[1] ~ /^IFToMM/) return "\\citep{gonzalez2006}, " escaped(part[n] ~ /A01/ ? "A01" : part[n])
    if (part[1] !~ /^[a-z]+[0-9]+$/) return escaped(part[1])
    return part[2] ~ /^[a-z]+[0-9]+$/ ? "\\citep{" part[1] "," part[2] "}" : n > 1 ? \
        "\\citep[" escaped(part[2]) "]{" part[1] "}" : "\\citep{" part[1] "}"
}

# Figures of the same shape are no numbers.
/,figure,/ { next }

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
