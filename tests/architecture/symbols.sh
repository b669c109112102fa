#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# usage: symbols.sh OBJECTS-IN-DOUBLE... -- OBJECTS-IN-QUAD...
# The two object sets are linked into one program. What both of them define under one name is merged by the linker, and
# one precision would silently run the other's code. So nothing of namespace kreisel may be in both but what knows no
# `Real`: the plain data that cross between driver and numerics, and what is named below.
set -euo pipefail

shared=(
    Cell Column ConstraintSummary Cost Eigenvalue Engine Linearisation LostIntegral MotionPart Number             # engine.hpp
    Outcome Reference ReferenceCheck ReferenceSample ReportedBody ReportedReaction ReportedState SchemeRow SystemSummary
    BodyGeometry Geometry LinkGeometry                          # engine/geometry.hpp
    MetricDescription integral_suffixes                         # engine/metrics/description.hpp
    matches matches_any brief_text                              # support/pattern.hpp, support/number_text.hpp: texts
    Status name                                                 # lie/status.hpp: an enumeration, and texts
    BodyData ForceData JointData ParameterError                 # mechanics/model/data.hpp
    ElementKey ElementType                                      # mechanics/parts/keys.hpp
    FreeMotion JointKind JointRecipe JointRow JointType Primitive                  # mechanics/parts/joint_type.hpp
    Elimination eliminate                                       # mechanics/blocks/elimination.hpp: the joint graph
    MethodDescription OptionDescription OptionError Order ProjectionDescription with_defaults # methods/contract/description.hpp
    Coefficient Tableau                                                                           # methods/tableaus/tableau.hpp
    FormulationDescription IntegralDescription ParameterDescription ParameterKind ProblemDescription # problems/description.hpp
)

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Names that the objects define for the linker: all but local ones. CMake counts precompiled headers (.gch) among
# objects; they are left out because the linker never sees them, and nm cannot read them.
symbols() {
    printf '%s\0' "$@" | grep -zv '[.]gch$' | xargs -0 nm --demangle --defined-only |
        sed -nE 's/^[0-9a-f]+ [A-Zuvw] //p' | LC_ALL=C sort -u
}

# merged DOUBLE QUAD: the names in both lists that mention something of kreisel that is not shared.
merged() {
    local allowed
    allowed=$(IFS='|'; echo "${shared[*]}")
    LC_ALL=C comm -12 "$1" "$2" | perl -ne "print if /\\bkreisel::(?!(?:$allowed)\\b)/"
}

double=()
while [[ $# -gt 0 && $1 != -- ]]; do double+=("$1"); shift; done
shift
symbols "${double[@]}" > "$scratch/double"
symbols "$@" > "$scratch/quad"
for precision in double:binary64 quad:binary128; do
    if ! grep -q "^kreisel::${precision#*:}::" "$scratch/${precision%:*}"; then
        echo "no symbol of ${precision#*:} among the ${precision%:*} objects: the test looks in the wrong place"
        exit 1
    fi
done

# Control: a function outside the inline namespace, in both sets, must be found, and nothing of plain data beside it.
echo 'namespace kreisel { struct Number; double mean(const Number*, double x) { return x; } }
      namespace kreisel { struct Number { Number(); }; Number::Number() {} }' |
    "${CXX:-c++}" -x c++ -c -o "$scratch/control.o" -
symbols "$scratch/control.o" > "$scratch/control"
found=$(merged "$scratch/control" "$scratch/control")
if [[ $found != 'kreisel::mean(kreisel::Number const*, double)' ]]; then
    echo "control: expected kreisel::mean alone to be turned down, got: $found"
    exit 1
fi

found=$(merged "$scratch/double" "$scratch/quad")
if [[ -n $found ]]; then
    echo "defined in both precisions, outside the inline namespace:"
    echo "$found"
    exit 1
fi
