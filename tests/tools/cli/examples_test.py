"""examples_test.py BIN_DIR SOURCE_DIR: every example of the help texts and of the manual pages runs, as a reader pastes it,
in a folder with data/. The examples of a page run one after the other in one folder."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

bin_dir, source_dir = map(pathlib.Path, sys.argv[1:3])
environment = {**os.environ, "PATH": f"{bin_dir}:{os.environ['PATH']}"}


def examples_of_page(page):
    blocks = re.findall(r"\n\n((?:    \S.*\n)+)", page.read_text())
    return [line.strip() for block in blocks for line in block.splitlines()]


def example_of_help(tool):
    text = subprocess.run([tool, "--help"], capture_output=True, text=True, check=True).stdout
    return re.findall(r"^Example:\n  (.*)$", text, re.M)


def is_built(command):
    """Whether the build has all tools that a command names."""
    return all((bin_dir / name).exists() for name in re.findall(r"(?:^|[|;&] *|do )(skyway[\w-]*)", command))


def faults(source, commands):
    if not commands:
        return [f"{source}: no example"]
    found = []
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(source_dir / "data", pathlib.Path(folder) / "data")
        for command in filter(is_built, commands):
            run = subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=folder, env=environment, text=True,
                                 stdin=subprocess.DEVNULL, capture_output=True)
            if run.returncode != 0:
                found.append(f"{source}: [{run.returncode}] {command}\n{run.stderr}")
    return found


sources = {page.name: examples_of_page(page) for page in sorted((source_dir / "docs/man").glob("*.md"))}
sources = {name: commands for name, commands in sources.items() if commands or name.endswith(".1.md")}
for tool in sorted(bin_dir.glob("skyway*")):
    if tool.is_file() and os.access(tool, os.X_OK):
        sources[f"{tool.name} --help"] = example_of_help(tool)
wrong = [fault for source, commands in sources.items() for fault in faults(source, commands)]
print("\n".join(wrong) or f"{sum(map(len, sources.values()))} examples run")
sys.exit(bool(wrong))
