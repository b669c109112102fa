# SPDX-License-Identifier: BSD-3-Clause
# A section of the man page from the help of a command: awk -v command=NAME -f manual.awk. Without a command, what the
# program says of itself (part=about) or of exit codes (part=exit).

function roff(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    return text ~ /^[.']/ ? "\\&" text : text
}

# In lines of less than 80 characters, none of which looks like a request.
function say(text,    words, count, i, line) {
    count = split(text, words, " ")
    line = words[1]
    for (i = 2; i <= count; ++i) {
        if (length(line) + length(words[i]) > 77) {
            print roff(line)
            line = words[i]
        } else {
            line = line " " words[i]
        }
    }
    print roff(line)
}

# The name of an option or an argument in bold, what it takes and excludes after it.
function item(text,    words, i, line, count) {
    print ".TP"
    count = split(text, words, " ")
    line = "\\fB" roff(words[1]) "\\fR"
    for (i = 2; i <= count; ++i) { line = line " " roff(words[i]) }
    print line
}

/^Exit codes:/ {
    in_exit = 1
    sub(/^Exit codes: */, "")
}
in_exit {
    exit_text = exit_text (exit_text == "" ? "" : " ") $0
    next
}
/^(Options|Positionals|Subcommands):$/ {
    section = $1
    next
}
section == "Subcommands:" { next }
part == "about" {
    if (/^Usage:/) { exit }
    if (!/^kreisel:/) {
        if (told++) { print ".PP" }
        say($0)
    }
    next
}
part == "exit" || command == "" { next }
/^Usage:/ {
    print ".PP\n\\fB" roff(substr($0, 8)) "\\fR"
    next
}
NR == 1 {
    print ".SS " roff(command)
    say($0 ".")
    next
}
/^  [^ ]/ {
    text = substr($0, 3)
    if (match(text, /   */)) {
        item(substr(text, 1, RSTART - 1))
        say(substr(text, RSTART + RLENGTH))
    } else {
        item(text)
    }
    next
}
/^ +[^ ]/ {
    say($0)
    next
}
/^$/ { open = 0 }
# A paragraph, whose lines follow each other.
/^[^ ]/ {
    if (!open++) { print ".PP" }
    say($0)
}

END {
    if (part != "exit") { exit }
    count = split(exit_text, codes, /; /)
    for (i = 1; i <= count; ++i) {
        sub(/[.;] *$/, "", codes[i])
        match(codes[i], /^[0-9]+ /)
        print ".TP\n\\fB" substr(codes[i], 1, RLENGTH - 1) "\\fR"
        say(substr(codes[i], RLENGTH + 1))
    }
}
