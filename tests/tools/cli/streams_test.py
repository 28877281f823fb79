"""streams_test.py BIN_DIR DATA_DIR: every tool with its streams closed, full or broken, and with outputs that
are links, pipes, devices, inputs or each other. Nothing is lost, nothing is half written, nothing aborts.

A tool that is wrong may replace what it should write to. So no device or link of the machine's /dev is ever named as
an output: root, who could lose them, gets nodes and links of the temporary folder.
"""

import concurrent.futures
import os
import pathlib
import re
import resource
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading

bin_dir, data = (pathlib.Path(p).resolve() for p in sys.argv[1:3])
only = sys.argv[3:]
wrong = []
BOX = ["--vehicle", "box:0.3,0.3,0.3"]
LIMITS = ["--vmax", "5", "--amax", "3"]

# How each tool makes one output from files that are made once, in a folder of its own; {} stands for
# the file's name after -o.
TOOLS = {
    "skyway-synth": ["--size", "200"],
    "skyway-import": ["village.csv"],
    "skyway-footprints": ["blocks.geojson", "--allow-skipped", "--default-height", "10"],
    "skyway-cloud": ["cloud.xyz"],
    "skyway-mesh": ["house.obj", "--solid"],
    "skyway-map": ["crop", "m.boxmap", "--bounds", "0,0,0,60,60,60"],
    "skyway-query": ["m.boxmap", "points.jsonl", *BOX],
    "skyway-lattice": ["m.boxmap", *BOX, "--spacing", "10"],
    "skyway-roadmap": ["m.boxmap", *BOX],
    "skyway-plan": ["m.boxmap", *BOX, "--from", "5,30,5", "--to", "70,10,5"],
    "skyway-replan": ["m.boxmap", "p.jsonl"],
    "skyway-traj": ["m.boxmap", "p.jsonl", *LIMITS, "--solver", "stop-and-go"],
    "skyway-fleet": ["t.jsonl"],
    "skyway-check": ["m.boxmap", "t.jsonl"],
    "skyway-fly": ["t.jsonl", "--vehicle", "quad.json"],
    "skyway-export": ["m.boxmap", "t.jsonl", "--format", "crazyflie"],
    "skyway-import-flight": ["hop.ulg"],
    "skyway-import-trajectory": ["c.csv"],
    "skyway-render": ["m.boxmap", "--view", "plan", "--image-size", "64x48"],
    "skyway-plot": ["plan", "m.boxmap"],
    "skyway-view": ["m.boxmap", "p.jsonl"],
    "skyway-bench": ["m.boxmap", *BOX, "--queries", "q.jsonl", "--method", "auto", "--repeat", "1"],
    "skyway-join": ["s1", "s2"],
}
# Two outputs beside -o, where a tool has them.
SIDE = {
    "skyway-check": ["--certificate", "--profile", "--stats"],
    "skyway-plan": ["--tree", "--stats"],
    "skyway-traj": ["--corridor-file", "--stats"],
    "skyway-fleet": ["--report-file", "--stats"],
    "skyway-fly": ["--report-file", "--stats"],
    "skyway-render": ["--depth", "--ids", "--stats"],
}
INPUT = {"skyway-synth": None}  # the input that an output may not be; by default the first file named


def expect(what, condition, more=""):
    if not condition:
        wrong.append(f"{what}: {more}".strip())


class Run:
    def __init__(self, folder, tool, *arguments, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                 stderr=subprocess.PIPE, before=None, pass_fds=()):
        done = subprocess.run([bin_dir / tool, *arguments], cwd=folder, stdin=stdin, stdout=stdout, stderr=stderr,
                              preexec_fn=before, pass_fds=pass_fds, timeout=100, env={**os.environ, "LC_ALL": "C"})
        self.code = done.returncode
        self.out = done.stdout or b""
        self.err = (done.stderr or b"").decode(errors="replace")

    def __repr__(self):
        return f"exit {self.code}: {self.err.strip()[:300]}"


def close(*descriptors):
    return lambda: [os.close(d) for d in descriptors]


def ok(run):
    """Ended by itself with the answer that the tool gives in peace."""
    return run.code == 0


def must(folder, tool, *arguments):
    run = Run(folder, tool, *arguments)
    if run.code != 0:
        sys.exit(f"streams_test.py: {tool} {arguments}: {run}")
    return run


def prepare(folder):
    for name in ("village.csv", "blocks.geojson", "hop.ulg", "quad.json"):
        shutil.copy(data / name, folder)
    (folder / "points.jsonl").write_text('{"point":[1,1,1]}\n{"point":[20,20,15]}\n')
    (folder / "q.jsonl").write_text('{"id":"a","from":[5,30,5],"to":[70,10,5]}\n{"id":"b","from":[5,5,5],"to":[70,10,5]}\n')
    (folder / "cloud.xyz").write_text("".join(f"{x} {y} {z}\n" for x in range(4) for y in range(4) for z in range(4)))
    (folder / "house.obj").write_text("v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n")
    must(folder, "skyway-import", "village.csv", "-o", "m.boxmap", "-q", "--bounds", "0,0,0,80,60,60")
    plan = ["m.boxmap", *BOX, "--queries", "q.jsonl"]
    must(folder, "skyway-plan", "m.boxmap", *BOX, "--from", "5,30,5", "--to", "70,10,5", "-o", "p.jsonl")
    must(folder, "skyway-plan", *plan, "--shard", "1/2", "-o", "s1")
    must(folder, "skyway-plan", *plan, "--shard", "2/2", "-o", "s2")
    must(folder, "skyway-traj", "m.boxmap", "p.jsonl", *LIMITS, "-o", "t.jsonl")
    must(folder, "skyway-export", "m.boxmap", "t.jsonl", "--format", "crazyflie", "-o", "c.csv")


def no_parts(folder, what):
    parts = [p.name for p in folder.iterdir() if p.name.endswith(".part")]
    expect(what, not parts, f"left {parts} behind")


def streams(tool, folder):
    """stdin, stdout and stderr closed, full or without a reader."""
    arguments = TOOLS[tool]
    full = open("/dev/full", "w")
    run = Run(folder, tool, *arguments, "-o", "peace")
    expect(f"{tool}: in peace", ok(run), run)
    wanted = (folder / "peace").read_bytes()
    writes = {tool: [*arguments, "-o", "out"]}[tool]

    def whole(what, run, name="out"):
        expect(f"{tool}: {what}", ok(run), run)
        there = folder / name
        expect(f"{tool}: {what}: the output", there.exists() and (varies(tool) or there.read_bytes() == wanted))
        there.unlink(missing_ok=True)

    whole("stdin, stdout and stderr closed, -o", Run(folder, tool, *writes, stdin=None, stdout=None, stderr=None,
                                                     before=close(0, 1, 2)))
    whole("stderr closed, progress asked for", Run(folder, tool, *writes, "--progress", "json", stderr=None,
                                                   before=close(2)))
    whole("stderr full, progress asked for", Run(folder, tool, *writes, "--progress", "json", stderr=full))
    reader, writer = os.pipe()
    os.close(reader)
    whole("stderr without a reader", Run(folder, tool, *writes, "--progress", "json", stderr=writer))
    os.close(writer)

    run = Run(folder, tool, *arguments, stdout=None, before=close(1))
    expect(f"{tool}: stdout closed", run.code == 4 and "cannot write stdout" in run.err, run)
    run = Run(folder, tool, *arguments, stdout=full)
    expect(f"{tool}: stdout full", run.code == 4 and "No space left" in run.err, run)
    run = Run(folder, tool, *arguments, stdout=None, stderr=None, before=close(1, 2))
    expect(f"{tool}: stdout and stderr closed", run.code == 4, run)
    reader, writer = os.pipe()
    os.close(reader)
    run = Run(folder, tool, *arguments, "-q", stdout=writer)
    expect(f"{tool}: stdout without a reader", run.code == -signal.SIGPIPE and not run.err, run)
    os.close(writer)
    for word in (["--help"], ["--version"], ["--completion", "bash"], ["--completion", "zsh"]):
        run = Run(folder, tool, *word, stdout=full)
        expect(f"{tool} {word[0]} > /dev/full", run.code == 4 and "No space left" in run.err, run)
        run = Run(folder, tool, *word, stdout=None, before=close(1))
        expect(f"{tool} {word[0]}, stdout closed", run.code == 4, run)
        run = Run(folder, tool, *word)
        expect(f"{tool} {word[0]}", ok(run) and run.out and not run.err, run)
    run = Run(folder, tool, "--no-such-option", stderr=full)
    expect(f"{tool}: wrong usage, stderr full", run.code == 2, run)
    no_parts(folder, f"{tool}: streams")


def varies(tool):
    return tool in ("skyway-bench", "skyway-fly", "skyway-view")


def limits(tool, folder):
    """No room for the output: nothing half written, and what was there stays."""
    arguments = TOOLS[tool]
    (folder / "kept").write_text("kept\n")

    def small():
        resource.setrlimit(resource.RLIMIT_FSIZE, (64, 64))

    run = Run(folder, tool, *arguments, "-o", "kept", before=small)
    expect(f"{tool}: a file that may not grow", run.code == 4 and "File too large" in run.err, run)
    expect(f"{tool}: a file that may not grow: kept", (folder / "kept").read_bytes() == b"kept\n")
    full = device(folder, "full", 7)
    if full:
        run = Run(folder, tool, *arguments, "-o", full)
        expect(f"{tool}: -o /dev/full", run.code == 4 and "No space left" in run.err, run)
        # The main output is written, what stands beside it cannot be: neither appears.
        run = Run(folder, tool, *arguments, "-o", "alone", "--stats", full)
        expect(f"{tool}: --stats /dev/full", run.code == 4 and not (folder / "alone").exists(), run)
    run = Run(folder, tool, *arguments, "-o", "no/such/folder")
    expect(f"{tool}: no such folder", run.code == 4 and "cannot write no/such/folder" in run.err, run)
    run = Run(folder, tool, *arguments, "-o", ".")
    expect(f"{tool}: a folder", run.code == 4 and "cannot write ." in run.err, run)
    run = Run(folder, tool, *arguments, "-o", "")
    expect(f"{tool}: an empty name", run.code == 2 and "empty" in run.err, run)
    no_parts(folder, f"{tool}: limits")


def outputs(tool, folder):
    """Links, pipes, devices and descriptors as outputs."""
    arguments = TOOLS[tool]
    Run(folder, tool, *arguments, "-o", "peace")
    wanted = (folder / "peace").read_bytes()

    def same(what, run, got):
        expect(f"{tool}: {what}", ok(run), run)
        expect(f"{tool}: {what}: the bytes", varies(tool) or got == wanted, f"{len(got)} for {len(wanted)}")

    (folder / "target").write_text("old")
    (folder / "target").chmod(0o640)
    (folder / "link").symlink_to("target")
    (folder / "link2").symlink_to(folder / "link")
    run = Run(folder, tool, *arguments, "-o", "link2")
    same("a link to a link", run, (folder / "target").read_bytes())
    expect(f"{tool}: links stay", (folder / "link").is_symlink() and (folder / "link2").is_symlink())
    expect(f"{tool}: permissions stay", (folder / "target").stat().st_mode & 0o777 == 0o640)
    (folder / "dangling").symlink_to("made")
    run = Run(folder, tool, *arguments, "-o", "dangling")
    same("a dangling link", run, (folder / "made").read_bytes() if (folder / "made").exists() else b"")
    expect(f"{tool}: a dangling link stays", (folder / "dangling").is_symlink())
    (folder / "round").symlink_to("round")
    run = Run(folder, tool, *arguments, "-o", "round")
    expect(f"{tool}: a link to itself", run.code == 4 and (folder / "round").is_symlink(), run)

    os.mkfifo(folder / "pipe")
    got = []
    reader = threading.Thread(target=lambda: got.append((folder / "pipe").read_bytes()))
    reader.start()
    run = Run(folder, tool, *arguments, "-o", "pipe")
    reader.join(20)
    same("a named pipe", run, b"".join(got))
    expect(f"{tool}: a named pipe stays", (folder / "pipe").is_fifo())

    with open(folder / "third", "wb") as third:
        run = Run(folder, tool, *arguments, "-o", f"/proc/self/fd/{third.fileno()}", pass_fds=[third.fileno()])
        same("/proc/self/fd/N", run, (folder / "third").read_bytes())
    # As /dev/stdout and /dev/stderr are links.
    (folder / "stdout").symlink_to("/proc/self/fd/1")
    (folder / "stderr").symlink_to("/proc/self/fd/2")
    for name in ("stdout", "/proc/self/fd/1"):
        run = Run(folder, tool, *arguments, "-o", name)
        same(name, run, run.out)
    with open(folder / "appended", "wb") as file:
        file.write(b"before\n")
        file.flush()
        run = Run(folder, tool, *arguments, "-o", "stdout", stdout=file)
    same("a link to stdout, a file", run, (folder / "appended").read_bytes().removeprefix(b"before\n"))
    run = Run(folder, tool, *arguments, "-o", "out", "--stats", "stderr", "-q")
    expect(f"{tool}: --stats to a link to stderr", ok(run) and run.err.startswith("{"), run)
    expect(f"{tool}: links to descriptors stay", (folder / "stdout").is_symlink() and (folder / "stderr").is_symlink())
    null = device(folder, "null", 3)
    if null:
        run = Run(folder, tool, *arguments, "-o", null, "--stats", null)
        expect(f"{tool}: /dev/null twice", ok(run) and pathlib.Path(null).is_char_device(), run)
    no_parts(folder, f"{tool}: outputs")


def device(folder, name, minor):
    """A /dev/null or /dev/full that this test may lose; nothing where root may not make one."""
    if os.geteuid() != 0:
        return f"/dev/{name}"
    try:
        if not (folder / name).exists():
            os.mknod(folder / name, 0o666 | 0o020000, os.makedev(1, minor))
        with open(folder / name, "w"):
            return str(folder / name)
    except OSError:
        return None


def numbers(tool, folder):
    """Numbers that are none, units behind them, and values that are empty."""
    arguments = TOOLS[tool]
    verb = arguments[:1] if tool in ("skyway-map", "skyway-plot") else []
    text = subprocess.run([bin_dir / tool, *verb, "--help" if verb else "--help-all"], capture_output=True, text=True, check=True).stdout
    options = re.findall(r"^  (?:-\w, )?(--[\w-]+) (?:METRES|SECONDS|DEGREES|PERCENT|SHARE|FACTOR|HERTZ|NUMBER|PER-SECOND|LENGTH|X,Y,Z|X0|LAT|P,V)", text, re.M)
    for option in options:
        at = arguments.index(option) if option in arguments else len(arguments)
        rest = arguments[:at] + arguments[at + 2:]
        for value in ("nan", "inf", "-inf", "1e999", "5mm", "5 m", ""):
            run = Run(folder, tool, *rest, f"{option}={value}" if value else option, *([] if value else [""]), "-o", "n")
            # Behind "=" or as a word of its own; "At most 1" where an option is already there.
            expect(f"{tool} {option} {value!r}", run.code == 2 and option in run.err, run)
            expect(f"{tool} {option} {value!r}: written", not (folder / "n").exists())
            (folder / "n").unlink(missing_ok=True)
    if "--threads" in text:
        for value in ("0", "-1", "1.5", "two"):
            run = Run(folder, tool, *arguments, "--threads", value, "-o", "n")
            expect(f"{tool} --threads {value}", run.code == 2, run)
    for extra in (["--stats", "a", "--stats", "b"], ["-o", "a", "--output", "b"], [""], ["--stats", ""]):
        run = Run(folder, tool, *arguments, *extra)
        expect(f"{tool} {extra}", run.code == 2, run)


def first_input(tool):
    return next((a for a in TOOLS[tool] if "." in a and not a.startswith("-") and not a[0].isdigit()), None)


def collisions(tool, folder):
    """Two outputs that are one file, and outputs that are inputs."""
    arguments = TOOLS[tool]
    (folder / "x").write_text("old")
    (folder / "sub").mkdir()
    os.link(folder / "x", folder / "hard")
    (folder / "soft").symlink_to("x")
    (folder / "ahead").symlink_to("new")
    (folder / "stdout").symlink_to("/proc/self/fd/1")
    for option in SIDE.get(tool, ["--stats"]):
        png = ".png" if option in ("--depth", "--ids") else ""
        names = [("x", "x"), ("x", "./x"), ("x", "sub/../x"), ("x", "hard"), ("x", "soft"), ("new", "new"),
                 ("new", "./new"), ("new", str(folder / "new")), ("new", "ahead"), ("-", "-"), ("-", "stdout"),
                 ("/proc/self/fd/1", "stdout")]
        if png:
            names = [("y.png", "y.png"), ("y.png", "./y.png")]
        for main, other in names:
            run = Run(folder, tool, *arguments, "-o", main, option, other)
            expect(f"{tool} -o {main} {option} {other}", run.code == 2 and "two outputs go to one file" in run.err, run)
        if not png:
            with open(folder / "all", "wb") as file:
                run = Run(folder, tool, *arguments, option, "all", stdout=file)
            expect(f"{tool} {option} all > all", run.code == 2, run)
    expect(f"{tool}: collisions: x", (folder / "x").read_bytes() == b"old")
    expect(f"{tool}: collisions: new", not (folder / "new").exists() and not (folder / "y.png").exists())
    source = first_input(tool)
    if tool == "skyway-join":
        source = "s1"
    if not source:
        return
    before = (folder / source).read_bytes()
    # Pictures are refused by other names, too.
    ending = {"skyway-plot": ".svg", "skyway-render": ".png"}.get(tool, "")
    hard, soft = (kind + source + ending for kind in ("hard-", "soft-"))
    os.link(folder / source, folder / hard)
    (folder / soft).symlink_to(source)
    for name in (source, "./" + source, hard, soft):
        run = Run(folder, tool, *arguments, "-o", "fresh", "--stats", name)
        expect(f"{tool} --stats {name}", run.code == 2 and "is the input" in run.err, run)
        expect(f"{tool} --stats {name}: nothing written", not (folder / "fresh").exists())
        if tool != "skyway-map":
            run = Run(folder, tool, *arguments, "-o", name)
            why = "a name that ends in" if not name.endswith(ending) else "is the input"
            expect(f"{tool} -o {name}", run.code == 2 and why in run.err, run)
    if tool != "skyway-map":
        with open(folder / source, "ab") as file:
            run = Run(folder, tool, *arguments, stdout=file)
        expect(f"{tool} >> {source}", run.code == 2 and "is the input" in run.err, run)
    expect(f"{tool}: collisions: the input", (folder / source).read_bytes() == before)
    no_parts(folder, f"{tool}: collisions")


def broken_inputs(folder):
    """What is no file, or breaks off, never reads as an end."""
    run = Run(folder, "skyway-check", "m.boxmap", ".")
    expect("an input that is a folder", run.code == 4 and "cannot read .: Is a directory" in run.err, run)
    directory = os.open(folder, os.O_RDONLY)
    run = Run(folder, "skyway-check", "m.boxmap", stdin=directory)
    expect("stdin is a folder", run.code == 4 and "cannot read stdin: Is a directory" in run.err, run)
    os.close(directory)
    run = Run(folder, "skyway-check", "m.boxmap", stdin=None, before=close(0))
    expect("stdin closed", run.code == 4 and "cannot read stdin" in run.err, run)
    ours, theirs = socket.socketpair()
    ours.sendall((folder / "t.jsonl").read_bytes())
    # A connection that is reset is an error, not an end.
    server = socket.create_server(("127.0.0.1", 0))
    client = socket.create_connection(server.getsockname())
    peer, _ = server.accept()
    peer.sendall((folder / "t.jsonl").read_bytes())
    peer.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")
    client.sendall(b"unread, so that closing resets")
    peer.close()
    run = Run(folder, "skyway-check", "m.boxmap", stdin=client)
    expect("stdin that is reset", run.code == 4 and "cannot read stdin" in run.err, run)
    del ours, theirs
    piped = subprocess.run(["bash", "-c", f"{bin_dir}/skyway-fly <(cat t.jsonl) --vehicle quad.json -o piped.csv"],
                           cwd=folder, capture_output=True, check=False)
    expect("trajectories from a pipe by name", piped.returncode == 0, piped.stderr)


def in_place(folder):
    """Maps, patched artefacts and replanned paths may take the place of what they came from."""
    (folder / "own").mkdir()
    own = folder / "own"
    for name in ("m.boxmap", "p.jsonl"):
        shutil.copy(folder / name, own)
    run = Run(own, "skyway-map", "crop", "m.boxmap", "--bounds", "0,0,0,79,60,60", "-o", "m.boxmap")
    expect("crop in place", ok(run), run)
    expect("crop in place: a map", ok(Run(own, "skyway-info", "m.boxmap", "--verify")))
    run = Run(own, "skyway-replan", "m.boxmap", "p.jsonl", "-o", "p.jsonl")
    expect("replan in place", ok(run), run)
    run = Run(own, "skyway-replan", "m.boxmap", "p.jsonl", "-o", "m.boxmap")
    expect("replan over the map", run.code == 2, run)


def changed_inputs(folder):
    """What is written to while it is read is refused; what another file takes the name of is not."""
    line = (folder / "p.jsonl").read_text().splitlines()[0] + "\n"
    for change, code in (("none", 0), ("written to", 4), ("replaced", 0)):
        many = folder / "many.jsonl"
        many.write_text(20000 * line)
        tool = subprocess.Popen([bin_dir / "skyway-check", "m.boxmap", many.name], cwd=folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE)
        tool.stdout.readline()  # it works, and waits until somebody reads on: the pipe takes a part of its answers
        if change == "written to":
            with many.open("a") as more:
                more.write(line)
        elif change == "replaced":
            (folder / "other.jsonl").write_text(line)
            (folder / "other.jsonl").replace(many)
        err = tool.communicate()[1].decode()
        expect(f"an input that is {change}", tool.returncode == code, err)
        expect(f"an input that is {change}", ("was changed while it was read" in err) == (code == 4), err)


def cut_streams(folder):
    """Of a tool of a pipe that fails or is killed, the next one takes no part for the whole."""
    path, trajectory = ((folder / name).read_text() for name in ("p.jsonl", "t.jsonl"))
    traj = ["m.boxmap", "-", *LIMITS, "--solver", "stop-and-go"]

    def refused(what, first, text):
        run = Run(folder, first[0], *first[1:], stdin=text_file(folder, text))
        expect(f"{what}: itself", run.code == 3, run)
        (folder / "cut").write_bytes(run.out)
        after = Run(folder, "skyway-check", "m.boxmap", "cut", "-q")
        expect(f"{what}: the next", after.code == 3, after)

    refused("traj, a malformed record", ["skyway-traj", *traj], path * 3 + "{\n")
    refused("fly, a malformed record", ["skyway-fly", "-", "--vehicle", "quad.json"], trajectory * 3 + "{\n")
    killed = subprocess.Popen([bin_dir / "skyway-traj", *traj], cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL)
    killed.stdin.write((path * 3).encode())
    killed.stdin.flush()
    begin = killed.stdout.read(1)  # the first trajectory is there
    killed.kill()
    (folder / "cut").write_bytes(begin + killed.stdout.read())
    killed.stdin.close()
    killed.wait()
    run = Run(folder, "skyway-check", "m.boxmap", "cut", "-q")
    expect("traj, killed: the next", run.code == 3, run)


def text_file(folder, text):
    (folder / "text").write_text(text)
    return open(folder / "text", "rb")


def left_behind(folder):
    """A temporary file of a process that was killed is removed; one of a process that runs is not."""
    host = socket.gethostname()
    gone = subprocess.Popen(["true"])
    gone.wait()
    dead = folder / f"r.boxmap.{host}.{gone.pid}.part"
    alive = folder / f"r.boxmap.{host}.{os.getpid()}.part"
    other = folder / f"r.boxmap.elsewhere.{gone.pid}.part"
    for path in (dead, alive, other):
        path.write_text("half")
    must(folder, "skyway-import", "village.csv", "-o", "r.boxmap", "-q")
    expect("a temporary file of a dead process", not dead.exists())
    expect("a temporary file of another's", alive.exists() and other.exists())
    for path in (alive, other):
        path.unlink()


def hostile_text(folder):
    """Control characters and raw bytes of files and names never reach the terminal."""
    escape = "\x1b[31mred\x07"
    cases = {
        "a record's id": ("skyway-check", ["m.boxmap", "e.jsonl"], '{"type":"path","id":"%s","status":5}' % "\\u001b[2J"),
        "a record's type": ("skyway-check", ["m.boxmap", "e.jsonl"], '{"type":"\\u001b[2J\\n","id":"x"}'),
        "a raw escape": ("skyway-check", ["m.boxmap", "e.jsonl"], escape),
        "a table": ("skyway-import", ["e.jsonl", "--format", "fcnd", "-o", "out"], f"posX,{escape},posZ\n1,2,3\n"),
        "a block text": ("skyway-import", ["e.jsonl", "--format", "block-text", "-o", "out"], f"block {escape}\n"),
        "a query": ("skyway-plan", ["m.boxmap", "--queries", "e.jsonl", *BOX], f'{{"id":"a","from":"{escape}"}}'),
        "a CSV query": ("skyway-plan", ["m.boxmap", "--queries", "e.jsonl", *BOX], f"id,from_x\n{escape},1\n"),
        "a world": ("skyway-import", ["e.jsonl", "--format", "world-json", "-o", "out"],
                    '{"bounds":{"extents":"\\u001b[2J"}}'),
        "a flight log": ("skyway-plot", ["tracking", "e.jsonl"], f"id,t_s,{escape}\n1,2,3\n"),
    }
    for what, (tool, arguments, text) in cases.items():
        (folder / "e.jsonl").write_text(text)
        run = Run(folder, tool, *arguments)
        bad = [c for c in run.err if ord(c) < 32 and c != "\n"]
        expect(f"{what} with escapes", run.code in (2, 3) and not bad and run.err, run)
        expect(f"{what} with escapes: lines", run.err.count("\n") <= 2, run)
    (folder / "b.bin").write_bytes(bytes(range(256)) * 40)
    for tool, arguments in {"skyway-check": ["m.boxmap", "b.bin"], "skyway-import": ["b.bin", "-o", "out"],
                            "skyway-cloud": ["b.bin", "-o", "out"], "skyway-mesh": ["b.bin", "-o", "out"], "skyway-query": ["m.boxmap", "b.bin", *BOX],
                            "skyway-view": ["b.bin", "-o", "out"], "skyway-info": ["b.bin"],
                            "skyway-import-flight": ["b.bin"],
                            "skyway-import-trajectory": ["b.bin"], "skyway-join": ["b.bin"],
                            "skyway-footprints": ["b.bin", "-o", "out"]}.items():
        run = Run(folder, tool, *arguments)
        bad = [c for c in run.err if (ord(c) < 32 and c != "\n") or ord(c) == 127 or c == "\ufffd"]
        expect(f"{tool}: a binary", run.code == 3 and not bad and len(run.err) < 1000, run)
    name = "a\x1b[2Jb\nskyway-check: ok"
    run = Run(folder, "skyway-check", name, "t.jsonl")
    expect("a name with escapes", run.code == 4 and "\x1b" not in run.err and run.err.count("\n") == 1, run)
    run = Run(folder, "skyway-check", "x" * 100000, "t.jsonl")
    expect("a name that goes on for ever", len(run.err) < 3000, run)


def idle_options(folder):
    """Options that would change nothing are refused."""
    plan = ["m.boxmap", *BOX, "--from", "5,30,5", "--to", "70,10,5"]
    export = ["m.boxmap", "t.jsonl", "--format"]
    for tool, arguments in (
            ("skyway-plan", [*plan, "--step", "5"]), ("skyway-plan", [*plan, "--seed", "1", "--method", "astar"]),
            ("skyway-plan", [*plan, "--spacing", "5"]), ("skyway-plan", [*plan, "--connect", "6", "--method", "rrt"]),
            ("skyway-plan", [*plan, "--method", "rrt", "--radius", "5"]),
            ("skyway-check", ["m.boxmap", "t.jsonl", "--profile-step", "1"]),
            ("skyway-check", ["m.boxmap", "t.jsonl", "--origin", "37,-122,0"]),
            ("skyway-check", ["m.boxmap", "t.jsonl", "--heading", "10"]),
            ("skyway-export", [*export, "crazyflie", "--rate", "10"]),
            ("skyway-export", [*export, "crazyflie", "--speed", "1"]),
            ("skyway-export", [*export, "kml", "--heading", "10"]),
            ("skyway-export", ["t.jsonl", "--unchecked", "--format", "kml", "--margin", "1"]),
            ("skyway-import", ["village.csv", "--unknown", "blocked"]),
            ("skyway-fly", ["t.jsonl", "--vehicle", "quad.json", "--cost", "rms"]),
            ("skyway-render", ["m.boxmap", "--view", "plan", "--azimuth", "3"]),
            ("skyway-render", ["m.boxmap", "--view", "plan", "--rate", "3"])):
        run = Run(folder, tool, *arguments, "-o", "idle")
        expect(f"{tool} {arguments[-2:]}", run.code == 2 and "would change nothing" in run.err, run)
        expect(f"{tool} {arguments[-2:]}: written", not (folder / "idle").exists())


def front(folder):
    """skyway itself."""
    full = open("/dev/full", "w")
    for word in (["--help"], ["--version"], ["--completion", "bash"]):
        run = Run(folder, "skyway", *word, stdout=full)
        expect(f"skyway {word[0]} > /dev/full", run.code == 4, run)
        run = Run(folder, "skyway", *word, stdout=None, before=close(1))
        expect(f"skyway {word[0]}, stdout closed", run.code == 4, run)
    run = Run(folder, "skyway", "nonsense", stderr=full)
    expect("skyway nonsense, stderr full", run.code == 2, run)
    run = Run(folder, "skyway", "info", "m.boxmap", stdout=None, before=close(1))
    expect("skyway info, stdout closed", run.code == 4, run)
    for arguments in (["m.boxmap"], ["t.jsonl"]):
        run = Run(folder, "skyway-info", *arguments, stdout=full)
        expect("skyway-info > /dev/full", run.code == 4, run)


def main():
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        (root / "base").mkdir()
        prepare(root / "base")
        jobs = [(kind, tool) for tool in TOOLS for kind in (streams, limits, outputs, collisions, numbers)]
        jobs += [(kind, None) for kind in (broken_inputs, in_place, changed_inputs, cut_streams, left_behind, hostile_text, idle_options, front)]

        def work(job):
            kind, tool = job
            if only and kind.__name__ not in only and tool not in only:
                return
            folder = root / f"{kind.__name__}-{tool}"
            shutil.copytree(root / "base", folder)
            kind(*([tool, folder] if tool else [folder]))

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for done in [pool.submit(work, job) for job in jobs]:
                try:
                    done.result()
                except (OSError, subprocess.TimeoutExpired) as error:
                    wrong.append(str(error))
    for line in wrong:
        print(line)
    print(f"{len(wrong)} wrong")
    sys.exit(bool(wrong))


main()
