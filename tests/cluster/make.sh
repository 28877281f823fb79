#!/usr/bin/env bash
# make.sh BIN_DIR CHAIN_DIR CITY: the Makefile of the chain, on a table of boxes, gives, in parallel, the bytes of a single run; a second make does no
# work, a damaged or missing shard alone is made anew, and so is all that another chain.conf, query or table changes.
set -euo pipefail
export PATH="$1:$PATH"
chain=$2
city=$3
command -v make >/dev/null || { echo "skipped: make is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/chain" && cd "$folder/chain"
cp "$chain/chain.conf" .
cp "$city" city.csv
sed -i 's/^VEHICLE=.*/VEHICLE="box:1,1,1"/; s/^PLAN=.*/PLAN="--snap-ends 60"/; s/^TRAJECTORIES=.*/TRAJECTORIES="--vmax 8 --amax 6 --solver stop-and-go"/' chain.conf
for i in 1 2 3 4 5 6 7; do
  echo "{\"id\":\"q$i\",\"from\":[-2${i}0,-10$i,30],\"to\":[2${i}0,1${i}4,20]}"
done >queries.jsonl
run() { make -s -j2 -f "$chain/chain.mk" FOLDER="$folder/chain" >log.txt 2>&1 || { cat log.txt; exit 1; }; }
run
grep -q '"ok":true' reports.jsonl
skyway-import -q city.csv | cmp - city.boxmap
skyway-lattice city.boxmap --spacing 5 --vehicle box:1,1,1 | cmp - city.lattice
skyway-roadmap city.boxmap --reach 60 --vehicle box:1,1,1 | cmp - city.roadmap
skyway-plan city.boxmap --lattice city.lattice --roadmap city.roadmap --queries queries.jsonl --vehicle box:1,1,1 \
  --snap-ends 60 -q | cmp - paths.jsonl
skyway-traj city.boxmap paths.jsonl --vmax 8 --amax 6 --solver stop-and-go -q | cmp - trajectories.jsonl
skyway-check city.boxmap trajectories.jsonl -q | cmp - reports.jsonl

sha256sum -- *.jsonl city.* >sums
stat -c '%n %i' shards/* >before
run
stat -c '%n %i' shards/* | cmp - before
rm shards/lattice.2
truncate -s -1 shards/paths.1 && touch -d yesterday shards/paths.1
run
sha256sum -c --quiet sums
! stat -c '%n %i' shards/* | diff - before | grep '^>' | grep -v -e 'lattice.2 ' -e 'paths.1 '

single_run() {
  skyway-import -q city.csv | cmp - city.boxmap
  skyway-plan city.boxmap --queries queries.jsonl --vehicle "$1" --snap-ends 60 -q >other.jsonl || [ $? -eq 1 ]
  [ "$(wc -l <other.jsonl)" -eq "$(wc -l <reports.jsonl)" ]
  grep -c "\"vehicle\":{\"name\":\"$1\"" reports.jsonl | grep -qx "$(wc -l <reports.jsonl)"
}
sed -i 's/^VEHICLE=.*/VEHICLE="box:1,1,2"/' chain.conf
run
single_run box:1,1,2
echo '{"id":"q8","from":[-280,-108,30],"to":[280,184,20]}' >>queries.jsonl
run
single_run box:1,1,2
sed '$p' city.csv | sed '$s/^[^,]*,[^,]*/500,500/' >c && mv c city.csv
run
single_run box:1,1,2
echo "same bytes"
