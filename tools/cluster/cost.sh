#!/usr/bin/env bash
# cost.sh FOLDER [STEP]: seconds and megabytes to ask for, of each step or of one, a shard each: from what was measured
# (docs/benchmarks.md, "Cluster") times three, and the size of the map.
set -euo pipefail
cd "$1"
source chain.conf
tiles=0
boxes=0
if [ -e city.boxmap ]; then
  read -r boxes tiles < <(skyway-info --json city.boxmap | sed -E 's/.*"boxes":([0-9]+).*"tiles":([0-9]+).*/\1 \2/')
fi
# option NAME TEXT DEFAULT: the number after --NAME.
option() {
  sed -nE "s/.*--$1[ =]([0-9.]+).*/\1/p" <<<"$2 " | grep . || echo "$3"
}
awk -v only="${2:-}" -v boxes="$boxes" -v tiles="$tiles" -v queries="$QUERY_COUNT" \
  -v spacing="$(option spacing "$LATTICE" 25)" -v reach="$(option '(within|reach)' "$ROADMAP" 500)" \
  -v nl="$LATTICE_SHARDS" -v nr="$ROADMAP_SHARDS" -v np="$PATH_SHARDS" -v nt="$TRAJECTORY_SHARDS" -v nc="$REPORT_SHARDS" '
  function ask(step, seconds, megabytes) {
    if (only != "" && only != step) return
    line = sprintf("%d %d", 3 * seconds + 1, 1.5 * megabytes + 100)
    print only == "" ? step " " line : line
  }
  BEGIN {
    map = boxes * 62e-6                                    # megabytes of a map
    lattice = tiles * 3e-3 * (5 / spacing) ^ 3             # of a lattice
    bends = boxes * 9 * 34e-6                              # of a roadmap, without its edges
    roadmap = bends + boxes * 9 * 4e-6 * reach
    # What any process holds: scenes and mapped pages up to their limits, and tables of tiles.
    held = 40 + (3 * map < 100 ? 3 * map : 100) + 0.05 * map
    ask("map", boxes * 2e-6, boxes * 4e-4 + 500)
    ask("lattice", tiles * 3.1e-4 * (5 / spacing) ^ 3 / nl, held + 2 * lattice / nl)
    ask("join-lattice", lattice / 200, 50 + 0.07 * lattice)
    ask("roadmap", boxes * reach * 2.7e-6 / nr, held + 2 * roadmap / nr)
    ask("join-roadmap", roadmap / 90, 60)
    ask("paths", queries * 0.02 / np, held + (1.5 * bends < 250 ? 1.5 * bends : 250))
    ask("join-paths", queries / 1e4, 100)
    ask("trajectories", queries * 0.3 / nt + 10, held)  # one alone: 1 s, 10 where proofs fail
    ask("join-trajectories", queries / 1e4, 100)
    ask("reports", queries * 0.01 / nc, held)
    ask("join-reports", queries / 1e4, 100)
    ask("summary", queries / 1e4, 100)
  }'
