"""run.py BIN_DIR NAME: runs the golden cases of NAME.txt, a tool's or others; UPDATE_GOLDEN=1 rewrites what they expect.

transcript.py says how a case is written. Each runs in an own folder that holds the files of data/ and what
its set-up made, its commands in one bash: variables and `cd` last from one to the next. stdout, stderr
and the exit code of every command must be those written, byte for byte, and no *.part file may be left.
A set-up is run once; its cases get copies of the files (a shell variable that it sets is not kept).
"""

import difflib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # nothing is written beside the sources
import transcript

HERE = pathlib.Path(__file__).resolve().parent
TIME_LIMIT = 400  # seconds a case or set-up


def run(commands, folder, bin_dir):
    """What each command gave; fewer than `commands` if one of them ended the shell or took too long."""
    with tempfile.TemporaryDirectory() as seen:
        at = shlex.quote(seen)
        script = "golden_status() { return $1; }\n" + "".join(
            f"eval {shlex.quote(command.text)} >{at}/{i}.out 2>{at}/{i}.err; golden_exit=$?; "
            f"echo $golden_exit >{at}/{i}.exit; golden_status $golden_exit\n"
            for i, command in enumerate(commands))
        env = dict(os.environ, PATH=f"{bin_dir}:{os.environ['PATH']}", LC_ALL="C")
        shell = subprocess.run(["timeout", str(TIME_LIMIT), "bash", "-o", "pipefail", "-c", script],
                               cwd=folder, env=env, stdin=subprocess.DEVNULL)
        stopped = shell.returncode == 124  # timeout(1) says so
        results = []
        for i in range(len(commands)):
            out, err, code = (pathlib.Path(seen, f"{i}.{kind}") for kind in ("out", "err", "exit"))
            if not out.exists() or stopped and not code.exists():
                break
            results.append(transcript.Result(out.read_bytes(), err.read_bytes(),
                                             int(code.read_text()) if code.exists() else shell.returncode))
        return results


def left_behind(folder):
    return [f"left behind: {part.relative_to(folder)}" for part in sorted(folder.rglob("*.part"))]


def difference(command, result):
    expected, found = transcript.show(command.expected), transcript.show(result)
    return "\n".join(difflib.unified_diff(expected, found, "expected", "found", n=1, lineterm=""))


class Folders:
    """The folders that cases start from. Each is made once, when a case first asks for it."""

    def __init__(self, root, bin_dir):
        self.root = root
        self.bin_dir = bin_dir
        self.wrong = {}  # by set-up: what failed, or an empty list

    def fill(self, folder, setup):
        """Copies what `setup` made to `folder`; gives what failed in making it."""
        if setup is None:
            shutil.copytree(HERE / "data", folder, dirs_exist_ok=True)
            return []
        made = self.root / setup.title
        if setup.title not in self.wrong:
            self.wrong[setup.title] = self.fill(made, setup.setup) or self.make(made, setup)
        if not self.wrong[setup.title]:
            shutil.copytree(made, folder, dirs_exist_ok=True)
        return self.wrong[setup.title]

    def make(self, folder, setup):
        results = run(setup.commands, folder, self.bin_dir)
        for command, result in zip(setup.commands, results):
            if result != transcript.Result():
                return [f'the set-up "{setup.title}" ({setup.place}): $ {command.text}\n{difference(command, result)}']
        ended = len(results) < len(setup.commands)
        return [f'the set-up "{setup.title}" ({setup.place}) did not come to its end'] * ended + left_behind(folder)


def run_case(case, folders, update):
    """The results by line of the command, and what is wrong with them, each with its place."""
    file = case.place.partition(":")[0]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        unmade = folders.fill(folder, case.setup)
        if unmade:
            return {}, [f"{case.place}: {case.title}: {reason}" for reason in unmade]
        results = run(case.commands, folder, folders.bin_dir)
        wrong = [f"{case.place}: {case.title}: {part}" for part in left_behind(folder)]
    for command, result in zip(case.commands, results):
        if result != command.expected and not update:
            wrong.append(f"{file}:{command.line}: {case.title}: $ {command.text}\n{difference(command, result)}")
    for command in case.commands[len(results):]:
        wrong.append(f"{file}:{command.line}: {case.title}: not run to its end, as the shell ended or "
                     f"{TIME_LIMIT} s were over: $ {command.text}")
    return {command.line: result for command, result in zip(case.commands, results)}, wrong


def lacks(cases, results, tool):
    """What the cases of a tool lack: three of them, one where it succeeds and one where it fails."""
    named = re.compile(rf"(?<![\w-]){tool}(?![\w-])")
    exits = {results.get(command.line, command.expected).exit
             for case in cases for command in case.commands if named.search(command.text)}
    if len(cases) < 3 or 0 not in exits or not exits & {1, 2, 3, 4}:
        return ["at least three cases, one where the tool succeeds and one where it fails, are required"]
    return []


def main():
    bin_dir, tool = sys.argv[1:3]
    update = os.environ.get("UPDATE_GOLDEN") == "1"
    path = HERE / f"{tool}.txt"
    try:
        shared = transcript.read(HERE / "setups.txt")
        golden = transcript.read(path, shared.setups)
        if shared.cases:
            raise transcript.Malformed("setups.txt:1: cases stand in the file of their tool")
        if not golden.cases:
            raise transcript.Malformed(f"{path.name}:1: no case")
    except transcript.Malformed as error:
        sys.exit(str(error))
    cases = list(golden.cases.values())
    results, wrong = {}, []
    with tempfile.TemporaryDirectory() as root:
        folders = Folders(pathlib.Path(root), bin_dir)
        for case in cases:
            found, differences = run_case(case, folders, update)
            results.update(found)
            wrong += differences
    if tool.startswith("skyway"):
        wrong += [f"{tool}: {line}" for line in lacks(cases, results, tool)]
    if update:
        path.write_text(transcript.rewritten(golden, results), encoding="utf-8", newline="\n")
    print(*wrong, f"{tool}: {len(cases)} cases, {len(wrong)} failures", sep="\n")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
