#!/usr/bin/env bash
# complete.sh BIN_DIR SOURCE_DIR: every tool has a verb, a manual page, golden cases and a line in docs/tools.md.
set -euo pipefail
missing=0
for source in "$2"/tools/*/main.cpp; do
  verb=$(basename "$(dirname "$source")" | tr _ -)
  [ "$verb" = skyway ] && continue
  tool=skyway-$verb
  "$1/skyway" help | grep -q "^  $verb " || { echo "skyway help does not list $verb"; missing=1; }
  [ -s "$2/docs/man/$tool.1.md" ] || { echo "docs/man/$tool.1.md is missing"; missing=1; }
  [ -s "$2/tests/golden/$tool.txt" ] || { echo "no golden cases of $tool"; missing=1; }
  grep -q "^| \`$tool\` |" "$2/docs/tools.md" || { echo "docs/tools.md does not list $tool"; missing=1; }
done
exit $missing
