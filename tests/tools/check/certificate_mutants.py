"""What can be wrong with a record, its certificate or the map: mutants that make the statement false or malformed.

Each is a (what, bundle), and each bundle the bytes of three files. A change that may leave the statement true is none:
what stands in the record or the certificate alone and is said by the other too, a depth that is split in two, a plane
across another axis, numbers that are not looked at (docs/certificates.md). Which are which follows from the format.
"""

import copy
import io
import json
import re
import zipfile
from typing import NamedTuple

NOT_LOOKED_AT = {"rung", "solver", "message", "search", "kept", "mended"}
SAID_BY_BOTH = {"map", "frame", "vehicle", "margin", "limits"}
OPTIONAL = {"duration", "length", "status", "name", "hold", "velocity", "yaw"}
COVERS = {"clear", "bounds", "speed", "acceleration", "jerk", "tilt", "horizontal_speed", "vertical_speed", "thrust",
          "body_rate", "yaw_rate"}


class Bundle(NamedTuple):
    record: bytes
    box_map: bytes
    certificate: bytes


def line(value):
    """The bytes of a record, with what `raw` made as it stands."""
    return re.sub('"raw:([0-9a-f]*)"', lambda m: bytes.fromhex(m[1]).decode(), json.dumps(value)).encode() + b"\n"


def raw(token):
    """A value that `line` writes as this token, JSON or not."""
    return "raw:" + token.encode().hex()


def at(tree, path):
    for key in path:
        tree = tree[key]
    return tree


def replaced(tree, path, value):
    out = copy.deepcopy(tree)
    at(out, path[:-1])[path[-1]] = value
    return out


def dropped(tree, path):
    out = copy.deepcopy(tree)
    del at(out, path[:-1])[path[-1]]
    return out


def places(tree, path=()):
    """The path of every value that is looked at, the inner ones of lists by their ends and middle."""
    if path:
        yield path
    if isinstance(tree, dict):
        for key in tree:
            if key not in NOT_LOOKED_AT:
                yield from places(tree[key], (*path, key))
    elif isinstance(tree, list):
        for i in sorted({0, len(tree) // 2, len(tree) - 1} if tree else {}):
            yield from places(tree[i], (*path, i))


def wrong_types(value):
    """Tokens of which none is ever right in the place of the value."""
    out = ["true", "false", "null", "NaN", "Infinity", "-Infinity", "1e999", "-1e999", "1e-400", '"1"', '""', "{}"]
    if not isinstance(value, list):
        out += ["[]", "[0]"]
    if isinstance(value, (str, list, dict)):
        out += ["0", "1.5"]
    if isinstance(value, str):
        out += ['"other"', '" "']
        out.remove('""')
    if isinstance(value, dict):
        out.remove("{}")
    return out


def of_one_value(tree, path):
    value = at(tree, path)
    for token in wrong_types(value):
        yield f"is {token}", replaced(tree, path, raw(token))
    if isinstance(value, list):
        yield "has one more", replaced(tree, path, value + value[-1:] if value else [0])
        yield "has one less", replaced(tree, path, value[:-1])
        yield "is in a list", replaced(tree, path, [value])
    if isinstance(value, dict):
        for key in value:
            if key not in NOT_LOOKED_AT:
                twice = f"{json.dumps(value)[:-1]}, {json.dumps(key)}: {json.dumps(value[key])}}}"
                yield f"has {key} twice", replaced(tree, path, raw(twice))
    if isinstance(value, str):
        yield "has a letter more", replaced(tree, path, value + "x")


def of_types(tree, is_certificate):
    for turn, path in enumerate(places(tree)):
        where = ".".join(map(str, path))
        # Of each value a third of its mutants, in turn: there are many values of each sort.
        for what, mutant in list(of_one_value(tree, path))[turn % 3::3]:
            if path[-1] == "name" and what in ('is "other"', 'is " "', 'is "1"', "has a letter more"):
                continue  # a name may be any text
            yield f"{where} {what}", mutant
        key = path[-1]
        may_go = (key in OPTIONAL or isinstance(key, int) or
                  (key in SAID_BY_BOTH and not is_certificate) or key == "limits" or path[0] == "limits")
        if not may_go:
            yield f"{where} dropped", dropped(tree, path)


def other_frame(frame):
    return "neu" if frame == "enu" else "enu"


def of_values(record, certificate):
    """(what, record, certificate) with numbers that are of the right type and wrong."""
    def both(key, change):
        for what, first, second in ((f"{key} of the record", True, False), (f"{key} of the certificate", False, True)):
            yield what, change(record) if first else record, change(certificate) if second else certificate

    for value in (-1, -1e-9, -0.1, 50, 1e9, 1e154, 1e308):
        yield from both(f"margin {value}", lambda t: replaced(t, ("margin",), value))
        for axis in range(3):
            yield from both(f"half {axis} {value}", lambda t: replaced(t, ("vehicle", "half", axis), value))
    for digit in (7, 20, 70):
        def other(tree):
            hash_ = tree["map"]
            return replaced(tree, ("map",), hash_[:digit] + ("0" if hash_[digit] != "0" else "1") + hash_[digit + 1:])
        yield from both(f"digit {digit} of the map", other)
    yield from both("the other frame", lambda t: replaced(t, ("frame",), other_frame(t["frame"])))
    for key in record.get("limits", {}) if "segments" in record else {}:
        for value in (0, -1, -1e-3, 1e-320, 1e-310, 1e-7 if key != "thrust" else 9.806651, 1e300):
            yield from both(f"{key} {value}", lambda t: replaced(t, ("limits", key), value))
        yield (f"no {key}", dropped(record, ("limits", key)), dropped(certificate, ("limits", key)))
        yield from both(f"{key} misspelt", lambda t: replaced(dropped(t, ("limits", key)), ("limits", key + "_"), 1.0))
        if key == "tilt":
            for value in (1.5707963267948968, 1.6, 3.2, 10, 90):
                yield from both(f"tilt {value}", lambda t: replaced(t, ("limits", key), value))
        if key == "thrust":
            yield from both("thrust of hovering", lambda t: replaced(t, ("limits", key), 9.80665))
    statuses = ("no_path", "infeasible", "stopped", "unreachable", "start_blocked", "goal_outside", "")
    for status in statuses:
        yield f"status {status}", replaced(record, ("status",), status), certificate
    for side in range(2):
        for axis in range(3):
            value = certificate["bounds"][side][axis]
            for step in (1, -1, 1e-9, 1e9):
                yield f"bounds {side} {axis} {step}", record, replaced(certificate, ("bounds", side, axis), value + step)


def of_curves(record):
    if "points" in record:
        yield "no points", replaced(record, ("points",), [])
        yield "a point twice", replaced(record, ("points",), record["points"][:1] + record["points"])
        yield "a hold below 0", replaced(record, ("hold",), [-1] * len(record["points"]))
        yield "a hold too few", replaced(record, ("hold",), [0] * (len(record["points"]) - 1))
        yield "a velocity of two", replaced(record, ("velocity",), [[0, 0]] * len(record["points"]))
        for i, point in enumerate(record["points"]):
            for axis in range(3):
                for value in (1e7, -1e7, 1e9, -1e300, point[axis] + 1e3):
                    yield f"point {i} {axis} {value}", replaced(record, ("points", i, axis), value)
        for value in (-1, record["length"] * 1.001, 0):
            yield f"length {value}", replaced(record, ("length",), value)
        return
    segments = record["segments"]
    yield "no segments", replaced(record, ("segments",), [])
    if len(segments) > 1:
        yield "segments backwards", replaced(record, ("segments",), segments[::-1])
    yield "the first twice", replaced(record, ("segments",), segments[:1] + segments)
    for value in (-1, 0, record["duration"] * 1.001):
        yield f"duration {value}", replaced(record, ("duration",), value)
    for i, segment in enumerate(segments):
        yield f"segment {i} dropped", dropped(record, ("segments", i))
        for value in (0, -0.0, -1, -1e-9, 1e-310, 5e-324, 1e-12, 1e10, 1e15, 1e300, segment["duration"] / 2):
            yield f"segment {i} lasts {value}", replaced(record, ("segments", i, "duration"), value)
        for axis in "xyz":
            for k in range(8):
                value = (1e7, -1e7, 1e9, 1e300)[k % 4]
                yield f"{axis}[{k}] of segment {i} is {value}", replaced(record, ("segments", i, axis, k), value)
        if "yaw" in segment:
            for k in range(8):
                yield f"yaw[{k}] of segment {i} jumps", replaced(record, ("segments", i, "yaw", k), 1e6)
        if len(segments) > 1:
            for a, b in ("xy", "yz", "zx"):
                near = segments[i - 1] if i else segments[1]
                if abs(segment[a][0 if i else 7] - near[b][7 if i else 0]) > 1e-3:
                    changed = {**segment, a: segment[b], b: segment[a]}
                    yield f"{a} and {b} of segment {i} swapped", replaced(record, ("segments", i), changed)


def of_covers(certificate):
    for i, proof in enumerate(certificate["segments"]):
        yield f"proof {i} dropped", dropped(certificate, ("segments", i))
        yield f"proof {i} twice", replaced(certificate, ("segments",), certificate["segments"][:i + 1] + certificate["segments"][i:])
        yield f"a word unknown in proof {i}", replaced(certificate, ("segments", i, "speeed"), [0])
        gap = [("segments", i, "gap", "clear")] if "gap" in proof else []
        if gap:
            yield f"gap {i} dropped", dropped(certificate, ("segments", i, "gap"))
            yield f"gap {i} empty", replaced(certificate, ("segments", i, "gap"), {})
        for path in [("segments", i, key) for key in proof if key in COVERS] + gap:
            cover = at(certificate, path)
            name = f"{path[-1]} of proof {i}"
            for value in (-1, 0.5, 1.0, 61, 200, 10**6, "0", True):
                yield f"a depth of {name} is {value!r}", replaced(certificate, (*path, 0), value)
            yield f"a deeper piece in {name}", replaced(certificate, (*path, 0), cover[0] + 1)
            yield f"{name} empty", replaced(certificate, path, [])
            yield f"a piece more in {name}", replaced(certificate, path, cover + [cover[-1]])
            yield f"a piece less in {name}", replaced(certificate, path, cover[1:])
            if len(cover) > 1:
                yield f"{name} joined", replaced(certificate, path, [0])
            for k in range(len(cover) - 1):
                if cover[k] != cover[k + 1]:
                    swapped = cover[:k] + [cover[k + 1], cover[k]] + cover[k + 2:]
                    yield f"pieces {k} of {name} swapped", replaced(certificate, path, swapped)
        for k, (piece, box, plane) in enumerate(proof.get("planes", [])):
            path = ("segments", i, "planes", k)
            yield f"plane {k} dropped", dropped(certificate, path)
            yield f"plane {k} twice", replaced(certificate, path[:-1], proof["planes"] + [proof["planes"][k]])
            flipped = ("-" if plane[0] == "+" else "+") + plane[1]
            for value in ([piece, box, flipped], [piece, box, "x"], [piece, box, "+w"], [piece, box, plane, 0], [piece, box],
                          [piece + 1000, box, plane], [piece, box + 10**6, plane], [-1, box, plane], [piece, -1, plane],
                          [float(piece), box, plane], [piece, str(box), plane], [piece, box, None], [piece, box, [plane]]):
                yield f"plane {k} is {value}", replaced(certificate, path, value)


def of_texts(good, other):
    """Whole files cut, mixed up or broken; `other` is a bundle of another record of the same map."""
    for name in ("record", "certificate"):
        text = getattr(good, name)
        object_ = json.loads(text)
        changed = {
            "empty": b"", "blank": b" \n\n", "a list": b"[" + text.strip() + b"]\n", "null": b"null\n", "a number": b"1\n",
            "garbage behind": text.strip() + b"x\n", "two in a line": text.strip() + b" " + text, "twice": text + text,
            "garbage in a line of its own": text + b"garbage\n", "not UTF-8": text.replace(b'"type"', b'"typ\xff"'),
            "bytes of zero": text + b"\0\n", "a comment": b"# records\n" + text, "with commas": text.strip() + b",\n",
            "single quotes": text.replace(b'"', b"'"), "of the other file": good.certificate if name == "record" else good.record,
            "another record's": getattr(other, name), "an extra one": text + getattr(other, name),
            "another record's under this id": line({**json.loads(getattr(other, name)), "id": object_["id"]}),
            "without an id": line({k: v for k, v in object_.items() if k != "id"}),
            "nested": b'{"a":' * 100000, "brackets": b"[" * 100000,
        }
        for what, bytes_ in changed.items():
            yield f"{name} {what}", good._replace(**{name: bytes_})
        for k in range(1, 40):
            yield f"{name} cut at {k}/40", good._replace(**{name: text[:len(text) * k // 40]})
        for key in object_:
            if key not in NOT_LOOKED_AT:
                twice = text.strip()[:-1] + b"," + json.dumps(key).encode() + b":" + json.dumps(object_[key]).encode() + b"}\n"
                yield f"{name} has {key} twice", good._replace(**{name: twice})
    for k in range(0, 30):
        yield f"map cut at {k}/30", good._replace(box_map=good.box_map[:len(good.box_map) * k // 30])
    yield "map is text", good._replace(box_map=b"min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n0,0,0,1,1,1,\n")


def repacked(box_map, change):
    """The map with `change(entries)` applied to the bytes of its entries, every CRC right."""
    with zipfile.ZipFile(io.BytesIO(box_map)) as archive:
        entries = {name: archive.read(name) for name in archive.namelist()}
    change(entries)
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        for name, data in entries.items():
            archive.writestr(name, data)
    return out.getvalue()


def of_maps(good):
    def with_meta(**keys):
        def change(entries):
            meta = {**json.loads(entries["meta.json"]), **keys}
            entries["meta.json"] = line({k: v for k, v in meta.items() if v is not None})
        return change

    def with_boxes(change_bytes):
        def change(entries):
            entries["boxes.npy"] = change_bytes(bytearray(entries["boxes.npy"]))
        return change

    def moved(k):
        def change(data):
            data[-8 * k + 5] ^= 1
            return bytes(data)
        return change

    meta = {}
    repacked(good.box_map, lambda entries: meta.update(json.loads(entries["meta.json"])))
    low, high = meta["bounds"]
    for keys in ({"frame": other_frame(meta["frame"])}, {"frame": "x"}, {"frame": None}, {"crs": "EPSG:3067"}, {"crs": None}, {"origin": [60, 24, 0]},
                 {"origin": [1, 2]}, {"origin": "here"}, {"bounds": [low, [h + 1 for h in high]]}, {"bounds": [high, low]},
                 {"bounds": [low]}, {"bounds": None}, {"bounds": [[str(c) for c in low], high]}, {"hash": "sha256:" + "0" * 64},
                 {"hash": None}, {"format": "skyway-lattice"}, {"format": None}, {"version": 2}, {"version": "1"},
                 {"boxes": meta["boxes"] - 1}, {"boxes": None}, {"boxes": str(meta["boxes"])}):
        yield f"map with {keys}", good._replace(box_map=repacked(good.box_map, with_meta(**keys)))
    for k in range(1, 6 * meta["boxes"] + 1, 5):
        yield f"number -{k} of the boxes changed", good._replace(box_map=repacked(good.box_map, with_boxes(moved(k))))
    for what, change in {"a box less": lambda d: bytes(d[:-48]), "a byte less": lambda d: bytes(d[:-1]), "nothing": lambda d: b"",
                         "float32": lambda d: bytes(d.replace(b"<f8", b"<f4")), "big endian": lambda d: bytes(d.replace(b"<f8", b">f8")),
                         "Fortran's order": lambda d: bytes(d.replace(b"'fortran_order': False", b"'fortran_order': True ")),
                         "code for a header": lambda d: bytes(d.replace(b"{'descr'", b"{f()  'd")),
                         "NaN": lambda d: bytes(d[:-8] + b"\xff" * 8)}.items():
        yield f"boxes: {what}", good._replace(box_map=repacked(good.box_map, with_boxes(change)))
    fewer = json.dumps({**meta, "boxes": meta["boxes"] - 1}).encode()

    def robbed(entries):
        data = bytearray(entries["boxes.npy"])[:-48]
        entries["boxes.npy"] = bytes(data.replace(f"({meta['boxes']}, 6)".encode(), f"({meta['boxes'] - 1}, 6)".encode()))
        entries["meta.json"] = fewer
    yield "a box taken out", good._replace(box_map=repacked(good.box_map, robbed))
    for name in ("meta.json", "boxes.npy"):
        yield f"no {name}", good._replace(box_map=repacked(good.box_map, lambda entries: entries.pop(name)))
        yield f"{name} empty", good._replace(box_map=repacked(good.box_map, lambda entries: entries.update({name: b""})))


def mutants(good, other):
    """All of one bundle with one record; `other` is a bundle with another one."""
    record, certificate = json.loads(good.record), json.loads(good.certificate)
    for what, changed in of_types(record, False):
        yield f"record: {what}", good._replace(record=line(changed))
    for what, changed in of_types(certificate, True):
        yield f"certificate: {what}", good._replace(certificate=line(changed))
    for what, first, second in of_values(record, certificate):
        yield what, good._replace(record=line(first), certificate=line(second))
    for what, changed in of_curves(record):
        yield what, good._replace(record=line(changed))
    for what, changed in of_covers(certificate):
        yield what, good._replace(certificate=line(changed))
    yield from of_texts(good, other)
    yield from of_maps(good)


def still_true(good):
    """Changes after which the statement stands, and is shown: none may be refused."""
    record, certificate = json.loads(good.record), json.loads(good.certificate)
    yield "as it is", good
    yield "keys in another order", good._replace(record=line(dict(reversed(record.items()))), certificate=line(dict(reversed(certificate.items()))))
    yield "spaces and blank lines", good._replace(record=b"\n" + json.dumps(record, separators=(" , ", " : ")).encode() + b"\r\n\n")
    yield "another's word", good._replace(record=line({**record, "colour": "red", "rung": 7}))
    yield "said by the certificate alone", good._replace(record=line({k: v for k, v in record.items() if k not in SAID_BY_BOTH}))
    yield "the map packed anew", good._replace(box_map=repacked(good.box_map, lambda entries: None))
    if "limits" in record and "segments" in record:
        yield "more allowed by the record", good._replace(record=line(replaced(record, ("limits", "vmax"), 100.0)))
        yield "more allowed by the certificate", good._replace(certificate=line(replaced(certificate, ("limits", "vmax"), 100.0)))
    for key in ("bounds", "speed"):
        if key in certificate["segments"][0]:
            cover = certificate["segments"][0][key]
            finer = cover[:-1] + [cover[-1] + 1] * 2
            yield f"{key} cut finer", good._replace(certificate=line(replaced(certificate, ("segments", 0, key), finer)))
