#!/usr/bin/env bash
# run.sh BIN_DIR: the chain on the real tables in the folder that SKYWAY_REALDATA names.
set -euo pipefail
if [ -z "${SKYWAY_REALDATA:-}" ]; then
  echo "skipped: SKYWAY_REALDATA is not set"
  exit 77
fi
export PATH="$1:$PATH"
tables=$SKYWAY_REALDATA/colliders
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

boxes() { skyway-import -q "$tables/$1.csv" | skyway-map to-csv - | sort; }
boxes udacity_colliders > all
[ "$(wc -l < all)" -eq 3846 ]
for same in seed_obstacle-data abhiojha8_crlf irvingvasquez_bare-latlon; do
  boxes "$same" | cmp - all
done
# jwdunn1 leaves props out and hangs nothing: compare before sealing.
skyway-import -q --seal 0 "$tables/udacity_colliders.csv" | skyway-map to-csv - | sort > unsealed
skyway-import -q --seal 0 "$tables/jwdunn1.csv" | skyway-map to-csv - | sort > part
[ "$(wc -l < part)" -eq 3214 ]
[ "$(comm -23 part unsealed | wc -l)" -eq 0 ]
[ "$(boxes yuluis_short_3line-header | wc -l)" -eq 794 ]

skyway-import -q "$tables/udacity_colliders.csv" -o map
cat > queries <<'JSON'
{"id":"street-local-0","from":[-1.756683,68.508093,10.179412],"to":[30.970009,36.382374,21.711315]}
{"id":"street-local-1","from":[299.423106,140.073490,6.333305],"to":[261.914737,118.502122,23.546779]}
{"id":"street-local-2","from":[-14.931657,-331.811228,28.565901],"to":[-0.595477,-371.679742,6.308936]}
JSON
skyway-plan map --queries queries --vehicle box:1,1,1 | skyway-traj map --vmax 8 --amax 6 | skyway-check map -o reports
[ "$(grep -c '"ok":true' reports)" -eq 3 ]
for text in "$SKYWAY_REALDATA"/blockmaps/*.txt; do
  case $text in *startgoal*) continue ;; esac
  skyway-import "$text" | skyway-map info - > /dev/null
done
echo "real data agree"
