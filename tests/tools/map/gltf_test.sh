#!/usr/bin/env bash
# gltf_test.sh BIN_DIR DATA_DIR NPM_DIR: the reference validator has nothing to say about our glTF. It is
# fetched into NPM_DIR once; without npm or network the test is skipped.
set -euo pipefail
command -v npm >/dev/null || { echo "skipped: npm is not installed"; exit 77; }
if [ ! -d "$3/node_modules/gltf-validator" ]; then
  mkdir -p "$3"
  npm install --silent --no-audit --no-fund --prefix "$3" gltf-validator@2.0.0-dev.3.10 >/dev/null 2>&1 ||
    { echo "skipped: npm cannot fetch gltf-validator"; exit 77; }
fi
export PATH="$1:$PATH"
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
. "$here/meshes.sh" "$2"
cat > validate.js <<'JS'
const validator = require(process.argv[2] + '/node_modules/gltf-validator');
const fs = require('fs');
(async () => {
  for (const name of process.argv.slice(3)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(name)));
    const { numErrors, numWarnings, messages } = report.issues;
    console.log(name, numErrors, 'errors', numWarnings, 'warnings');
    if (numErrors + numWarnings > 0) {
      console.log(JSON.stringify(messages.slice(0, 5)));
      process.exitCode = 1;
    }
  }
})();
JS
node validate.js "$3" map.glb all.glb
grep -aq '"alphaMode":"BLEND"' all.glb  # the corridor
