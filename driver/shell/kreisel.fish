# SPDX-License-Identifier: BSD-3-Clause
# Completion of kreisel's command line in fish. Commands, options and names are asked from the program.

# Rows `  NAME   text` on stdin as NAME, a tab and the text; an option of several names as several.
function __kreisel_rows
    awk '/^  [^ ]/ {
        count = split($1, names, ",")
        sub(/^  [^ ]+ */, "")
        for (i = 1; i <= count; ++i) { print names[i] "\t" $0 }
    }'
end

function __kreisel_topics
    $argv[1] list --help | sed -n 's/.*{\([a-z,]*\)}.*/\1/p' | tr , '\n'
end

# The rows of a part of the help of a command, by default of the program.
function __kreisel_help -a program part command
    $program $command --help | sed -n "/^$part:/,/^\$/p"
end

# What an argument or an option may be, where the help of the command lists that in braces.
function __kreisel_values -a program command what
    $program $command --help | sed -n "s/^  \(.*,\)\?$what [A-Z]*:{\([a-z,]*\)}.*/\2/p" | tr , '\n'
end

# What an argument, by its name in the help, or the value of an option may be.
function __kreisel_candidates -a program command what
    switch $what
        case config
            $program list configs | __kreisel_rows
            __fish_complete_suffix .json
        case method
            $program list methods | __kreisel_rows
        case name
            for topic in (__kreisel_topics $program | grep -vx configs)
                $program list $topic | __kreisel_rows
            end
        case --table
            $program list tables | __kreisel_rows
        case --figure
            __fish_complete_suffix .json
        case folder A B --references
            __fish_complete_directories (commandline -ct)
        case --family
            $program list methods | __kreisel_rows | sed 's|/.*||' | sort -u
        case -o --output --csv
            __fish_complete_path (commandline -ct)
        case '*'
            __kreisel_values $program $command $what
    end
end

function __kreisel
    set -l words (commandline -opc)
    set -l current (commandline -ct)
    set -l program (string replace -r '^~' $HOME -- $words[1])
    set -l command $words[2]
    if test (count $words) -eq 1
        __kreisel_help $program Subcommands | __kreisel_rows
        __kreisel_help $program Options | __kreisel_rows
    else if test $words[-1] = --filter; and string match -q '*=*' -- $current
        set -l axis (string split -m 1 = -- $current)[1]
        $program list $axis 2>/dev/null | __kreisel_rows | sed "s/^/$axis=/"
    else if string match -q -- '-*' $words[-1]
        and __kreisel_help $program Options $command | grep -Eq -- "^  (.*,)?$words[-1](,[^ ]*)? [A-Z]+\b"
        __kreisel_candidates $program $command $words[-1]
    else if string match -q -- '-*' $current
        __kreisel_help $program Options $command | __kreisel_rows
    else
        set -l argument (__kreisel_help $program Positionals $command | __kreisel_rows)[1]
        __kreisel_candidates $program $command (string split \t -- $argument)[1]
    end
end

complete -c kreisel -f -a '(__kreisel)'
