"""mesh_test.py BIN_DIR DATA_DIR: to-ply and to-gltf against readers of a few lines."""

import json
import pathlib
import struct
import subprocess
import sys
import tempfile

bin_dir, data = (pathlib.Path(a) for a in sys.argv[1:3])


def run(*args):
    return subprocess.run([str(bin_dir / args[0]), *map(str, args[1:])], check=True,
                          capture_output=True).stdout


def signed_volume(points, triangles):
    total = 0.0
    for a, b, c in triangles:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = points[a], points[b], points[c]
        total += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6
    return total


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    for name in ("boxes.csv", "village.csv"):  # east north up, and north east up
        run("skyway-import", data / name, "-q", "-o", folder / "map")
        rows = [line.split(",")[:6] for line in run("skyway-map", "to-csv", folder / "map")
                .decode().splitlines()[1:]]
        boxes = [[float(v) for v in row] for row in rows]
        volume = sum((b[3] - b[0]) * (b[4] - b[1]) * (b[5] - b[2]) for b in boxes)

        head, body = run("skyway-map", "to-ply", folder / "map").split(b"end_header\n", 1)
        assert b"element vertex %d" % (8 * len(boxes)) in head
        points = [struct.unpack_from("<3d", body, 27 * i) for i in range(8 * len(boxes))]
        at = 27 * len(points)
        triangles = [struct.unpack_from("<3i", body, at + 13 * i + 1) for i in range(12 * len(boxes))]
        assert len(body) == at + 13 * len(triangles)
        assert abs(signed_volume(points, triangles) - volume) < 1e-6 * volume, "outward, and closed"

        glb = run("skyway-map", "to-gltf", folder / "map")
        magic, version, length, json_length = struct.unpack_from("<4sIII", glb)
        assert (magic, version, length) == (b"glTF", 2, len(glb))
        gltf = json.loads(glb[20:20 + json_length])
        binary = glb[28 + json_length:]
        assert len(binary) == gltf["buffers"][0]["byteLength"]
        total = 0.0
        for mesh in gltf["meshes"]:
            part = mesh["primitives"][0]
            accessor = gltf["accessors"][part["attributes"]["POSITION"]]
            offset = gltf["bufferViews"][accessor["bufferView"]]["byteOffset"]
            points = [struct.unpack_from("<3f", binary, offset + 12 * i) for i in range(accessor["count"])]
            single = [struct.unpack("<f", struct.pack("<f", v))[0] for v in accessor["min"]]
            assert single == [min(p[k] for p in points) for k in range(3)]
            accessor = gltf["accessors"][part["indices"]]
            offset = gltf["bufferViews"][accessor["bufferView"]]["byteOffset"]
            index = struct.unpack_from(f"<{accessor['count']}I", binary, offset)
            total += signed_volume(points, list(zip(*[iter(index)] * 3)))
        assert abs(total - volume) < 1e-4 * volume, "outward, and closed"
print("meshes agree")
