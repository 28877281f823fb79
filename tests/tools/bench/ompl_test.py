"""ompl_test.py TOOLS: planners of OMPL answer skyway-bench from a module of their own, and their paths are free.

Without the module the tool does its own work, and says what is missing.
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

tools = pathlib.Path(sys.argv[1])


def bench(where, folder, *words):
    command = [where / "skyway-bench", folder / "city.boxmap", "--vehicle", "box:1,1,1", "--trials", "10", "--seed", "3", "-q",
               "-o", folder / "report.json", *words]
    return subprocess.run(command, capture_output=True, text=True)


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    subprocess.run([tools / "skyway-synth", "-o", folder / "city.csv"], check=True)
    subprocess.run([tools / "skyway-import", folder / "city.csv", "-q", "-o", folder / "city.boxmap"], check=True)
    for method in ("rrt-connect-ompl", "informed-rrt-star-ompl"):
        done = bench(tools, folder, "--method", method, "--ompl-seconds", "0.2")
        assert done.returncode == 0, done.stderr
        report = json.loads((folder / "report.json").read_text())["methods"][0]
        assert (report["found"], report["invalid"]) == (10, 0), report
    (folder / "report.json").unlink()

    shutil.copy(tools / "skyway-bench", folder)
    done = bench(folder, folder, "--method", "rrt-connect-ompl")
    assert done.returncode > 0 and "libskyway_ompl.so" in done.stderr, done
    assert not (folder / "report.json").exists()
    done = bench(folder, folder, "--method", "auto")
    assert done.returncode == 0, done.stderr
