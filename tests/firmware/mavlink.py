"""MAVLink 2, as much of it as a flight needs: framing, checksum, 29 messages, and a link over UDP or TCP."""

import select
import socket
import struct
import time
import types

# name: (number, CRC_EXTRA, fields in the order of the wire; extension fields come last)
MESSAGES = {
    "HEARTBEAT": (0, 50, "custom_mode:I type:B autopilot:B base_mode:B system_status:B mavlink_version:B"),
    "SYS_STATUS": (1, 124, "sensors_present:I sensors_enabled:I sensors_health:I load:H voltage_battery:H "
                           "current_battery:h drop_rate_comm:H errors_comm:H errors_count1:H errors_count2:H "
                           "errors_count3:H errors_count4:H battery_remaining:b present_extended:I "
                           "enabled_extended:I health_extended:I"),
    "SYSTEM_TIME": (2, 137, "time_unix_usec:Q time_boot_ms:I"),
    "PARAM_REQUEST_READ": (20, 214, "param_index:h target_system:B target_component:B param_id:16s"),
    "PARAM_REQUEST_LIST": (21, 159, "target_system:B target_component:B"),
    "PARAM_VALUE": (22, 220, "param_value:f param_count:H param_index:H param_id:16s param_type:B"),
    "PARAM_SET": (23, 168, "param_value:f target_system:B target_component:B param_id:16s param_type:B"),
    "LOCAL_POSITION_NED": (32, 185, "time_boot_ms:I x:f y:f z:f vx:f vy:f vz:f"),
    "GLOBAL_POSITION_INT": (33, 104, "time_boot_ms:I lat:i lon:i alt:i relative_alt:i vx:h vy:h vz:h hdg:H"),
    "MISSION_REQUEST": (40, 230, "seq:H target_system:B target_component:B mission_type:B"),
    "MISSION_CURRENT": (42, 28, "seq:H total:H mission_state:B mission_mode:B mission_id:I fence_id:I "
                                "rally_points_id:I"),
    "MISSION_COUNT": (44, 221, "count:H target_system:B target_component:B mission_type:B opaque_id:I"),
    "MISSION_CLEAR_ALL": (45, 232, "target_system:B target_component:B mission_type:B"),
    "MISSION_ITEM_REACHED": (46, 11, "seq:H"),
    "MISSION_ACK": (47, 153, "target_system:B target_component:B type:B mission_type:B opaque_id:I"),
    "MISSION_REQUEST_INT": (51, 196, "seq:H target_system:B target_component:B mission_type:B"),
    "MISSION_ITEM_INT": (73, 38, "param1:f param2:f param3:f param4:f x:i y:i z:f seq:H command:H target_system:B "
                                 "target_component:B frame:B current:B autocontinue:B mission_type:B"),
    "COMMAND_LONG": (76, 152, "param1:f param2:f param3:f param4:f param5:f param6:f param7:f command:H "
                              "target_system:B target_component:B confirmation:B"),
    "COMMAND_ACK": (77, 143, "command:H result:B progress:B result_param2:i target_system:B target_component:B"),
    "SET_POSITION_TARGET_LOCAL_NED": (84, 143, "time_boot_ms:I x:f y:f z:f vx:f vy:f vz:f afx:f afy:f afz:f yaw:f "
                                               "yaw_rate:f type_mask:H target_system:B target_component:B "
                                               "coordinate_frame:B"),
    "SIM_STATE": (108, 32, "q1:f q2:f q3:f q4:f roll:f pitch:f yaw:f xacc:f yacc:f zacc:f xgyro:f ygyro:f zgyro:f "
                           "lat:f lon:f alt:f std_dev_horz:f std_dev_vert:f vn:f ve:f vd:f lat_int:i lon_int:i"),
    "HIL_STATE_QUATERNION": (115, 4, "time_usec:Q attitude_quaternion:4f rollspeed:f pitchspeed:f yawspeed:f lat:i "
                                     "lon:i alt:i vx:h vy:h vz:h ind_airspeed:H true_airspeed:H xacc:h yacc:h "
                                     "zacc:h"),
    "TERRAIN_REQUEST": (133, 6, "mask:Q lat:i lon:i grid_spacing:H"),
    "TERRAIN_DATA": (134, 229, "lat:i lon:i grid_spacing:H data:16h gridbit:B"),
    "AUTOPILOT_VERSION": (148, 178, "capabilities:Q uid:Q flight_sw_version:I middleware_sw_version:I "
                                    "os_sw_version:I board_version:I vendor_id:H product_id:H "
                                    "flight_custom_version:8s middleware_custom_version:8s os_custom_version:8s "
                                    "uid2:18s"),
    "EKF_STATUS_REPORT": (193, 71, "velocity_variance:f pos_horiz_variance:f pos_vert_variance:f "
                                   "compass_variance:f terrain_alt_variance:f flags:H airspeed_variance:f"),
    "HOME_POSITION": (242, 104, "latitude:i longitude:i altitude:i x:f y:f z:f q:4f approach_x:f approach_y:f "
                                "approach_z:f time_usec:Q"),
    "EXTENDED_SYS_STATE": (245, 130, "vtol_state:B landed_state:B"),
    "STATUSTEXT": (253, 83, "severity:B text:50s id:H chunk_seq:B"),
}

OUR_SYSTEM, OUR_COMPONENT = 255, 190  # what a ground station calls itself


class _Layout:
    def __init__(self, name, number, crc_extra, fields):
        self.name, self.number, self.crc_extra = name, number, crc_extra
        self.fields = [tuple(field.split(":")) for field in fields.split()]
        self.struct = struct.Struct("<" + "".join(code for _, code in self.fields))

    def pack(self, values):
        flat = []
        for field, code in self.fields:
            value = values.pop(field, b"" if code.endswith("s") else 0)
            if isinstance(value, str):
                value = value.encode()
            if isinstance(value, (list, tuple)):
                flat += value
            else:
                flat.append(value)
        if values:
            raise TypeError(f"{self.name} has no field {', '.join(values)}")
        return self.struct.pack(*flat)

    def unpack(self, payload):
        flat = iter(self.struct.unpack(payload[: self.struct.size].ljust(self.struct.size, b"\0")))
        message = types.SimpleNamespace(name=self.name)
        for field, code in self.fields:
            if code.endswith("s"):
                value = next(flat)
            elif len(code) > 1:
                value = [next(flat) for _ in range(int(code[:-1]))]
            else:
                value = next(flat)
            setattr(message, field, value)
        return message


_BY_NAME = {name: _Layout(name, *rest) for name, rest in MESSAGES.items()}
_BY_NUMBER = {layout.number: layout for layout in _BY_NAME.values()}


def _crc_table():
    table = []
    for byte in range(256):
        crc = byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x8408 if crc & 1 else 0)
        table.append(crc)
    return table


_CRC = _crc_table()


def checksum(data, crc=0xFFFF):
    """CRC-16/MCRF4XX, which MAVLink calls X.25."""
    for byte in data:
        crc = crc >> 8 ^ _CRC[(crc ^ byte) & 0xFF]
    return crc


def encode(name, sequence, values):
    """One MAVLink 2 frame, not signed."""
    layout = _BY_NAME[name]
    payload = layout.pack(dict(values)).rstrip(b"\0") or b"\0"
    head = struct.pack("<BBBBBB", len(payload), 0, 0, sequence & 0xFF, OUR_SYSTEM, OUR_COMPONENT)
    body = head + layout.number.to_bytes(3, "little") + payload
    return b"\xfd" + body + struct.pack("<H", checksum(bytes([layout.crc_extra]), checksum(body)))


class Decoder:
    """Bytes in, messages out. Frames of MAVLink 1 and messages that the table lacks are passed over."""

    def __init__(self):
        self.buffer = bytearray()
        self.broken = 0

    def feed(self, data):
        self.buffer += data
        at, messages = 0, []
        buffer = self.buffer
        while True:
            while at < len(buffer) and buffer[at] not in (0xFD, 0xFE):
                at += 1
            if len(buffer) - at < 12:
                break
            if buffer[at] == 0xFE:
                size = 8 + buffer[at + 1]
            else:
                size = 12 + buffer[at + 1] + (13 if buffer[at + 2] & 1 else 0)
            if len(buffer) - at < size:
                break
            frame = bytes(buffer[at : at + size])
            message = self._message(frame) if frame[0] == 0xFD else None
            if message is None:
                at += size
                continue
            if message is False:
                self.broken += 1
                at += 1
                continue
            messages.append(message)
            at += size
        del buffer[:at]
        return messages

    @staticmethod
    def _message(frame):
        """None: a message that the table lacks. False: the checksum differs."""
        layout = _BY_NUMBER.get(int.from_bytes(frame[7:10], "little"))
        if layout is None:
            return None
        end = 10 + frame[1]
        if checksum(bytes([layout.crc_extra]), checksum(frame[1:end])) != int.from_bytes(frame[end : end + 2], "little"):
            return False
        message = layout.unpack(frame[10:end])
        message.system, message.component = frame[5], frame[6]
        return message


class Link:
    """A link to one autopilot on this computer. `on_message` sees every message of it, whoever waits for what."""

    def __init__(self, kind, port, on_message, deadline):
        self.on_message = on_message
        self.decoder, self.sequence = Decoder(), 0
        self.system, self.component = 0, 1
        self.last_heartbeat = 0.0
        if kind == "udp":
            self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
            self.socket.bind(("127.0.0.1", 0))
            self.socket.connect(("127.0.0.1", port))
        else:
            while True:
                try:
                    self.socket = socket.create_connection(("127.0.0.1", port), timeout=5)
                    break
                except OSError:
                    if time.monotonic() > deadline:
                        raise
                    time.sleep(0.05)
            self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.socket.setblocking(False)

    def close(self):
        self.socket.close()

    def send(self, name, **values):
        layout = _BY_NAME[name]
        if any(field == "target_system" for field, _ in layout.fields):
            values = {"target_system": self.system, "target_component": self.component, **values}
        self.sequence += 1
        try:
            self.socket.send(encode(name, self.sequence, values))
        except (BlockingIOError, ConnectionRefusedError):
            pass  # not there yet, or full: whoever needs an answer asks again

    def heartbeat(self, period):
        now = time.monotonic()
        if now - self.last_heartbeat >= period:
            self.last_heartbeat = now
            self.send("HEARTBEAT", type=6, autopilot=8, system_status=4, mavlink_version=3)

    def receive(self, timeout):
        """The messages that arrive within the timeout (seconds of the wall); returns at the first."""
        ready, _, _ = select.select([self.socket], [], [], timeout)
        if not ready:
            return []
        messages = []
        try:
            while len(messages) < 500:
                data = self.socket.recv(65536)
                if not data:
                    raise ConnectionError("the firmware closed the connection")
                messages += self.decoder.feed(data)
        except (BlockingIOError, ConnectionRefusedError):
            pass
        mine = []
        for message in messages:
            if self.system and message.system != self.system:
                continue
            mine.append(message)
            self.on_message(message)
        return mine
