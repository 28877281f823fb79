"""pages_test.py TOOLS SOURCE [PYTHON_MODULE_DIR]: the commands of the README and of docs/guide, as a reader pastes them, page by
page in a folder with nothing but data/. TOOLS is a folder of tools, or a build whose tools are installed first; SOURCE has
README.md, docs and data.

A block of `sh` is run by bash, a block of `python` by Python where there is a module. A command that ends with the comment
`# exits N` stands alone in its block and exits with N, all others with 0. A block of `text` is all that the block before it printed;
UPDATE_GOLDEN=1 writes it. A page whose commands need a tool of a package that is not there is left out."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TOOLS, SOURCE = (pathlib.Path(a).resolve() for a in sys.argv[1:3])
MODULE = sys.argv[3] if len(sys.argv) > 3 else None
UPDATE = os.environ.get("UPDATE_GOLDEN") == "1"
BLOCK = re.compile(r"^```(sh|python|text)\n(.*?)^```\n", re.S | re.M)
EXITS = re.compile(r" +# exits (\d)\n\Z")
# What a page promises beyond commands that run.
MADE = {"tour.md": {"city.html", "city.glb", "mission.csv", "report.jsonl", "flight.csv", "flight.jsonl", "flight.mp4",
                    "profile.svg", "overview.png", "first-person.png", "depth.png", "earth.plan", "earth.kmz", "earth.html"}}
OTHER_PACKAGES = ("skyway-cloud", "skyway-footprints", "skyway-mesh")
LEAST_BLOCKS = {"README.md": 1, "which-tool.md": 0}  # of all others: 5


class Wrong(Exception):
    """A page is not as its reader finds things."""


def stand_in_for_ffmpeg(folder):
    """No part of Skyway: what it would do with the frames is left out."""
    program = folder / "ffmpeg"
    program.write_text('#!/bin/sh\nfor last; do :; done\nhead -c 10 > "$last"\ncat > /dev/null\n')
    program.chmod(0o755)


def environment(home):
    """That of a stranger: nothing of the source tree."""
    home.mkdir()
    path = [str(TOOLS)]
    if (TOOLS / "CMakeCache.txt").exists():
        installed = home / "installed"
        subprocess.run(["cmake", "--install", TOOLS, "--prefix", installed], check=True, stdout=subprocess.DEVNULL)
        path = [str(installed / "bin")]
    if not shutil.which("ffmpeg"):
        stand_in_for_ffmpeg(home)
        path.append(str(home))
    values = {"HOME": str(home), "PATH": ":".join(path + ["/usr/bin", "/bin"]), "LC_ALL": "C.UTF-8"}
    return values | ({"PYTHONPATH": MODULE} if MODULE else {})


def absent_tools(text, path):
    """Tools of other packages that the page's commands name and that are not there."""
    commands = "".join(body for kind, body in BLOCK.findall(text) if kind == "sh")
    return [tool for tool in OTHER_PACKAGES if tool in commands and not shutil.which(tool, path=path)]


def run(page, kind, body, folder, values):
    """What a block prints, when it ends as the page says."""
    exits = EXITS.search(body)
    wanted = int(exits.group(1)) if exits else 0
    if "# exits" in body and not (exits and body.count("\n") == 1):
        raise Wrong(f"{page}: a command that exits with another code than 0 stands alone in its block:\n{body}")
    program = ["bash", "-euo", "pipefail", "-c"] if kind == "sh" else [sys.executable, "-c"]
    done = subprocess.run([*program, body], cwd=folder, env=values, text=True, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != wanted:
        raise Wrong(f"{page}: exit code {done.returncode}, not {wanted}:\n{body}{done.stdout}")
    return done.stdout


def replay(page, text, folder, values):
    """The page with what its commands print now."""
    printed, before, count, parts, end = None, "text", 0, [], 0
    for block in BLOCK.finditer(text):
        kind, body = block.groups()
        if kind != "text":
            count += 1
            printed = run(page, kind, body, folder, values) if kind == "sh" or MODULE else None
        elif before == "text":
            raise Wrong(f"{page}: a block of text follows no command:\n{body}")
        elif printed is not None:
            parts += [text[end:block.start(2)], printed]
            end = block.end(2)
        before = kind
    if count < LEAST_BLOCKS.get(page, 5):
        raise Wrong(f"{page}: {count} blocks, fewer than {LEAST_BLOCKS.get(page, 5)}")
    return "".join(parts) + text[end:]


def try_page(path, values, home):
    page, text = path.name, path.read_text(encoding="utf-8")
    absent = absent_tools(text, values["PATH"])
    if absent:
        print(f"{page}: left out, without {', '.join(absent)}")
        return False
    folder = home / path.stem
    folder.mkdir()
    (folder / "data").symlink_to(SOURCE / "data")
    now = replay(page, text, folder, values)
    missing = MADE.get(page, set()) - {f.name for f in folder.iterdir() if f.stat().st_size}
    if missing:
        raise Wrong(f"{page}: not made: {sorted(missing)}")
    if UPDATE:
        path.write_text(now, encoding="utf-8", newline="\n")
    elif now != text:
        place = next(n for n, (a, b) in enumerate(zip(now.splitlines() + [""], text.splitlines() + [""]), 1) if a != b)
        raise Wrong(f"{page}:{place}: the page says\n{text.splitlines()[place - 1]}\nand the tools\n{now.splitlines()[place - 1]}")
    return True


def main(home):
    values = environment(home / "home")
    wrong, tried = [], 0
    for path in [SOURCE / "README.md", *sorted((SOURCE / "docs/guide").glob("*.md"))]:
        try:
            tried += try_page(path, values, home)
        except Wrong as found:
            wrong.append(str(found))
    print("\n".join(wrong) or f"{tried} pages")
    return bool(wrong or not tried)


with tempfile.TemporaryDirectory() as name:
    sys.exit(main(pathlib.Path(name)))
