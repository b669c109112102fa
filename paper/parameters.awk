# SPDX-License-Identifier: BSD-3-Clause
#
# Rows of the table of parameters, from what `kreisel info PROBLEM` prints. Lists of bodies, joints and forces are left out.

function escaped(text) {
    gsub(/[&%#_$]/, "\\\\&", text)
    gsub(/<=/, "$\\le$", text)
    gsub(/</, "$<$", text)
    gsub(/>/, "$>$", text)
    while (match(text, /\^[-0-9]+/))
        text = substr(text, 1, RSTART - 1) "$\\sp{" substr(text, RSTART + 1, RLENGTH - 1) "}$" substr(text, RSTART + RLENGTH)
    return text
}

NR == 1 {
    name = substr($0, 1, index($0, ":") - 1)
    summary = substr($0, index($0, ":") + 2)
    printf "\\problemrow{%s}{%s}\n", escaped(name), escaped(summary)
}

/^[^ ]/ { listed = /^Parameters/ }

listed && /^  [^ ]/ && match($0, /\(default .*\)$/) {
    value = substr($0, RSTART + 9, RLENGTH - 10)
    if (value ~ /^\[\{/ || value == "[]") next
    meaning = substr($0, 1, RSTART - 1)
    sub(/^ +[^ ]+ +/, "", meaning)
    end = index(meaning, "]: ")
    meaning = end ? substr(meaning, 1, end) : substr(meaning, 1, index(meaning, ": ") - 1)
    gsub(/,/, ", ", value)
    printf "\\parameterrow{%s}{%s}{%s}\n", escaped($1), escaped(meaning), escaped(value)
}
