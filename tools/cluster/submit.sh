#!/usr/bin/env bash
# submit.sh FOLDER [SBATCH-OPTION ...]: the chain of FOLDER/chain.conf as jobs of Slurm; prints the number of the last one.
# FOLDER and the tools (PATH) must be seen by all nodes. Shards that are done already cost nothing: to go on after
# whatever went wrong, submit again.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
folder=$(readlink -f "$1")
shift
cd "$folder"
source chain.conf
mkdir -p log

# submit STEP SHARDS DEPENDENCIES: prints the job's number. SHARDS of 0: one job, no array.
submit() {
  local step=$1 shards=$2 after=$3
  shift 3
  local seconds megabytes log=$folder/log/$step.log
  read -r seconds megabytes < <("$here/cost.sh" "$folder" "$step")
  local options=(--parsable --requeue --job-name="skyway-$step" --cpus-per-task=1 --open-mode=append
    --time=$((seconds / 60 + 5)) --mem="${megabytes}M")
  [ "$shards" -eq 0 ] || { options+=(--array="1-$shards"); log=$folder/log/$step.%a.log; }
  [ -z "$after" ] || options+=(--dependency="afterok:$after")
  sbatch "${options[@]}" --output="$log" "$@" --wrap "exec '$here/job.sh' '$folder' $step"
}

# Whether there is a map, and neither chain.conf nor a file that its command names is newer.
map_is_made() {
  local word
  # shellcheck disable=SC2086 # the words of the command
  for word in chain.conf $MAP; do
    [ ! -e "$word" ] || [ city.boxmap -nt "$word" ] || return 1
  done
}

# Later steps are asked for by what is in the map: it comes first.
map_is_made || submit map 0 "" --wait "$@" >/dev/null
lattice=$(submit lattice "$LATTICE_SHARDS" "" "$@")
roadmap=$(submit roadmap "$ROADMAP_SHARDS" "" "$@")
lattice=$(submit join-lattice 0 "$lattice" "$@")
roadmap=$(submit join-roadmap 0 "$roadmap" "$@")
job=$(submit paths "$PATH_SHARDS" "$lattice:$roadmap" "$@")
job=$(submit join-paths 0 "$job" "$@")
job=$(submit trajectories "$TRAJECTORY_SHARDS" "$job" "$@")
job=$(submit join-trajectories 0 "$job" "$@")
job=$(submit reports "$REPORT_SHARDS" "$job" "$@")
job=$(submit join-reports 0 "$job" "$@")
submit summary 0 "$job" "$@"
