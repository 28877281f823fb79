#!/usr/bin/env bash
# run.sh BUILD_DIR SOURCE_DIR [FLAGS]: installs the project into an empty prefix, and builds and runs docs/library.md against it.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
shown() { awk -v begin="\`\`\`$1" '$0 == "```" { on = 0 } on { print } $0 == begin { on = 1 }' "$2"; }
shown cpp "$2/../../docs/library.md" | diff - "$2/consumer.cpp"
shown cmake "$2/../../docs/library.md" | diff - "$2/CMakeLists.txt"
cmake --install "$1" --prefix "$folder/prefix" > /dev/null
cmake -S "$2" -B "$folder/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/prefix" \
  -DCMAKE_CXX_FLAGS="${3:-}" > /dev/null
cmake --build "$folder/build" > "$folder/log" || { cat "$folder/log"; exit 1; }
printf 'boundary 0 0 0 10 10 10\nblock 4 0 0 5 8 8\n' > "$folder/city.txt"
"$folder/build/consumer" < "$folder/city.txt" > "$folder/flight.jsonl"
# What it says is proved, another program proves again.
"$folder/prefix/bin/skyway-import" -q "$folder/city.txt" -o "$folder/city.boxmap"
"$folder/prefix/bin/skyway-check" "$folder/city.boxmap" "$folder/flight.jsonl" > "$folder/report.jsonl"
printf 'boundary 0 0 0 10 10 10\nblok 4 0 0 5 8 8\nblock 1 9 9 2 9.5 9.5\n' > "$folder/odd.txt"
if "$folder/build/consumer" < "$folder/odd.txt" > /dev/null 2> "$folder/said"; then exit 1; fi
grep -q "unknown keyword (line 2: blok)" "$folder/said"
"$folder/prefix/bin/skyway" help > /dev/null
echo "find_package(skyway) works"
