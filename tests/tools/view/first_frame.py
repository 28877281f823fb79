"""first_frame.py PAGE ...: CPU seconds of the whole browser from opening a page of skyway-view to its first frame, pixels read back.

Drawn in software, so that figures of machines without a GPU compare; a page of one box takes about one second of it.
"""

import os
import pathlib
import sys
import time

from webdriver import Browser

LONGEST = 120  # seconds of CPU


def cpu_of_children(pid):
    """User and system time of all processes below this one."""
    children = {}
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rsplit(")", 1)[1].split()
        except OSError:
            continue  # it ended meanwhile
        seconds = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
        children.setdefault(int(fields[1]), []).append((int(stat.parent.name), seconds))
    total, open_ends = 0, [pid]
    while open_ends:
        for child, seconds in children.get(open_ends.pop(), []):
            total += seconds
            open_ends.append(child)
    return total


def first_frame(page):
    """CPU seconds, or None where there was no frame in time."""
    with Browser() as browser:
        browser.prefer("light")
        time.sleep(1)  # until it has started
        before = cpu_of_children(os.getpid())
        spent = lambda: cpu_of_children(os.getpid()) - before
        browser.open(page)
        while not browser.run("return Boolean(window.skyway && skyway.frames > 0)"):
            if spent() > LONGEST:
                return None
            time.sleep(0.05)
        browser.run("const gl = document.querySelector('#view canvas').getContext('webgl');"
                    "gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4))")
        return spent()


if __name__ == "__main__":
    for page in sys.argv[1:]:
        seconds = first_frame(page)
        size = os.path.getsize(page) / 1e6
        print(f"{page}: {size:.1f} MB, " + (f"first frame after {seconds:.1f} s of CPU" if seconds else f"no frame in {LONGEST} s of CPU"))
