# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2154
# What follows the settings in the submit.sh that `kreisel slurm` writes.

set -euo pipefail
shopt -s inherit_errexit  # sbatch is called in $(...)

# Cells and references that are there. Lines of interrupted cells are no results. Before the first there is no file, and
# grep, which still prints 0, ends with 1: that is a count, and no failure.
achieved() {
    local part=".${SLURM_ARRAY_TASK_ID:-}-of-$parts"
    [[ $parts -gt 1 ]] || part=
    cat "$folder/journal$part.jsonl" "$folder"/references/*.json 2>/dev/null |
        grep -vc '"status":"interrupted"' || true
}

# After a signal: starts this job again, in its place in the queue, while it gets on, and else three times. A job that
# is not running any more, to Slurm, is cancelled or lost, and not ours to start.
start_again() {
    local id=${SLURM_ARRAY_JOB_ID:+${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID}
    id=${id:-$SLURM_JOB_ID}
    if [[ $(achieved) -le $1 && ${SLURM_RESTART_COUNT:-0} -ge 3 ]]; then
        echo "job $id: nothing was completed since it started: it needs more time or memory" >&2
    elif [[ -n $(squeue --noheader --states=RUNNING --jobs="$id" 2>/dev/null) ]]; then
        echo "job $id: goes on in a new run" >&2
        scontrol requeue "$id" && sleep 60  # Slurm ends this shell
    fi
}

# compute NAME ARGUMENT...: what kreisel run does with these arguments, once what a lost node may still compute of it
# is at an end. The signal that announces the time limit comes to this shell, which passes it on. kreisel ends with this
# shell: not every Slurm finds what a killed shell has left.
compute() {
    local code=0 child before memory
    before=$(achieved)
    memory=${SLURM_MEM_PER_NODE:-$((${SLURM_MEM_PER_CPU:-0} * ${SLURM_CPUS_ON_NODE:-1}))}  # MB; 0: no limit is told
    [[ $memory -eq 0 ]] || limits+=(--max-memory "$((memory * 8 / 10))MB")
    flock --no-fork "$folder/slurm/$1.lock" "$kreisel" run "$folder/config.json" -o "$folder" --resume \
        --with-parent -j "${SLURM_CPUS_PER_TASK:-1}" "${limits[@]}" "${@:2}" &
    child=$!
    # The child may have ended by itself when the signal comes: its exit code is what counts, below.
    trap 'kill -TERM "$child" 2>/dev/null || true' TERM
    while
        code=0
        wait "$child" || code=$?
        kill -0 "$child" 2>/dev/null
    do :; done
    [[ $code -lt 128 ]] || start_again "$before"
    [[ $code -ne 1 ]] || code=0  # some cells failed, which is a result
    exit "$code"
}

# What the killed shell of a task or a lost node has left running writes to the folder until it is ended too.
put_together() {
    local code=0 part
    for ((part = 1; part <= parts; ++part)); do
        flock --nonblock "$folder/slurm/part-$part.lock" true || echo "waiting for part $part, which still computes" >&2
        flock "$folder/slurm/part-$part.lock" true
    done
    "$kreisel" merge "$folder" || code=$?
    [[ $code -le 1 ]] || { printf 'go on with: bash %q\n' "$folder/submit.sh" >&2; exit "$code"; }
    exit 0
}

case ${1:-} in
    references) compute references --references-only ;;
    part) compute "part-$SLURM_ARRAY_TASK_ID" --shard "$SLURM_ARRAY_TASK_ID/$parts" ;;
    merge) put_together ;;
esac

# submit JOB LOG OPTION...: one of the above as a job. Prints its number.
submit() {
    local id
    id=$(sbatch --parsable --chdir="$folder" --job-name="kreisel:$name" --requeue --open-mode=append \
        --signal=B:TERM@60 "${options[@]}" --output="${folder//%/%%}/slurm/$2.log" "${@:3}" "${extra[@]}" \
        "$folder/submit.sh" "$1")
    echo "${id%%;*}" | tee -a "$folder/slurm/jobs"
}

extra=("$@")
command -v sbatch >/dev/null || { echo 'submit.sh: there is no sbatch here: submit on a machine of the cluster' >&2; exit 3; }
mkdir -p "$folder/slurm"
if [[ -s $folder/slurm/jobs ]]; then
    jobs=$(paste -sd , "$folder/slurm/jobs")
    # squeue fails where it has forgotten all of them: then none is queued.
    queued=$(squeue --noheader --format=%i --jobs="$jobs" 2>/dev/null | paste -sd ' ' || true)
    [[ -z $queued ]] || { echo "submit.sh: jobs of this folder are still queued or running: $queued" >&2; exit 3; }
fi
: >"$folder/slurm/jobs"
after=()
if [[ $references -gt 0 ]]; then
    job=$(submit references references)
    echo "references: job $job"
    after=(--dependency="afterany:$job")
fi
job=$(submit part part-%a --array="1-$parts" "${after[@]}")
echo "parts: job $job, 1 to $parts"
job=$(submit merge merge --cpus-per-task=1 --dependency="afterany:$job")
echo "merge: job $job; its log, slurm/merge.log, says whether all is there"
