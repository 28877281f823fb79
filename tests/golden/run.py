"""run.py BIN_DIR TOOL: runs the golden cases of one tool; UPDATE_GOLDEN=1 rewrites what they expect.

A case of cases/TOOL.json has a name, a shell command (`run`, in an empty folder with the files of
data/ in it), and the exit code, stdout and stderr that it must give, byte for byte.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def run(case, bin_dir):
    with tempfile.TemporaryDirectory() as folder:
        for file in (HERE / "data").iterdir():
            shutil.copy(file, folder)
        env = dict(os.environ, PATH=f"{bin_dir}:{os.environ['PATH']}", LC_ALL="C")
        done = subprocess.run(["bash", "-o", "pipefail", "-c", case["run"]], cwd=folder, env=env,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=120)
        left = sorted(p.name for p in pathlib.Path(folder).iterdir() if p.suffix == ".part")
    return {"exit": done.returncode, "stdout": done.stdout.decode().splitlines(keepends=True),
            "stderr": done.stderr.decode().splitlines(keepends=True)}, left


def main():
    bin_dir, tool = sys.argv[1:3]
    path = HERE / "cases" / f"{tool}.json"
    cases = json.loads(path.read_text())
    update = os.environ.get("UPDATE_GOLDEN") == "1"
    failed = 0
    for case in cases:
        got, left = run(case, bin_dir)
        if update:
            case.update(got)
        for key in got:
            if case.get(key) != got[key]:
                failed += 1
                print(f"{tool}: {case['name']}: {key}\n  expected {case.get(key)}\n  found    {got[key]}")
        if left:
            failed += 1
            print(f"{tool}: {case['name']}: left behind {left}")
    exits = {case.get("exit") for case in cases}
    if len(cases) < 3 or 0 not in exits or not exits & {1, 2, 3, 4}:
        failed += 1
        print(f"{tool}: at least three cases, one that succeeds and one that fails, are required")
    if update:
        path.write_text(json.dumps(cases, indent=1, ensure_ascii=False) + "\n")
    print(f"{tool}: {len(cases)} cases, {failed} differences")
    sys.exit(failed > 0)


main()
