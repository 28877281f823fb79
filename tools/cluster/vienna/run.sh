#!/usr/bin/env bash
# run.sh BUILDINGS.gpkg FLIGHTS.csv FOLDER [COUNT]: an hour of flights over Vienna (Metropolis-2), from
# its two files to departures at which every pair is proved to keep 32 m across or 7.62 m in height, and
# every flight out of the geofences of others.
# What stands in FOLDER already is left as it is, so that a run that was stopped goes on. The tools
# must be in PATH.
#   SLACK   how far boxes may reach outside a footprint, metres (1)
#   REACH   the longest edge of a roadmap, metres (0: none); with 60 it takes gigabytes and minutes
#   SHARDS  in how many shares paths and trajectories are made (8)
#   JOBS    how many at once (all cores)
#   DELAY   the longest wait, seconds, before a flight takes another way (120)
#   PATIENCE the longest wait of those that no way keeps apart within DELAY (600; geofences stand for up to 342)
#   IMPROVE rounds (20)
#   EPOCH   the instant from which the table's times count: it has no date (2026-01-01T00:00:00Z)
#   LAYERS  where flights cruise that would wait longer; several: one after another (70,7.8,6)
set -euo pipefail
buildings=$(realpath "$1")
flights=$(realpath "$2")
folder=$3
count=${4:-}
here=$(dirname "$(realpath "$0")")
slack=${SLACK:-1} reach=${REACH:-0} shards=${SHARDS:-8} jobs=${JOBS:-$(nproc)} delay=${DELAY:-120} patience=${PATIENCE:-600} improve=${IMPROVE:-20}
layers=${LAYERS:-70,7.8,6}
export EPOCH=${EPOCH:-2026-01-01T00:00:00Z}
mkdir -p "$folder"
cd "$folder"
mkdir -p shards
TIMEFORMAT='%R %U %S'

# made FILE COMMAND ...: runs it unless FILE is there, and notes seconds, of the wall and of the CPU.
made() {
  local file=$1
  shift
  [ -e "$file" ] && return
  { time "$@" 2>&3; } 3>&2 2>time.partial
  echo "$file seconds $(tail -1 time.partial)" >>times.txt
}
# answer COMMAND ...: exit codes 0 and 1 are both answers.
answer() {
  local code=0
  "$@" || code=$?
  [ $code -le 1 ] || exit $code
}
# shares KIND VEHICLE COMMAND ...: all shards of it, JOBS at once, then the records of all.
shares() {
  local kind=$1 vehicle=$2
  shift 2
  export -f answer
  seq "$shards" | xargs -P "$jobs" -I{} bash -c 'answer "$@"' share "$@" --threads 1 -q \
    --shard "{}/$shards" -o "shards/$kind.$vehicle.{}"
  answer skyway-join shards/"$kind.$vehicle".* -o "$kind.$vehicle.jsonl"
}
queries() { python3 "$here/flights.py" queries "$flights" . $count; }
blocks() {
  skyway-footprints "$buildings" --height-attribute bldg_h_max --slack "$slack" -q -o "$1" "${@:2}"
}
hull() {
  blocks blocks.boxmap --floor 0 --pad 0
  skyway-info blocks.boxmap >blocks.info
  skyway-query blocks.boxmap pads.jsonl --vehicle "$here/MP20.json" -q -o pads.metres
  python3 "$here/flights.py" bounds . >bounds.partial
  mv bounds.partial bounds.txt
}
city() { blocks city.boxmap --bounds="$(cat bounds.txt)"; }
roadmap() {
  skyway-roadmap city.boxmap --vehicle "$here/MP20.json" --margin 1 --reach "$reach" --threads "$jobs" -q -o city.roadmap
}
# Flights with a geofence choose their departures before all others: the fence opens as they arrive.
loiterers() {
  python3 "$here/flights.py" loiterers . trajectories.MP?0.jsonl >loiterers.partial
  answer skyway-fleet loiterers.partial --separation 32,7.62 --parked gone --max-delay "$delay" -q -o loiterers.jsonl
  rm loiterers.partial
}
fences() {
  python3 "$here/flights.py" fences .
  skyway-map patch city.boxmap --keep-out fences.geojson --epoch "$EPOCH" -o timed.boxmap
}
merged() {
  python3 "$here/flights.py" merge . trajectories.MP?0.jsonl "$@" >trajectories.partial
  mv trajectories.partial trajectories.jsonl
}
# departures NAME TRAJECTORIES SECONDS: into NAME.jsonl, with a report.
departures() {
  local name=$1
  answer skyway-fleet "$2" "${timed[@]}" "${others[@]}" --separation 32,7.62 --parked gone \
    --max-delay "$3" --improve "$improve" -q --stats "$name.stats.json" --report-file "$name.report.json" -o "$name.jsonl"
}
# Where some have no departure in time, all choose once more, and those that had none may wait longer.
rounds() {
  local round=1
  departures round-1 trajectories.jsonl "$delay"
  while [ "$(python3 "$here/flights.py" refused . $round)" != 0 ] && [ $round -lt 6 ]; do
    python3 "$here/flights.py" patient . "$delay" "$patience" >patient.jsonl
    rm round-$round.jsonl
    round=$((round + 1))
    departures round-$round patient.jsonl "$patience"
  done
  cp round-$round.report.json fleet.report.json
  mv round-$round.jsonl fleet.jsonl
}
together() {
  answer skyway-check "$map" fleet.jsonl --together --separation 32,7.62 --parked gone \
    --no-clearance -q -o together.jsonl
}

made order.txt queries
made bounds.txt hull
made city.boxmap city
with=()
if [ "$reach" != 0 ]; then
  made city.roadmap roadmap
  with=(--roadmap city.roadmap)
fi
others=()
for queries in queries.*.jsonl; do
  vehicle=${queries#queries.}
  vehicle=${vehicle%.jsonl}
  plan=(skyway-plan city.boxmap --queries "$queries" --vehicle "$here/$vehicle.json" --margin 1 --snap-ends 30)
  made "paths.$vehicle.jsonl" shares paths "$vehicle" "${plan[@]}" "${with[@]}"
  made "trajectories.$vehicle.jsonl" shares trajectories "$vehicle" skyway-traj city.boxmap \
    "paths.$vehicle.jsonl"
  for layer in $layers; do
    made "paths-$layer.$vehicle.jsonl" shares "paths-$layer" "$vehicle" "${plan[@]}" --layers "$layer"
    made "layers-$layer.$vehicle.jsonl" shares "layers-$layer" "$vehicle" skyway-traj city.boxmap \
      "paths-$layer.$vehicle.jsonl"
  done
done
for layer in $layers; do
  for file in "layers-$layer".MP?0.jsonl; do others+=(--alternatives "$file"); done
done
map=city.boxmap timed=() pinned=()
if [ -s geofences.jsonl ]; then
  made loiterers.jsonl loiterers
  made timed.boxmap fences
  map=timed.boxmap timed=(--map timed.boxmap) pinned=(pinned.jsonl)
fi
made trajectories.jsonl merged "${pinned[@]}"
made fleet.jsonl rounds
made together.jsonl together
python3 "$here/flights.py" summary .
