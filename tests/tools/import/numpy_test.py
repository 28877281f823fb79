"""numpy_test.py BIN_DIR DATA_DIR: NumPy opens a map and a lattice as they stand, and agrees with the tools."""

import json
import os
import subprocess
import sys
import tempfile
import zipfile

import numpy

bin_dir, data_dir = sys.argv[1:3]


def tool(*arguments):
    return subprocess.run([os.path.join(bin_dir, arguments[0]), *arguments[1:]], check=True,
                          capture_output=True, text=True).stdout


with tempfile.TemporaryDirectory() as folder:
    box_map, lattice = os.path.join(folder, "m.boxmap"), os.path.join(folder, "l.lattice")
    tool("skyway-import", "-q", os.path.join(data_dir, "village.csv"), "--bounds", "0,0,0,80,60,60", "-o", box_map)
    tool("skyway-lattice", box_map, "--spacing", "5", "--connect", "26", "--vehicle", "box:1,1,1", "-o", lattice)

    arrays = numpy.load(box_map)
    rows = [line.split(",")[:6] for line in tool("skyway-map", "to-csv", box_map).splitlines()[1:]]
    assert numpy.array_equal(arrays["boxes"], numpy.array(rows, dtype=float))
    assert arrays["tile_range"][:, 1].sum() == len(rows)

    arrays = numpy.load(lattice)
    info = json.loads(tool("skyway-info", "--json", lattice))
    record = arrays["block_record"]
    stored = record < 0xFFFFFFFE
    assert sorted(record[stored]) == list(range(len(arrays["records"])))
    assert record.size == numpy.prod([-(-n // 8) for n in info["dims"]])
    if not (record == 0xFFFFFFFE).any():
        words = arrays["records"].view("<u2")
        assert (words >> 13 & 1).sum() == info["nodes"]
        assert sum(int(n).bit_count() for n in (words & 0x1FFF).ravel()) == info["edges"]

    for path in (box_map, lattice):
        with zipfile.ZipFile(path) as archive:
            assert archive.testzip() is None
            for entry in archive.infolist():
                assert entry.compress_type == zipfile.ZIP_STORED and entry.date_time[0] == 1980
                raw = open(path, "rb").read()
                names = int.from_bytes(raw[entry.header_offset + 26:entry.header_offset + 28], "little")
                extra = int.from_bytes(raw[entry.header_offset + 28:entry.header_offset + 30], "little")
                assert (entry.header_offset + 30 + names + extra) % 64 == 0, entry.filename
print("NumPy agrees")
