"""A map that is cut, or written to, while a tool has it mapped: exit 4 and a line that names it."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

tools = pathlib.Path(sys.argv[1]).resolve()
VEHICLE = ["--vehicle", "sphere:0.5"]
QUERY = b'{"id":"q","from":[10,10,50],"to":[500,500,50]}\n'
PATH = (b'{"type":"path","id":"p","status":"found","points":[[10,10,150],[500,500,150]]}\n')
POINT = b'{"point":[10,10,50]}\n'


def is_open(process, name):
    """Whether the process has the file mapped."""
    try:
        return name in pathlib.Path(f"/proc/{process.pid}/maps").read_text()
    except OSError:
        return False


def run(folder, command, text, harm):
    """Starts the tool, which waits for its queries; harms its map; then sends them."""
    process = subprocess.Popen([tools / command[0], *command[1:]], cwd=folder,
                               stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE)
    for _ in range(3000):
        if is_open(process, "city.boxmap"):
            break
        time.sleep(0.01)
    time.sleep(0.3)  # until it waits
    harm(folder / "city.boxmap")
    out, err = process.communicate(text, timeout=120)
    return process.returncode, out, err.decode()


def cut_to(size):
    return lambda path: os.truncate(path, size)


def cut_by(count):
    """Within the last page, which reads as zeros then: the system sends no signal."""
    return lambda path: os.truncate(path, path.stat().st_size - count)


def overwrite(path):
    with open(path, "r+b") as file:
        file.seek(2000)
        file.write(b"\0" * 8)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run(f"{tools}/skyway-synth --size 2600 -o city.csv && "
                       f"{tools}/skyway-import city.csv -q -o whole.boxmap", shell=True,
                       check=True, cwd=folder)
        whole = (folder / "whole.boxmap").read_bytes()
        common = ["city.boxmap", "-", *VEHICLE, "--progress", "none"]
        cases = {
            "query": (["skyway-query", *common, "-o", "out"], POINT),
            "query to stdout": (["skyway-query", *common], POINT),
            "plan": (["skyway-plan", "city.boxmap", "--queries", "-", *VEHICLE, "-o", "out"],
                     QUERY),
            "plan on threads": (["skyway-plan", "city.boxmap", "--queries", "-", *VEHICLE,
                                 "--threads", "3", "-o", "out"],
                                b"".join(QUERY.replace(b'"q"', b'"q%d"' % i) for i in range(9))),
            "check": (["skyway-check", *common, "-o", "out"], PATH),
            "traj on threads": (["skyway-traj", *common, "--threads", "2", "--vmax", "9",
                                   "--amax", "4", "-o", "out"],
                                  PATH + PATH.replace(b'"p"', b'"p2"')),
        }
        tried = 0
        for title, (command, text) in cases.items():
            for harm in (cut_to(4096), cut_to(100000), cut_to(0), cut_by(1), overwrite):
                (folder / "city.boxmap").write_bytes(whole)
                code, out, err = run(folder, command, text, harm)
                assert code == 4, (title, code, out[:300], err)
                assert "city.boxmap was" in err, (title, err)
                assert b'"found"' not in out and b'"ok":true' not in out, (title, out)
                left = sorted(p.name for p in folder.iterdir())
                assert left == ["city.boxmap", "city.csv", "whole.boxmap"], (title, left)
                tried += 1

        # Any other SIGBUS does what it always did.
        (folder / "city.boxmap").write_bytes(whole)
        process = subprocess.Popen([tools / "skyway-query", *common], cwd=folder,
                                   stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
        while not is_open(process, "city.boxmap"):
            time.sleep(0.01)
        process.send_signal(signal.SIGBUS)
        assert process.wait(60) == -signal.SIGBUS, process.returncode
        process.stdin.close()
        print(f"{tried} cut or changed maps refused")


main()
