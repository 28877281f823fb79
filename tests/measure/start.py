"""start.py TOOLS [OLDER_TOOLS] [--runs N]: what it costs to start each tool, and the chain of the tour as five processes.

A table: for each tool the median of N runs of `TOOL --version` (default 41), in milliseconds of CPU and of wall time, the shared
libraries that it starts with, and its page faults. Then the CPU of import, plan, traj, check and export on the city of the tour, the
median of N / 4 chains, and the sum. With OLDER_TOOLS each row has both, run in turn: "older -> newer".
"""

import argparse
import os
import pathlib
import statistics
import subprocess
import tempfile
import time

CHAIN = [
    "skyway-import colliders.csv -o city.boxmap",
    "skyway-plan city.boxmap --vehicle tello --margin 0.3 --from 10,20,5 --to 300,300,8 -o path.jsonl",
    "skyway-traj city.boxmap path.jsonl -o trajectory.jsonl",
    "skyway-check city.boxmap trajectory.jsonl -o report.jsonl",
    "skyway-export city.boxmap trajectory.jsonl --format crazyflie -o mission.csv",
]


def run(tools, words, folder):
    """(CPU ms, wall ms, page faults) of one process that says nothing."""
    nothing = os.open(os.devnull, os.O_RDWR)
    where = os.open(folder, os.O_PATH)
    quiet = [(os.POSIX_SPAWN_DUP2, nothing, stream) for stream in (0, 1, 2)]
    os.fchdir(where)
    begin = time.perf_counter()
    child = os.posix_spawn(tools / words[0], words, os.environ, file_actions=quiet)
    _, status, usage = os.wait4(child, 0)
    wall = time.perf_counter() - begin
    os.close(nothing)
    os.close(where)
    if status:
        raise SystemExit(f"{' '.join(words)} ended with status {status}")
    return 1e3 * (usage.ru_utime + usage.ru_stime), 1e3 * wall, usage.ru_minflt


def libraries(tool):
    lines = subprocess.run(["ldd", tool], check=True, capture_output=True, text=True).stdout.splitlines()
    return sum("=>" in line for line in lines)


def medians(sides, words, folder, runs):
    """Of each side the medians of (CPU, wall, page faults), the sides in turn; the first run of each does not count."""
    seen = [[run(tools, words, folder) for tools in sides] for _ in range(runs + 1)][1:]
    return [[statistics.median(column) for column in zip(*side)] for side in zip(*seen)]


def both(values, form):
    return " -> ".join(form.format(value) for value in values)


def starts(sides, folder, runs):
    print("| tool | CPU, ms | wall, ms | libraries | page faults |\n|---|---|---|---|---|")
    for tool in sorted(sides[-1].glob("skyway*")):
        if tool.suffix or not tool.is_file():
            continue
        found = medians(sides, [tool.name, "--version"], folder, runs)
        print(f"| {tool.name} | {both([f[0] for f in found], '{:.1f}')} | {both([f[1] for f in found], '{:.1f}')} | "
              f"{both([libraries(side / tool.name) for side in sides], '{}')} | {both([f[2] for f in found], '{:.0f}')} |", flush=True)


def chain(sides, folder, runs):
    print("\n| the chain of the tour | CPU, ms | page faults |\n|---|---|---|")
    run(sides[-1], "skyway-synth -o colliders.csv".split(), folder)
    total = [0] * len(sides)
    for command in CHAIN:
        found = medians(sides, command.split(), folder, max(runs // 4, 3))
        total = [sum_ + f[0] for sum_, f in zip(total, found)]
        print(f"| {command.split()[0]} | {both([f[0] for f in found], '{:.1f}')} | {both([f[2] for f in found], '{:.0f}')} |", flush=True)
    print(f"| all five | {both(total, '{:.1f}')} | |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tools", type=pathlib.Path)
    parser.add_argument("older", type=pathlib.Path, nargs="?")
    parser.add_argument("--runs", type=int, default=41)
    options = parser.parse_args()
    sides = [side.resolve() for side in (options.older, options.tools) if side]
    with tempfile.TemporaryDirectory() as folder:
        starts(sides, folder, options.runs)
        chain(sides, folder, options.runs)


main()
