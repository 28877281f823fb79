"""What the tests of skyway-plan's certificates share: the tools, and maps of given boxes."""

import os
import pathlib
import subprocess


class Tools:
    def __init__(self, bin_dir):
        self.bin_dir = os.path.abspath(bin_dir)

    def __call__(self, *arguments):
        """Runs one; it must answer, with yes or no."""
        done = subprocess.run([os.path.join(self.bin_dir, arguments[0]), *arguments[1:]], capture_output=True, text=True)
        assert done.returncode in (0, 1), done.stderr
        return done

    def make_map(self, folder, name, side, boxes):
        """A cube from the origin, with boxes of six numbers."""
        rows = ["min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label"] + [",".join(map(repr, box)) + "," for box in boxes]
        table = pathlib.Path(folder) / "boxes.csv"
        table.write_text("\n".join(rows) + "\n")
        self("skyway-import", table, "-q", "--bounds", f"0,0,0,{side},{side},{side}", "-o", name)
