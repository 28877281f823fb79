"""What the tests of drone files share: the tools, and a map of one tower."""

import pathlib
import subprocess
import tempfile


class OneTower:
    """A folder with `map`: the tower, six numbers, within bounds as skyway-import takes them."""

    def __init__(self, bin_dir, tower, bounds):
        self.bin_dir = pathlib.Path(bin_dir)
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.scratch.name)
        table = self.folder / "tower.csv"
        table.write_text("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n" + ",".join(map(str, tower)) + ",tower\n")
        done = self.run("skyway-import", table, "-q", f"--bounds={bounds}", "-o", self.folder / "map")
        assert done.returncode == 0, done.stderr

    def run(self, *args, **more):
        return subprocess.run([str(self.bin_dir / args[0]), *map(str, args[1:])], capture_output=True, **more)
