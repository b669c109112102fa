#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The man page of a program, from its own help: manual.sh PROGRAM VERSION DATE
set -eu

program=$1
awk_script=$(dirname -- "$0")/manual.awk

commands() { "$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p'; }

printf '.TH KREISEL 1 "%s" "kreisel %s" "User Commands"\n' "$3" "$2"
cat <<'EOT'
.SH NAME
kreisel \- testbed for Lie\-group integrators of constrained multibody systems
.SH SYNOPSIS
.B kreisel
.I COMMAND
[\fIOPTION\fR...] [\fIARGUMENT\fR...]
.SH DESCRIPTION
EOT
"$program" --help | awk -v part=about -f "$awk_script"
echo '.SH COMMANDS'
for command in $(commands); do
    "$program" "$command" --help | awk -v command="$command" -f "$awk_script"
done
echo '.SH EXIT STATUS'
"$program" --help | awk -v part=exit -f "$awk_script"
cat <<'EOT'
.SH ENVIRONMENT
.TP
.B KREISEL_EXPERIMENTS
The folder of the configs that are called by name.
.TP
.B KREISEL_PLOTS
The folder of the gnuplot scripts.
.TP
.B KREISEL_CACHE
The folder of reference solutions that all results share; empty: none.
By default
.I $XDG_CACHE_HOME/kreisel
or
.IR \(ti/.cache/kreisel .
.SH FILES
Below the prefix of an installation,
.I share/kreisel
holds
.I experiments
(configs),
.I plots
(gnuplot scripts),
.I python
(the Python package, for PYTHONPATH) and
.I schema.json
(the JSON Schema of configs).
.SH SEE ALSO
.BR gnuplot (1)
EOT
