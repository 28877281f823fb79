#!/usr/bin/env bash
# run.sh BIN_DIR TABLE: the chain gives the same bytes with 1, 2 and 7 threads, in shards, and without vector instructions.
set -euo pipefail
export PATH="$1:$PATH"
table=$2
vehicle=$(dirname "$table")/vehicles/quad2kg.json
sites=$(dirname "$table")/samples/sites.geojson
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
skyway-import -q "$table" -o map
for i in 1 2 3 4 5 6 7 8 9; do
  echo "{\"id\":\"q$i\",\"from\":[-4${i}0,-30$i,6],\"to\":[3${i}0,2${i}4,9]}"
done > queries
for threads in 1 2 7; do
  skyway-import -q "$table" --threads $threads -o map.$threads
  skyway-lattice map --spacing 10 --connect 26 --vehicle box:0.5,0.5,0.3 --threads $threads -o lattice.$threads
  skyway-plan map --lattice lattice.$threads --queries queries --vehicle box:0.5,0.5,0.3 --snap-ends 30 \
    --threads $threads -o paths.$threads || [ $? -eq 1 ]
  skyway-replan map paths.$threads --margin 1 --threads $threads -o replanned.$threads || [ $? -eq 1 ]
  skyway-traj map paths.$threads --vmax 8 --amax 6 --solver stop-and-go -o trajectories.$threads || [ $? -eq 1 ]
  skyway-render -q map trajectories.$threads --rate 0.2 --shadows --threads $threads -o video.$threads.y4m
  skyway-check map trajectories.$threads --threads $threads -o reports.$threads || [ $? -eq 1 ]
  skyway-plan map --home "$sites" trajectories.$threads --threads $threads -q -o home.$threads || [ $? -eq 1 ]
  skyway-fleet trajectories.$threads --separation 12,4 --parked gone --improve 5 --threads $threads -q -o fleet.$threads \
    --report-file delays.$threads || [ $? -eq 1 ]
  skyway-fly trajectories.$threads --vehicle "$vehicle" --wind 3,1,0 --gusts 3 --noise 0.01,0.05,0.5,1 --mass-error 0.1 \
    --runs 9 --log-rate 10 --threads $threads -o log.$threads --report-file flights.$threads || [ $? -eq 1 ]
done
for kind in map lattice paths replanned trajectories reports home fleet delays log flights; do
  cmp $kind.1 $kind.2
  cmp $kind.1 $kind.7
done
cmp video.1.y4m video.2.y4m
cmp video.1.y4m video.7.y4m
# Shards, joined in another order than theirs, are what one run gives; and once done, they are left alone.
sharded() {
  local kind=$1 k
  shift
  for k in 1 2 3; do "$@" --shard "$k/3" -q -o "$kind.shard.$k" || [ $? -eq 1 ]; done
  stat -c %i "$kind".shard.* >before
  for k in 1 2 3; do "$@" --shard "$k/3" -q -o "$kind.shard.$k" || [ $? -eq 1 ]; done
  stat -c %i "$kind".shard.* | cmp - before
  skyway-join "$kind".shard.{3,1,2} -o "$kind.joined" || [ $? -eq 1 ]
  cmp "$kind.joined" "$kind.1"
}
skyway-roadmap map --reach 50 --vehicle box:0.5,0.5,0.3 -o roadmap.1
sharded lattice skyway-lattice map --spacing 10 --connect 26 --vehicle box:0.5,0.5,0.3
sharded roadmap skyway-roadmap map --reach 50 --vehicle box:0.5,0.5,0.3
sharded paths skyway-plan map --lattice lattice.1 --queries queries --vehicle box:0.5,0.5,0.3 --snap-ends 30
sharded trajectories skyway-traj map paths.1 --vmax 8 --amax 6 --solver stop-and-go
sharded log skyway-fly trajectories.1 --vehicle "$vehicle" --wind 3,1,0 --gusts 3 --noise 0.01,0.05,0.5,1 --mass-error 0.1 --log-rate 10
sharded reports skyway-check map trajectories.1
sharded home skyway-plan map --home "$sites" trajectories.1
# As on a processor without vector instructions.
on_any_processor() {
  local kind=$1
  shift
  "$@" -q -o "$kind.here" || [ $? -eq 1 ]
  GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-AVX512F "$@" -q -o "$kind.elsewhere" || [ $? -eq 1 ]
  cmp "$kind.here" "$kind.elsewhere"
}
on_any_processor map skyway-import "$table"
on_any_processor lattice skyway-lattice map --spacing 10 --connect 26 --vehicle box:0.5,0.5,0.3
on_any_processor roadmap skyway-roadmap map --reach 50 --vehicle box:0.5,0.5,0.3
on_any_processor paths skyway-plan map --queries queries --vehicle box:0.5,0.5,0.3 --snap-ends 30
on_any_processor trajectories skyway-traj map paths.here --vmax 8 --amax 6
on_any_processor reports skyway-check map trajectories.here
grep -m 1 '"status":"solved"' trajectories.here >one
on_any_processor mission skyway-export map one --format crazyflie
[ "$(grep -c '"ok":true' reports.here)" -ge 5 ]
[ "$(grep -c '"ok":true' reports.1)" -ge 5 ]
echo "same bytes"
