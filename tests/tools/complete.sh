#!/usr/bin/env bash
# complete.sh BIN_DIR SOURCE_DIR: every tool has a verb, a manual page, golden cases and a line in the README.
set -euo pipefail
missing=0
for source in "$2"/tools/skyway_*.cpp; do
  tool=$(basename "$source" .cpp | tr _ -)
  verb=${tool#skyway-}
  "$1/skyway" help | grep -q "^  $verb " || { echo "skyway help does not list $verb"; missing=1; }
  [ -s "$2/docs/man/$tool.1.md" ] || { echo "docs/man/$tool.1.md is missing"; missing=1; }
  [ -s "$2/tests/golden/cases/$tool.json" ] || { echo "no golden cases of $tool"; missing=1; }
  grep -q "^| \`$tool\` |" "$2/README.md" || { echo "the README does not list $tool"; missing=1; }
  # An option that the manual page does not name; verbs of skyway-map have pages of help of their own.
  [ "$verb" = map ] || [ ! -x "$1/$tool" ] || for option in $("$1/$tool" --help | grep -oE '^ +(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+'); do
    grep -q -- "$option" "$2/docs/man/$tool.1.md" || { echo "docs/man/$tool.1.md does not name $option"; missing=1; }
  done
done
exit $missing
