#!/usr/bin/env bash
# step.sh FOLDER STEP [K]: one step of the chain that FOLDER/chain.conf describes, for its K-th shard.
# Steps: map, lattice, roadmap, paths, trajectories, reports (by shards), join-lattice and so on, summary.
# Answers of "no" (a path not found) are no failure here: the summary counts them.
set -euo pipefail
cd "$1"
step=$2
k=${3:-}
# shellcheck source=tools/cluster/chain.conf
source chain.conf
mkdir -p shards log
begin=$EPOCHREALTIME

# answer COMMAND ...: exit codes 0 and 1 are both answers.
answer() {
  local code=0
  "$@" -q || code=$?
  [ $code -le 1 ] || exit $code
}
# One shard of the step's N (in a variable).
shard() {
  local count=$1
  shift
  answer "$@" --shard "$k/$count" -o "shards/$step.$k"
}
# All shards of a kind, in an order that does not matter.
join() {
  local kind=$1 count=$2 output=$3 files=()
  for ((i = 1; i <= count; ++i)); do files+=("shards/$kind.$i"); done
  answer skyway-join --threads 1 "${files[@]}" -o "$output"
}

# The words of chain.conf are split into options on purpose.
# shellcheck disable=SC2086
case $step in
  map) $MAP -q -o city.boxmap ;;
  lattice) shard "$LATTICE_SHARDS" skyway-lattice city.boxmap --threads 1 --vehicle "$VEHICLE" $LATTICE ;;
  roadmap) shard "$ROADMAP_SHARDS" skyway-roadmap city.boxmap --threads 1 --vehicle "$VEHICLE" $ROADMAP ;;
  paths) shard "$PATH_SHARDS" skyway-plan city.boxmap --threads 1 --lattice city.lattice --roadmap city.roadmap \
    --queries "$QUERIES" --vehicle "$VEHICLE" $PLAN ;;
  trajectories) shard "$TRAJECTORY_SHARDS" skyway-traj city.boxmap paths.jsonl --threads 1 --vehicle "$VEHICLE" $TRAJECTORIES ;;
  reports) shard "$REPORT_SHARDS" skyway-check city.boxmap trajectories.jsonl $CHECK ;;
  join-lattice) join lattice "$LATTICE_SHARDS" city.lattice ;;
  join-roadmap) join roadmap "$ROADMAP_SHARDS" city.roadmap ;;
  join-paths) join paths "$PATH_SHARDS" paths.jsonl ;;
  join-trajectories) join trajectories "$TRAJECTORY_SHARDS" trajectories.jsonl ;;
  join-reports) join reports "$REPORT_SHARDS" reports.jsonl ;;
  summary)
    for file in paths trajectories reports; do skyway-info "$file.jsonl"; done
    echo "step shards seconds longest"
    for timed in log/*.seconds; do
      name=${timed#log/}
      echo "${name%%.*} $(cat "$timed")"
    done | awk '{n[$1]++; s[$1] += $2; if ($2 > m[$1]) m[$1] = $2}
      END {for (k in n) printf "%s %d %.2f %.2f\n", k, n[k], s[k], m[k]}' | sort
    ;;
  *)
    echo "step.sh: no such step: $step" >&2
    exit 2
    ;;
esac
awk -v a="$begin" -v b="$EPOCHREALTIME" 'BEGIN {printf "%.3f\n", b - a}' >"log/$step.${k:-all}.seconds"
