"""Tools that run out of memory: they end with exit 4, or say what they say with enough of it.

little_memory.py TOOLS [SIZE [LIMITS]]: a synthetic city of SIZE metres, and so many limits on the
address space below what is enough, besides those that find out what that is.
"""

import json
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile

tools = pathlib.Path(sys.argv[1]).resolve()
size = sys.argv[2] if len(sys.argv) > 2 else "1700"
limits = int(sys.argv[3]) if len(sys.argv) > 3 else 12

LEAST = 12 << 20  # bytes of address space
MOST = 1 << 30
STEP = 1 << 18
PAGE = 1 << 12
RANGE = 20 << 20  # how far below what is enough to look
NOT_STARTED = 127


def run(folder, command, limit=None):
    """The exit code, stdout and stderr of a tool, with so many bytes of address space."""
    def little():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if limit:
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

    done = subprocess.run([tools / command[0], *command[1:]], cwd=folder, preexec_fn=little,
                          stdin=subprocess.DEVNULL, capture_output=True, timeout=300)
    return done.returncode, done.stdout, done.stderr


def outputs(folder):
    return {p.name: p.read_bytes() for p in folder.iterdir() if p.name.startswith("out")}


def prepare(folder):
    half = float(size) / 2
    subprocess.run(f"{tools}/skyway-synth --size {size} --seed 3 -o city.csv && "
                   f"{tools}/skyway-import city.csv -q -o city.boxmap", shell=True, check=True,
                   cwd=folder)
    boxes = len((folder / "city.csv").read_text().splitlines()) - 2
    points = [[-0.9 * half, -0.9 * half, 4.0], [0.9 * half, 0.9 * half, 4.0]]
    # Straight through the buildings: what a search that lost them would find.
    (folder / "through.jsonl").write_text(
        json.dumps({"type": "path", "id": "p", "status": "found", "points": points}) + "\n")
    # The same, as a trajectory of one straight segment.
    a, b = points
    control = {axis: [p] * 4 + [q] * 4 for axis, p, q in zip("xyz", a, b)}
    (folder / "through.traj").write_text(json.dumps(
        {"type": "trajectory", "id": "t", "status": "solved",
         "segments": [{"duration": 1000.0, **control}]}) + "\n")
    # A long log and long drone files are made of it: texts that grow while memory runs out.
    (folder / "short.traj").write_text(json.dumps(
        {"type": "trajectory", "id": "s", "status": "solved", "segments": [
            {"duration": 60.0, "x": [0.0] * 4 + [60.0] * 4, "y": [0.0] * 8, "z": [50.0] * 8}]}) + "\n")
    return boxes, points


def refused_well(code, out, err, reference):
    if code == NOT_STARTED or b"error while loading shared libraries" in err:
        return "not started"
    if (code, out) == reference[:2]:
        return "the same"
    if code == 4 and err.strip():
        return "exit 4"
    return None


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        boxes, (a, b) = prepare(folder)
        ends = ["--from", ",".join(map(str, [a[0], a[1], 4.0])),
                "--to", ",".join(map(str, [b[0], b[1], 4.0]))]
        vehicle = ["--vehicle", "box:0.3,0.3,0.2", "--margin", "0.2", "--progress", "none"]
        commands = {
            "plan": ["skyway-plan", "city.boxmap", *ends, "--snap-ends", "30", *vehicle],
            "plan fast": ["skyway-plan", "city.boxmap", *ends, "--snap-ends", "30", "--quality",
                          "fast", *vehicle, "-o", "out.jsonl"],
            "check": ["skyway-check", "city.boxmap", "through.jsonl", *vehicle],
            "check trajectory": ["skyway-check", "city.boxmap", "through.traj", "--vmax", "30",
                                 *vehicle],
            "export": ["skyway-export", "city.boxmap", "through.traj", "--format", "geojson",
                       *vehicle, "-o", "out.geojson"],
            "fly": ["skyway-fly", "short.traj", "--vehicle", "quad2kg", "-q", "-o", "out.csv"],
            "setpoints": ["skyway-export", "short.traj", "--format", "setpoints", "--unchecked", "-q",
                          "--rate", "100", "-o", "out.csv"],
        }
        counts = {}
        for title, command in commands.items():
            for path in folder.glob("out*"):
                path.unlink()
            code, out, err = run(folder, command)
            assert code in (0, 1), (title, code, err)
            reference = (code, out, outputs(folder))
            seen = {}

            def attempt(limit):
                for path in folder.glob("out*"):
                    path.unlink()
                code, out, err = run(folder, command, limit)
                if code == -signal.SIGSEGV and run(folder, [command[0], "--version"], limit)[0] == code:
                    code = NOT_STARTED  # the system's loader, before main(): it does not look at what it is given
                how = refused_well(code, out, err, reference)
                assert how, f"{title} with {limit} bytes: exit {code}\n{out[:600]}\n{err[:600]}"
                left = outputs(folder)
                assert left == (reference[2] if how == "the same" else {}), (title, limit, how)
                assert not list(folder.glob("*.part")), title
                seen[how] = seen.get(how, 0) + 1
                return how

            def least_for(does, step):
                """A limit with which attempts are as they should be, and with a step less are not."""
                least, enough = LEAST, MOST
                while enough - least > step:
                    middle = (least + enough) // 2
                    least, enough = (least, middle) if does(attempt(middle)) else (middle, enough)
                return enough

            # Where memory is just too little something is lost that is needed late.
            enough = least_for(lambda how: how == "the same", STEP)
            least = max(LEAST, enough - RANGE)  # with less the system cannot even map the program
            for k in range(limits):
                attempt(enough - (enough - least) * k // limits)
            # Where the program has just been loaded, there is no memory for an exception either.
            loaded = least_for(lambda how: how != "not started", PAGE)
            for k in range(24):
                attempt(loaded + k * PAGE)
            attempt(MOST)
            assert seen.get("the same"), (title, seen)  # the most is enough
            counts[title] = seen
        print(json.dumps({"boxes": boxes, **counts}))
        assert sum(seen.get("exit 4", 0) for seen in counts.values()) > 0, counts


main()
