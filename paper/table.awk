# SPDX-License-Identifier: BSD-3-Clause
#
# Shared by the scripts of tables: fields of CSV, cells of LaTeX. Read before each of them (awk -f table.awk -f other.awk).

# Splits a line of CSV into field[1..], quotes taken off; returns their number.
function fields_of(line, field,   n, quoted, i, c) {
    split("", field); n = 1
    for (i = 1; i <= length(line); ++i) {
        c = substr(line, i, 1)
        if (c == "\"") quoted = !quoted
        else if (c == "," && !quoted) ++n
        else field[n] = field[n] c
    }
    return n
}

# at[title] of the columns, a unit in brackets left out.
function read_titles(line,   field, n, i) {
    n = fields_of(line, field)
    for (i = 1; i <= n; ++i) { sub(/ \[.*/, "", field[i]); at[field[i]] = i }
}

function escaped(text) {
    sub(/^'/, "", text)  # of spreadsheets
    gsub(/[&%#_$]/, "\\\\&", text)
    return text
}

# To three digits: 1234.5 as 1230, 0.0000123 with a power of ten.
function rounded(x,   text, part) {
    text = sprintf("%.3g", x)
    if (x >= 1000 && x < 1e7) return sprintf("$%d$", text)
    if (text !~ /e/) return "$" text "$"
    split(text, part, "e")
    return "$" part[1] "\\cdot10^{" (part[2] + 0) "}$"
}
