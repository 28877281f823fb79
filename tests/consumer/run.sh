#!/usr/bin/env bash
# run.sh BUILD_DIR SOURCE_DIR: installs the project into an empty prefix and builds against it.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$1" --prefix "$folder/prefix" > /dev/null
cmake -S "$2" -B "$folder/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/prefix" > /dev/null
cmake --build "$folder/build" > "$folder/log" || { cat "$folder/log"; exit 1; }
"$folder/build/consumer"
"$folder/prefix/bin/skyway" help > /dev/null
echo "find_package(skyway) works"
