"""PX4 logs (ULog): a writer for tests, and a reader that shares no code with the product's.

    log = Log()
    log.topic("vehicle_attitude", "uint64_t timestamp;float[4] q;")
    log.row("vehicle_attitude", timestamp=1000, q=[1, 0, 0, 0])
    bytes(log)
"""

import struct

MAGIC = b"ULog\x01\x12\x35"
TYPES = {"int8_t": "b", "uint8_t": "B", "int16_t": "h", "uint16_t": "H", "int32_t": "i", "uint32_t": "I",
         "int64_t": "q", "uint64_t": "Q", "float": "f", "double": "d", "bool": "?", "char": "c"}

LOCAL = ("uint64_t timestamp;double ref_lat;double ref_lon;float x;float y;float z;float vx;float vy;float vz;"
         "float ref_alt;float eph;float epv;bool xy_valid;bool z_valid;bool v_xy_valid;bool v_z_valid;"
         "uint8_t xy_reset_counter;uint8_t z_reset_counter;bool xy_global;bool z_global;uint8_t[2] _padding0;")
GLOBAL = "uint64_t timestamp;double lat;double lon;float alt;float alt_ellipsoid;"
ATTITUDE = "uint64_t timestamp;float[4] q;"
RATES = "uint64_t timestamp;float[3] xyz;"
SETPOINT = "uint64_t timestamp;float[3] position;float[3] velocity;float yaw;"
OLD_SETPOINT = "uint64_t timestamp;float x;float y;float z;float yaw;float vx;float vy;float vz;"
BATTERY = "uint64_t timestamp;float remaining;bool connected;"
MOTORS = "uint64_t timestamp;float[12] control;"
LANDED = "uint64_t timestamp;bool landed;"


def fields_of(text):
    for field in filter(None, text.split(";")):
        kind, name = field.split(" ")
        count = 1
        if kind.endswith("]"):
            kind, count = kind[:-1].split("[")
        yield kind, int(count), name


def message(kind, body):
    return struct.pack("<HB", len(body), ord(kind)) + body


class Log:
    def __init__(self, version=1, start=0, flags=None):
        self.head = MAGIC + struct.pack("<BQ", version, start)
        self.flags = message("B", bytes(40) if flags is None else flags)
        self.definitions = b""
        self.data = b""
        self.formats = {}
        self.ids = {}

    def format(self, name, text):
        self.formats[name] = text
        self.definitions += message("F", f"{name}:{text}".encode())

    def topic(self, name, text, multi=0):
        if name not in self.formats:
            self.format(name, text)
        self.ids[name, multi] = len(self.ids)
        self.data += message("A", struct.pack("<BH", multi, self.ids[name, multi]) + name.encode())

    def row(self, name, multi=0, **values):
        text = [field for field in fields_of(self.formats[name]) if not field[2].startswith("_padding")]
        body = b""
        for kind, count, field in text:
            value = values.get(field, 0)
            body += struct.pack(f"<{count}{TYPES[kind]}", *(value if count > 1 else [value]))
        self.data += message("D", struct.pack("<H", self.ids[name, multi]) + body)

    def dropout(self, milliseconds):
        self.data += message("O", struct.pack("<H", milliseconds))

    def raw(self, kind, body):
        self.data += message(kind, body)

    def __bytes__(self):
        return self.head + self.flags + self.definitions + self.data


def read(data):
    """{topic: [{field: value}]} of the first instances, in the order of the file; "at": where a message ends."""
    assert data.startswith(MAGIC)
    formats, topics, rows = {}, {}, {}
    at = 16
    while at + 3 <= len(data):
        size, kind = struct.unpack_from("<Hc", data, at)
        body = data[at + 3:at + 3 + size]
        if len(body) < size:
            break
        at += 3 + size
        if kind == b"F":
            name, text = body.decode().split(":", 1)
            formats[name] = list(fields_of(text))
        elif kind == b"A":
            topics[struct.unpack_from("<H", body, 1)[0]] = (body[0], body[3:].decode())
        elif kind == b"D":
            multi, name = topics[struct.unpack_from("<H", body)[0]]
            if multi or any(field[0] not in TYPES for field in formats[name]):
                continue
            row, place = {"at": at}, 2
            for base, count, field in formats[name]:
                if field.startswith("_padding"):
                    place += struct.calcsize(f"<{count}{TYPES[base]}")
                    continue
                value = struct.unpack_from(f"<{count}{TYPES[base]}", body, place)
                place += struct.calcsize(f"<{count}{TYPES[base]}")
                row[field] = list(value) if count > 1 else value[0]
            rows.setdefault(name, []).append(row)
    return rows
