"""build_cost.py BUILD_DIR … [--units 150]: what a clean build of each folder costs, in seconds of CPU.

Compiles units at random (seed 1) in turns between the folders, without a compiler cache, and multiplies the mean of each
kind of unit by their number. A kind is a target. Precompiled headers are counted in full. A unit that needs a generated
file that is not there does not compile; a folder that was built has all of them.
"""

import argparse
import collections
import json
import pathlib
import random
import re
import resource
import subprocess
import sys
import tempfile


def cpu_of(command, folder):
    """Seconds of CPU of a command and its children; nothing where it fails."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, shell=True, check=False, cwd=folder, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode:
        return None
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


class Build:
    """The units of a build folder, by target."""

    def __init__(self, folder):
        self.folder = folder
        told = json.loads(subprocess.run(["ninja", "-t", "compdb"], cwd=folder, capture_output=True, text=True, check=True).stdout)
        self.commands = collections.defaultdict(list)
        seen = set()
        for unit in told:
            output = re.search(r" -o (\S+)", unit["command"]) if " -c " in unit["command"] else None
            if not output or output[1] in seen:
                continue
            seen.add(output[1])
            target = re.search(r"CMakeFiles/([^/]+)\.dir", output[1])
            kind = "precompiled" if output[1].endswith(".gch") else target[1] if target else "other"
            self.commands[kind].append(unit["command"])

    def chosen(self, units, chance):
        """Some commands of each kind, at least one, as many as its share of all."""
        total = sum(len(commands) for commands in self.commands.values())
        for kind, commands in sorted(self.commands.items()):
            number = len(commands) if kind == "precompiled" else max(1, round(units * len(commands) / total))
            yield from ((kind, command) for command in chance.sample(commands, min(number, len(commands))))

    def timed(self, command):
        """Seconds to compile it into a file that is thrown away."""
        with tempfile.TemporaryDirectory() as out:
            bare = re.sub(r"\S*ccache |/usr/bin/env \S+ ", "", command)
            bare = re.sub(r" -o \S+", f" -o {out}/x.o", bare)
            return cpu_of(re.sub(r" -MF \S+", f" -MF {out}/x.d", bare), self.folder)


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("folders", type=pathlib.Path, nargs="+")
    options.add_argument("--units", type=int, default=150)
    asked = options.parse_args()
    builds = [Build(folder) for folder in asked.folders]
    times = [collections.defaultdict(list) for _ in builds]
    samples = [list(build.chosen(asked.units, random.Random(1))) for build in builds]
    for turn in range(max(len(sample) for sample in samples)):
        for build, sample, of_kind in zip(builds, samples, times):
            if turn < len(sample):
                kind, command = sample[turn]
                seconds = build.timed(command)
                if seconds is None:
                    print(f"{build.folder}: a unit of {kind} did not compile and is left out", file=sys.stderr)
                else:
                    of_kind[kind].append(seconds)
    for build, of_kind in zip(builds, times):
        numbers = {kind: len(commands) for kind, commands in build.commands.items()}
        every = [one for seconds in of_kind.values() for one in seconds]
        mean = {kind: sum(of_kind[kind] or every) / len(of_kind[kind] or every) for kind in numbers}
        cost = sum(number * mean[kind] for kind, number in numbers.items())
        print(f"{build.folder}: {sum(numbers.values())} units, {cost:.0f} s of CPU")


if __name__ == "__main__":
    main()
