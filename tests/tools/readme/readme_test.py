"""readme_test.py TOOLS README [PYTHON_MODULE_DIR]: the commands of the README, as they stand and in their order, in an empty
folder. TOOLS is a folder of tools, or a build whose tools are installed first.

All blocks behind "## Your own city" count, up to the one of `apt install`; and the Python block, where there is a module."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TOOLS = pathlib.Path(sys.argv[1]).resolve()
README = pathlib.Path(sys.argv[2]).read_text()
MODULE = sys.argv[3] if len(sys.argv) > 3 else None
FILES = {"city.html", "city.glb", "mission.csv", "report.jsonl", "flight.csv", "flight.jsonl", "flight.mp4", "profile.svg",
         "overview.png", "first-person.png", "depth.png"}


def blocks():
    """The indented blocks, each as a script."""
    text = README[README.index("## Your own city"):README.index("## As packages")]
    for block in re.findall(r"(?:^ {4}\S.*\n(?: {4}.*\n)*)", text, re.M):
        yield re.sub(r"^ {4}", "", block, flags=re.M)


def run(command, folder, environment):
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"the README's commands fail with exit code {done.returncode}:\n{command[-1]}\n{done.stdout}{done.stderr}")
    return done.stdout


with tempfile.TemporaryDirectory() as home:
    folder, programs = pathlib.Path(home, "work"), pathlib.Path(home, "bin")
    folder.mkdir()
    programs.mkdir()
    path = [str(TOOLS)]
    if (TOOLS / "CMakeCache.txt").exists():
        run(["cmake", "--install", TOOLS, "--prefix", f"{home}/installed"], folder, os.environ)
        path = [f"{home}/installed/bin"]
    if not shutil.which("ffmpeg"):  # no part of Skyway: what it would do with the frames is left out
        stand_in = programs / "ffmpeg"
        stand_in.write_text('#!/bin/sh\nfor last; do :; done\nhead -c 10 > "$last"\ncat > /dev/null\n')
        stand_in.chmod(0o755)
        path.append(str(programs))
    # The environment of a stranger: nothing of the source tree.
    environment = {"HOME": home, "PATH": ":".join(path + ["/usr/bin", "/bin"]), "LC_ALL": "C.UTF-8"}
    count = 0
    for script in blocks():
        run(["bash", "-euo", "pipefail", "-c", script], folder, environment)
        count += 1
    missing = FILES - {f.name for f in folder.iterdir() if f.stat().st_size}
    if count < 5 or missing:
        sys.exit(f"ran {count} blocks; not made: {sorted(missing)}")
    if '"ok":true' not in (folder / "report.jsonl").read_text():
        sys.exit("the mission of the README is not proved")
    if MODULE:
        python = re.search(r"```python\n(.*?)```", README, re.S).group(1)
        said = run([sys.executable, "-c", python], folder, environment | {"PYTHONPATH": MODULE})
        if "ok: True" not in said:
            sys.exit(f"the README's Python says:\n{said}")
    print(f"{count} blocks")
