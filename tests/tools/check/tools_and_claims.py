"""What the tests of certificates share: the tools, maps of given boxes, and claims that are changed and refused."""

import copy
import json
import os
import pathlib
import subprocess

from verify_certificate import Refused


class Tools:
    def __init__(self, bin_dir):
        self.bin_dir = os.path.abspath(bin_dir)

    def __call__(self, *arguments, text=None):
        """Runs one; it must answer, with yes or no. What it says."""
        done = subprocess.run([os.path.join(self.bin_dir, arguments[0]), *arguments[1:]], input=text, capture_output=True, text=True)
        assert done.returncode in (0, 1), done.stderr
        return done.stdout

    def make_map(self, folder, name, side, boxes):
        """A cube from the origin, with boxes of six numbers."""
        rows = ["min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label"] + [",".join(map(repr, box)) + "," for box in boxes]
        table = pathlib.Path(folder) / "boxes.csv"
        table.write_text("\n".join(rows) + "\n")
        self("skyway-import", table, "-q", "--bounds", f"0,0,0,{side},{side},{side}", "-o", name)


def objects(text):
    return [json.loads(line) for line in text.splitlines()]


def changed(claim, change):
    out = copy.deepcopy(claim)
    change(out)
    return out


def refused(verify, *claims):
    try:
        verify(*claims)
        return False
    except Refused:
        return True
