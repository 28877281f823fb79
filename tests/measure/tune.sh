#!/usr/bin/env bash
# tune.sh BIN_DIR DATA: what skyway-fly --tune makes of the gains of a profile, on four courses, as a table.
# DATA has colliders and blockmaps, as SKYWAY_REALDATA does. COURSES names some of the courses. Fails where gains got worse.
set -euo pipefail
export PATH="$(cd "$1" && pwd):$PATH"
data=$(cd "$2" && pwd)
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# course NAME MAP VEHICLE MARGIN FROM TO SPEED ACCELERATION
course() {
  skyway-plan -q "$2" --vehicle "$3" --margin "$4" --from="$5" --to="$6" --snap-ends 5 |
    skyway-traj -q "$2" --vmax "$7" --amax "$8" -o "$1.jsonl"
}

skyway-import -q "$data/blockmaps/wpi_pear_p2b_map1.txt" -o wpi.boxmap
skyway-import -q "$here/data/pocket.txt" -o pocket.boxmap
skyway-import -q "$here/data/downtown.csv" -o demo.boxmap
skyway-import -q "$data/colliders/udacity_colliders.csv" -o street.boxmap
course wpi wpi.boxmap tello 0.05 0,0,0 -0.59,6.81,0 1 2
course pocket pocket.boxmap crazyflie 0 0.08,0.1,0.15 0.62,0.4,0.15 0.5 1
course demo demo.boxmap quad2kg 0.5 -425,-320.5,7 357,204,5 8 6
course street street.boxmap quad2kg 0.5 299.423106,140.073490,6.333305 261.914737,118.502122,23.546779 8 6

number() { sed -n "s/^  \"$1\": \([0-9.e-]*\|null\),*$/\1/p" stats; }
worse=0
echo '| course | noise | seed | rms before, m | rms after, m | flights |'
echo '|---|---|---|---|---|---|'
for name in ${COURSES:-wpi pocket demo street}; do
  case $name in wpi) vehicle=tello ;; pocket) vehicle=crazyflie ;; *) vehicle=quad2kg ;; esac
  for noise in 0.005,0.02,0.1,0.2 0.005,0.05,0.5,3; do
    for seed in 0 1 2; do
      skyway-fly -q "$name.jsonl" --vehicle $vehicle --noise $noise --seed $seed --tune -o gains.json --stats stats
      before=$(number before)
      after=$(number cost)
      printf '| %s | %s | %s | %.4f | %.4f | %s |\n' $name $noise $seed "$before" "$after" "$(number flights)"
      awk -v b="$before" -v a="$after" 'BEGIN { exit !(a <= b) }' || worse=1
    done
  done
done
exit $worse
