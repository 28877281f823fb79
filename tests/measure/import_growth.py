"""import_growth.py BIN_DIR [BOXES [BEFORE_DIR]]: what skyway-import takes of each format at 1, 4 and 16 times a size.

Made-up obstacles, BOXES (default 50,000) of them at the smallest. For each format and size: CPU seconds of the process, the
least of three runs; of BEFORE_DIR's tool beside it, in turn, where it reads the format. A program that is linear
takes 4 and 16 times as long.
"""

import os
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

BIN = pathlib.Path(sys.argv[1])
BOXES = int(sys.argv[2]) if len(sys.argv) > 2 else 50000
BEFORE = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None
TIMES = (1, 4, 16)


def boxes(count):
    """Lower corner and size, at a density that stays the same."""
    random.seed(1)
    side = 20 * count**0.5
    for _ in range(count):
        yield ([round(random.uniform(0, side), 3), round(random.uniform(0, side), 3), 0.0],
               [round(random.uniform(1, 15), 3) for _ in range(3)])


def corners(count):
    for low, size in boxes(count):
        yield low, [round(a + b, 3) for a, b in zip(low, size)]


def fcnd(out, count):
    out.write("lat0 37.79, lon0 -122.39\nposX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n")
    for low, size in boxes(count):
        half = [s / 2 for s in size]
        out.write(",".join(map(repr, [a + h for a, h in zip(low, half)] + half)) + "\n")


def box_csv(out, count):
    out.write("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n")
    for i, (low, high) in enumerate(corners(count)):
        out.write(",".join(map(repr, low + high)) + f",house {i}\n")


def block_text(out, count):
    side = 20 * count**0.5 + 20
    out.write(f"boundary 0 0 0 {side} {side} 50\n")
    for i, (low, high) in enumerate(corners(count)):
        out.write("block " + " ".join(map(repr, low + high)) + f" {i % 256} 0 0\n")


def world_json(out, count):
    side = 20 * count**0.5 + 20
    out.write(f'{{"bounds":{{"extents":[0,{side},0,{side},0,50]}},"blocks":[\n')
    for i, (low, high) in enumerate(corners(count)):
        extents = [v for pair in zip(low, high) for v in pair]
        out.write(("," if i else "") + f'{{"extents":{extents},"color":[{i % 256},0,0]}}\n')
    out.write("]}\n")


def voxels(out, count):
    side = int(count**0.5) + 1
    out.write(f"voxel {side} {side} 20\n")
    random.seed(1)
    for i in range(count):
        out.write(f"{i % side} {i // side} {random.randrange(20)}\n")


def jps3d(out, count):
    side = int((count / 5) ** 0.5)
    random.seed(1)
    out.write(f"- origin: [0, 0, 0]\n- dim: [{side}, {side}, 10]\n- resolution: 0.25\n- data: [")
    for _ in range(10 * side):
        out.write(",".join("1" if random.random() < 0.5 else "0" for _ in range(side)) + ",\n")
    out.write("]\n")


def sdf(out, count):
    out.write('<sdf version="1.9"><world name="w">\n')
    for i, (low, size) in enumerate(boxes(count)):
        middle = " ".join(repr(a + s / 2) for a, s in zip(low, size, strict=True))
        shape = "<geometry><box><size>" + " ".join(map(repr, size)) + "</size></box></geometry>"
        out.write(f'<model name="house {i}"><static>true</static><pose>{middle} 0 0 0</pose><link name="l">'
                  f'<collision name="c">{shape}</collision><visual name="v">{shape}</visual></link></model>\n')
    out.write("</world></sdf>\n")


def sdf_turned(out, count):
    out.write('<sdf version="1.9"><world name="w">\n')
    for i, (low, size) in enumerate(boxes(count // 16)):
        middle = " ".join(repr(a + s / 2) for a, s in zip(low, size, strict=True))
        out.write(f'<model name="house {i}"><static>true</static><pose>{middle} 0 0 {i % 7 / 7}</pose><link name="l">'
                  "<collision name='c'><geometry><box><size>" + " ".join(map(repr, size)) +
                  "</size></box></geometry></collision></link></model>\n")
    out.write("</world></sdf>\n")


def octomap(count):
    """Cells of a layer, every second one."""
    side = int((2 * count) ** 0.5) + 2
    cells = [(32768 + k % side, 32768 + k // side) for k in range(side * side) if (k % side + k // side) % 2 == 0][:count]
    data = bytearray()

    def visit(inside, size, x, y, z):
        half = size // 2
        children = [[] for _ in range(8)]
        for cell in inside:
            children[(cell[0] >= x + half) + 2 * (cell[1] >= y + half) + 4 * (32768 >= z + half)].append(cell)
        bits = sum((2 if half == 1 else 3) << 2 * k for k, c in enumerate(children) if c)
        data.extend(struct.pack("<H", bits))
        for k, child in enumerate(children):
            if child and half > 1:
                visit(child, half, x + half * (k & 1), y + half * (k >> 1 & 1), z + half * (k >> 2))

    visit(cells, 65536, 0, 0, 0)
    return b"# Octomap OcTree binary file\nid OcTree\nsize 1\nres 0.5\ndata\n" + bytes(data)


FORMATS = [("fcnd", fcnd, "csv"), ("box-csv", box_csv, "csv"), ("block-text", block_text, "txt"),
           ("world-json", world_json, "json"), ("3dmap", voxels, "3dmap"), ("octomap", octomap, "bt"),
           ("jps3d", jps3d, "yaml"), ("sdf", sdf, "sdf"), ("sdf, turned", sdf_turned, "sdf")]


def seconds(tool, table, output):
    child = subprocess.Popen([tool, table, "-q", "-o", output], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    return usage.ru_utime + usage.ru_stime if child.returncode == 0 else None


def shown(value, first):
    return "-" if value is None else f"{value:.2f} s ({value / first:.1f})"


for name, write, suffix in FORMATS:
    first = {}
    for times in TIMES:
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / f"table.{suffix}"
            if write is octomap:
                table.write_bytes(octomap(BOXES * times))
            else:
                with open(table, "w") as out:
                    write(out, BOXES * times)
            row = []
            tools = [BIN / "skyway-import"] + ([BEFORE / "skyway-import"] if BEFORE else [])
            runs = [[seconds(tool, table, f"{folder}/m.boxmap") for tool in tools] for _ in range(3)]
            for k in range(len(tools)):
                taken = [run[k] for run in runs if run[k] is not None]
                least = min(taken) if taken else None
                first.setdefault(k, least)
                row.append(shown(least, first[k]))
            print(f"{name} x {times}: {table.stat().st_size / 1e6:.1f} MB, " + "; before: ".join(row), flush=True)
