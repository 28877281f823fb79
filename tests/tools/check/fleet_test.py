"""fleet_test.py BIN_DIR: a check of many records with many vehicles says the same in any order of the records and for any
number of threads, stops at the first that is wrong as one thread does, and answers each record as it comes; skyway-traj
gives the same for any number of processes, up to the first path that is wrong."""

import json
import os
import random
import subprocess
import sys
import tempfile

bin_dir = sys.argv[1]
random.seed(11)
THREADS = (1, 2, 8)
EPOCH = "2026-05-04T06:30:00Z"


def tool(name, *arguments, text=None, codes=(0,)):
    done = subprocess.run([os.path.join(bin_dir, name), *arguments], input=text, capture_output=True, text=True)
    assert done.returncode in codes, (arguments, done.returncode, done.stderr)
    return done


def flight(number, size):
    """Through the city or above it; some hit a block, some are refused for their speed."""
    a, b = ([random.uniform(-80, 80), random.uniform(-80, 80), random.uniform(2, 90)] for _ in range(2))
    axis = lambda k: [a[k]] * 4 + [b[k]] * 4
    return {"type": "trajectory", "id": f"f{number}", "status": "solved", "epoch": EPOCH, "start": 40 * number,
            "vehicle": {"name": f"box:{size}", "half": [size, size, 0.3]}, "margin": random.choice((0, 0.25)),
            "limits": {"vmax": random.choice((5, 20, 50))},
            "segments": [{"duration": random.uniform(8, 30), "x": axis(0), "y": axis(1), "z": axis(2)}]}


def lines(records):
    return "".join(json.dumps(record) + "\n" for record in records)


def check(text, threads, *options, codes=(0, 1)):
    return tool("skyway-check", "city.boxmap", "-", "--threads", str(threads), *options, text=text, codes=codes)


def of_each(output):
    """By id; what is not about a single record apart."""
    reports = [json.loads(line) for line in output.splitlines()]
    return {report["id"]: report for report in reports if "id" in report}


def same_in_any_order(fleet):
    """More vehicles than scenes are kept."""
    by_vehicle = sorted(fleet, key=lambda record: (record["vehicle"]["half"], record["margin"]))
    sorted_reports = of_each(check(lines(by_vehicle), 1).stdout)
    assert len(sorted_reports) == len(fleet)
    assert len({report.get("reason") for report in sorted_reports.values()}) >= 3  # of all kinds
    for threads in THREADS:
        assert of_each(check(lines(fleet), threads).stdout) == sorted_reports


def same_bytes(fleet):
    for options in ([], ["--report", "text"], ["--exact"], ["--drop-refused", "--together", "--separation", "9,1"]):
        outputs = []
        for threads in THREADS:
            written = [name + str(threads) for name in ("junit", "profile", "why")]
            done = check(lines(fleet), threads, *options, "--junit", written[0], "--profile", written[1],
                         "--certificate", written[2], "--stats", "stats")
            with open("stats", encoding="utf-8") as file:
                stats = json.load(file)
            files = [open(name, encoding="utf-8").read() for name in written]
            outputs.append((done.returncode, done.stdout, done.stderr, files, stats["records"], stats["failed"]))
        assert outputs[0][1] and outputs == [outputs[0]] * len(THREADS), options


def first_error(fleet):
    """Whatever is wrong with a line in the middle: what was written before it, the exit and the message are the same."""
    good = lines(fleet).splitlines()
    other = dict(fleet[0], id="other", map="sha256:" + "0" * 64)
    nameless = {key: value for key, value in fleet[0].items() if key != "vehicle"}
    path = {"type": "path", "id": "p", "status": "found", "points": [[0, 0, 99], [9, 0, 99]],
            "vehicle": fleet[0]["vehicle"], "margin": 0}
    wrong = ['{"type":', "[]", json.dumps(other), json.dumps(dict(nameless, id="nameless")), json.dumps({"id": "x"})]
    together = [json.dumps(path), json.dumps(fleet[3]), json.dumps(dict(fleet[0], id="later", epoch="2027-01-01T00:00:00Z"))]
    for at in (0, 1, 57, len(good) - 1):
        beside = together if at > 3 else []  # what is wrong only beside others
        for options, bad in [([], line) for line in wrong] + [(["--together"], line) for line in wrong + beside]:
            # Another that is wrong comes later, and must not be named.
            text = "\n".join([*good[:at], bad, *good[at:], "?"]) + "\n"
            outputs = set()
            for threads in THREADS:
                done = check(text, threads, *options, codes=(2, 3))
                outputs.add((done.returncode, done.stdout, done.stderr))
            assert len(outputs) == 1, (at, bad, outputs)
            code, reports, message = outputs.pop()
            assert len(reports.splitlines()) == at, (at, bad)
            assert code == 2 or f"stdin:{at + 1}:" in message, (at, bad, message)


def as_it_comes(fleet):
    """Who waits for a report before the next record is written gets it."""
    for threads in THREADS:
        command = [os.path.join(bin_dir, "skyway-check"), "city.boxmap", "-", "--threads", str(threads), "-q"]
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1) as process:
            for record in fleet[:20]:
                process.stdin.write(json.dumps(record) + "\n")
                process.stdin.flush()
                assert json.loads(process.stdout.readline())["id"] == record["id"]
            process.stdin.close()


def trajectories():
    """Of paths above the city, some of which cannot be flown."""
    size = lambda i: 0.3 + 0.1 * (i % 5)
    place = lambda: [random.uniform(-80, 80), random.uniform(-80, 80), random.uniform(202, 225)]
    paths = [{"type": "path", "id": f"p{i}", "status": "found", "points": [place() for _ in range(random.randrange(2, 6))],
              "vehicle": {"name": f"box:{i % 5}", "half": [size(i), size(i), 0.2]}, "margin": 0} for i in range(60)]
    paths[7] = {"type": "path", "id": "p7", "status": "unreachable"}
    paths[9]["points"][0][2] = 0.1  # below the floor
    for at in (None, 0, 1, 33, 60):
        text = lines(paths)
        if at is not None:
            text = lines(paths[:at]) + '{"type":\n' + lines(paths[at:]) + "?\n"
        outputs = set()
        for threads in THREADS:
            done = tool("skyway-traj", "city.boxmap", "-", "--vmax", "6", "--amax", "4", "--threads", str(threads), text=text,
                        codes=(1, 3))
            outputs.add((done.returncode, done.stdout, done.stderr))
        assert len(outputs) == 1, (at, outputs)
        code, written, message = outputs.pop()
        assert len(written.splitlines()) == (60 if at is None else at)
        assert at is not None or 40 < written.count('"status":"solved","duration"') < 60, written.count('"status":"solved","duration"')
        assert (code == 1) == (at is None) and (at is None or f"stdin:{at + 1}:" in message), message


def main():
    tool("skyway-synth", "--size", "200", "--seed", "3", "-o", "city.csv")
    tool("skyway-import", "city.csv", "--ceiling", "230", "-o", "city.boxmap", "-q")
    fleet = [flight(i, 0.3 + 0.01 * random.randrange(90)) for i in range(300)]
    same_in_any_order(fleet)
    same_bytes(fleet[:60])
    first_error(fleet[:120])
    as_it_comes(fleet)
    trajectories()


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    main()
