#!/usr/bin/env bash
# run.sh BIN_DIR SOURCE_DIR: the chain over a made-up city of 100,000 boxes as jobs of a Slurm of three nodes on this
# machine, one of which dies with all it runs, and a running job killed besides, gives the bytes of a single run.
# With NODES=1 or NODES=3 it measures instead: nothing dies, and so many nodes work.
set -euo pipefail
export PATH="$1:$PATH"
source=$2
source "$source/tests/cluster/slurm.sh"
slurm_installed || { echo "skipped: slurm-wlm and munge are not installed"; exit 77; }

folder=$(mktemp -d /tmp/skyway-cluster.XXXXXX)
finish() {
  code=$?
  trap - EXIT
  [ $code -eq 0 ] || tail -n 5 "$folder"/{many/log/*.log,log/*.log} >&2 || true
  slurm_down "$folder" || true
  cd /
  [ -n "${KEEP:-}" ] || rm -rf "$folder" 2>/dev/null || { sleep 1; rm -rf "$folder"; }
  exit $code
}
trap finish EXIT
seconds_since() { awk -v a="$1" -v b="$EPOCHREALTIME" 'BEGIN {printf "%.1f", b - a}'; }

# The work, for both.
mkdir "$folder/one" "$folder/many"
cd "$folder/one"
cat >chain.conf <<'CONF'
MAP="skyway-import city.csv"
QUERIES="queries.jsonl"
QUERY_COUNT="60"
VEHICLE="box:1,1,1"
LATTICE="--spacing 10 --connect 26"
ROADMAP="--reach 40"
PLAN="--snap-ends 30"
TRAJECTORIES="--vmax 8 --amax 6 --solver stop-and-go"
CHECK=""
LATTICE_SHARDS="3"
ROADMAP_SHARDS="9"
PATH_SHARDS="3"
TRAJECTORY_SHARDS="3"
REPORT_SHARDS="3"
CONF
skyway-synth --seed 1 --size 4100 -o city.csv
awk 'BEGIN {srand(5); for (i = 1; i <= 60; ++i) {
  x = (rand() - 0.5) * 3600; y = (rand() - 0.5) * 3600; a = rand() * 6.283; l = 50 + rand() * 250
  printf "{\"id\":\"q%d\",\"from\":[%.3f,%.3f,%.3f],\"to\":[%.3f,%.3f,%.3f]}\n", i, x, y, 2 + rand() * 20,
    x + l * cos(a), y + l * sin(a), 2 + rand() * 20}}' >queries.jsonl
cp ./* ../many

# One process a step.
single() {
  # shellcheck disable=SC2086
  {
    source chain.conf
    $MAP -q -o city.boxmap
    skyway-lattice city.boxmap --vehicle "$VEHICLE" $LATTICE -o city.lattice
    skyway-roadmap city.boxmap --vehicle "$VEHICLE" $ROADMAP -o city.roadmap
    skyway-plan city.boxmap --lattice city.lattice --roadmap city.roadmap --queries "$QUERIES" --vehicle "$VEHICLE" \
      $PLAN -o paths.jsonl || [ $? -eq 1 ]
    skyway-traj city.boxmap paths.jsonl --vehicle "$VEHICLE" $TRAJECTORIES -o trajectories.jsonl || [ $? -eq 1 ]
    skyway-check city.boxmap trajectories.jsonl -o reports.jsonl || [ $? -eq 1 ]
  } 2>/dev/null
}
begin=$EPOCHREALTIME
single
echo "one run: $(seconds_since "$begin") s"

slurm_up "$folder"
[ "${NODES:-3}" -eq 3 ] || scontrol update "NodeName=node[2-3]" State=DRAIN Reason=measured
cd "$folder/many"
"$source/tools/cluster/step.sh" . map  # so that all jobs are submitted at once
begin=$EPOCHREALTIME
last=$("$source/tools/cluster/submit.sh" .)

# Waits until a roadmap shard is at work on the node, and stops it, so that it is not done before it is killed; gives the
# tool's process.
tool_on() {
  local node=$1 pid end=$((SECONDS + 60))
  while ((SECONDS < end)); do
    for pid in $(job_pids "$folder" "$node"); do
      [ "$(cat "/proc/$pid/comm" 2>/dev/null)" = skyway-roadmap ] || continue
      kill -STOP "$pid" 2>/dev/null || continue
      # On a busy machine it takes a while to stop. One that was left behind like this would never end.
      for _ in $(seq 200); do
        grep -qs "^State:.T" "/proc/$pid/status" && echo "$pid" && return
        kill -0 "$pid" 2>/dev/null || break
        sleep 0.05
      done
    done
    sleep 0.1
  done
  echo "no job came to $node" >&2
  return 1
}
if [ -z "${NODES:-}" ]; then
  tool_on node2 >/dev/null
  for pid in $(node_pids "$folder" node2); do kill -9 "$pid" 2>/dev/null || true; done
  echo "killed node2 and its job after $(seconds_since "$begin") s"
  kill -9 "$(tool_on node1)"
  echo "killed a job on node1 after $(seconds_since "$begin") s"
fi

for _ in $(seq 900); do
  state=$(squeue -h -j "$last" -o "%T %r" 2>/dev/null || true)
  [ -n "$state" ] || break
  [[ $state != *Never* ]] || { echo "the last job will never run" >&2; squeue >&2; exit 1; }
  sleep 0.2
done
[ -z "$state" ] || { echo "not done in time: $state" >&2; squeue >&2; exit 1; }
echo "${NODES:-3} node(s): $(seconds_since "$begin") s"
cat log/summary.log

for file in city.boxmap city.lattice city.roadmap paths.jsonl trajectories.jsonl reports.jsonl; do
  cmp "../one/$file" "$file"
done
grep -q '"ok":true' reports.jsonl
left=$(find . -name '*.part')
[ -z "$left" ] || { echo "left half-written: $left" >&2; exit 1; }
for shard in shards/*; do skyway-info --verify "$shard" >/dev/null; done
if [ -z "${NODES:-}" ]; then
  # Both may have been the same job.
  [ "$(cat log/*.log | grep -c "restart [1-9]")" -ge 2 ] || { echo "a job was not started again" >&2; exit 1; }
fi
echo "same bytes"
