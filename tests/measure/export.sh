#!/usr/bin/env bash
# export.sh BIN_DIR MAP TRAJECTORIES: how many of the trajectories each format takes, why not the others,
# and seconds of wall time a file.
set -euo pipefail
export PATH="$1:$PATH"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mapfile -t ids < <(grep -oE '^\{"type":"trajectory","id":"[^"]*"' "$3" | cut -d'"' -f8)
for format in crazyflie setpoints tello wpl qgc-plan kml geojson gltf; do
  written=0
  : > "$folder/why"
  began=$(date +%s%N)
  for id in "${ids[@]}"; do
    if skyway-export "$2" "$3" --id "$id" --format $format -q -o "$folder/file" 2>> "$folder/why"; then
      written=$((written + 1))
    fi
  done
  took=$((($(date +%s%N) - began) / 1000000 / ${#ids[@]}))
  echo "$format: $written of ${#ids[@]}, $took ms each" \
    "$(grep -oE 'flown as the file says, [a-z ]+' "$folder/why" | sort | uniq -c | tr -s ' ' | paste -sd';')"
done
