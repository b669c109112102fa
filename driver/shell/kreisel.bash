# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Completion of kreisel's command line in bash. Commands, options and names are asked from the program.

# What rows of a list or a help, `  NAME   text`, begin with.
_kreisel_rows() { sed -n 's/^  \([^ ]*\).*/\1/p'; }

_kreisel_topics() { "$kreisel" list --help | sed -n 's/.*{\([a-z,]*\)}.*/\1/p' | tr , '\n'; }

_kreisel_names() { "$kreisel" list "$1" | _kreisel_rows; }

# The rows of a part of the help of the command, by default of the program.
_kreisel_help() { "$kreisel" ${2:+"$2"} --help | sed -n "/^$1:/,/^\$/p"; }

_kreisel_options() { _kreisel_help Options "$1" | _kreisel_rows | tr , '\n'; }

# What an argument or an option may be, where the help of the command lists that in braces.
_kreisel_values() {
    "$kreisel" "$command" --help | sed -n "s/^  \(.*,\)\?$1 [A-Z]*:{\([a-z,]*\)}.*/\2/p" | tr , '\n'
}

# What an argument, by its name in the help, or the value of an option may be.
_kreisel_candidates() {
    case $1 in
        config) _kreisel_names configs ;;
        method) _kreisel_names methods ;;
        name) _kreisel_topics | grep -vx configs | while read -r topic; do _kreisel_names "$topic"; done ;;
        --family) _kreisel_names methods | sed 's|/.*||' ;;
        --table) _kreisel_names tables ;;
        *) _kreisel_values "$1" ;;
    esac
}

_kreisel_files() {
    case $1 in
        config | --figure) compgen -d -- "$cur"; compgen -f -X '!*.json' -- "$cur" ;;
        folder | A | B | --references) compgen -d -- "$cur" ;;
        -o | --output | --csv) compgen -f -- "$cur" ;;
    esac
}

_kreisel_matching() {
    local word
    while read -r word; do [[ $word != "$cur"* ]] || printf '%s\n' "$word"; done
}

_kreisel() {
    local kreisel=${COMP_WORDS[0]/#\~/$HOME} command=${COMP_WORDS[1]} cur=${COMP_WORDS[COMP_CWORD]}
    local previous=${COMP_WORDS[COMP_CWORD - 1]} what='' words
    if [[ $COMP_CWORD -eq 1 ]]; then
        words=$(_kreisel_help Subcommands | _kreisel_rows; _kreisel_options '')
    elif [[ $cur == '=' || $previous == '=' ]]; then  # AXIS=NAME, which bash takes apart
        [[ $cur != '=' ]] || { cur=''; what=$previous; }
        words=$(_kreisel_names "${what:-${COMP_WORDS[COMP_CWORD - 2]}}")
        what=''
    elif [[ $previous == -* ]] && _kreisel_help Options "$command" | grep -Eq -- "^  (.*,)?$previous(,[^ ]*)? [A-Z]+\b"
    then
        what=$previous
    elif [[ $cur == -* ]]; then
        words=$(_kreisel_options "$command")
    else
        what=$(_kreisel_help Positionals "$command" | _kreisel_rows | head -n 1)
    fi 2>/dev/null
    [[ -z $what ]] || words=$(_kreisel_candidates "$what")
    mapfile -t COMPREPLY < <({ _kreisel_matching <<<"$words"; _kreisel_files "$what"; } | sed '/^$/d' | sort -u)
    [[ -z $(_kreisel_files "$what") ]] || compopt -o filenames 2>/dev/null
}

complete -F _kreisel kreisel
