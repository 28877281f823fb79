#!/usr/bin/env bash
# demo.sh BIN_DIR OUT_DIR: the whole chain on data/downtown.csv, one line a step.
set -euo pipefail
bin=$(cd "$1" && pwd)
out=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
mkdir -p "$out"
export PATH="$bin:$PATH"
vehicle=(--vehicle "$here/data/vehicles/quad2kg.json" --margin 0.5)  # the margin: what flight may stray
map=$out/city.boxmap

# step WORDS COUNT-COMMAND TOOL [ARGUMENT ...]: runs a tool and says what came out, and how fast.
step() {
  local words=$1 count=$2 begin end
  shift 2
  begin=$(date +%s%N)
  "$@"
  end=$(date +%s%N)
  printf '%-34s %-44s %6d ms\n' "$words" "$(eval "$count")" $(((end - begin) / 1000000))
}

number() { grep -o "\"$1\":[0-9.]*" "$2" | head -n 1 | cut -d: -f2; }
last_number() { grep -o "\"$1\":[0-9.]*" "$2" | tail -n 1 | cut -d: -f2; }  # behind those of the search's steps

step "city table to box map" 'skyway-info "$map" | grep boxes' \
  skyway-import -q "$here/data/downtown.csv" -o "$map"
step "lattice, 10 m, 26 neighbours" 'skyway-info "$out/city.lattice" | grep -E "nodes|edges" | paste -sd" "' \
  skyway-lattice -q "$map" --spacing 10 --connect 26 "${vehicle[@]}" -o "$out/city.lattice"
step "path across the city" 'printf "length: %.1f m" "$(last_number length "$out/path.jsonl")"' \
  skyway-plan -q "$map" --lattice "$out/city.lattice" "${vehicle[@]}" --from=-425,-320.5,7 --to=357,204,5 \
  --snap-ends 5 -o "$out/path.jsonl"
step "minimum-snap trajectory" 'printf "duration: %.1f s, by %s" "$(number duration "$out/trajectory.jsonl")" "$(grep -o "\"rung\":\"[a-z_]*" "$out/trajectory.jsonl" | cut -d\" -f4)"' \
  skyway-traj -q "$map" "$out/path.jsonl" "${vehicle[@]}" --vmax 8 --amax 6 --yaw along -o "$out/trajectory.jsonl"
step "proof" 'printf "ok: %s, clearance: %.3f m" "$(grep -o "\"ok\":[a-z]*" "$out/report.jsonl" | cut -d: -f2)" "$(number clearance "$out/report.jsonl")"' \
  skyway-check -q "$map" "$out/trajectory.jsonl" -o "$out/report.jsonl"
step "simulated flight" 'printf "clear: %s, tracking error: %.3f m mean" "$(grep -o "\"clear\":[a-z]*" "$out/flown.jsonl" | cut -d: -f2)" "$(number mean "$out/flown.jsonl")"' \
  skyway-fly -q "$map" "$out/trajectory.jsonl" --vehicle "$here/data/vehicles/quad2kg.json" -o "$out/flight.csv" \
  --report-file "$out/flown.jsonl"
step "Crazyflie polynomials" 'echo "segments: $(($(wc -l < "$out/crazyflie.csv") - 1))"' \
  skyway-export -q "$map" "$out/trajectory.jsonl" --format crazyflie -o "$out/crazyflie.csv"
step "plan view" 'echo "$out/plan.svg"' skyway-plot -q plan "$map" "$out/path.jsonl" -o "$out/plan.svg"
step "motion profile" 'echo "$out/profile.svg"' \
  skyway-plot -q profile "$out/trajectory.jsonl" -o "$out/profile.svg"
step "search tree, for the page" 'echo "nodes: $(head -n 1 "$out/tree.jsonl" | grep -o "\"nodes\":[0-9]*" | cut -d: -f2)"' \
  skyway-plan -q "$map" "${vehicle[@]}" --from=-425,-320.5,7 --to=357,204,5 --snap-ends 5 --method rrt-star \
  --iterations 2000 --tree "$out/tree.jsonl" -o "$out/sampled.jsonl"
step "what the camera sees" 'echo "$out/first-person.png"' \
  skyway-render -q "$map" "$out/flight.csv" --at 20 -o "$out/first-person.png"
mkdir -p "$out/frames"
echo '{"width":320,"height":240,"fx":190}' > "$out/frames/camera.json"
step "frames of it, for the page" 'echo "frames: $(($(wc -l < "$out/frames/poses.csv") - 1)), one a second"' \
  skyway-render -q "$map" "$out/flight.csv" --camera "$out/frames/camera.json" --rate 1 \
  -o "$out/frames/%05d.png" --poses "$out/frames/poses.csv"
step "everything in one page" 'echo "$out/demo.html"' \
  skyway-view -q "$map" "$out/city.lattice" "$out/path.jsonl" "$out/tree.jsonl" "$out/trajectory.jsonl" \
  "$out/report.jsonl" "$out/flight.csv" --frames "$out/frames/%05d.png" --poses "$out/frames/poses.csv" \
  --title "Skyway demo" -o "$out/demo.html"
echo "Open $(cd "$out" && pwd)/demo.html in a browser."
