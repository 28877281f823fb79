#!/usr/bin/env bash
# pcl_ply_test.sh BIN_DIR DATA_DIR PCL_PLY: PCL reads our PLY files, with as many vertices and triangles as their
# headers say.
set -euo pipefail
export PATH="$1:$PATH"
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
pcl_ply=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
. "$here/meshes.sh" "$2"
for name in map all; do
  vertices=$(grep -a -m 1 '^element vertex' $name.ply | cut -d' ' -f3)
  faces=$(grep -a -m 1 '^element face' $name.ply | cut -d' ' -f3 || true)
  [ "$("$pcl_ply" $name.ply | tail -n 1)" = "$vertices vertices, ${faces:-0} triangles" ]
done
echo "PCL reads them"
