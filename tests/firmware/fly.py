#!/usr/bin/env python3
"""Flies a mission with a real autopilot firmware in its own simulator and writes the simulator's ground truth.

The firmware is a program of yours: SKYWAY_PX4 (a build folder of PX4's px4_sitl_default, or its bin/px4) or
SKYWAY_ARDUCOPTER (arducopter, built for SITL). README.md says more.
"""

import argparse
import contextlib
import csv
import fcntl
import math
import os
import pathlib
import re
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import logs
import mavlink
import missions
import terrain

NAN = math.nan
ARMED_FLAG = 128
CMD_LAND, CMD_RETURN = 21, 20
CMD_SET_MODE, CMD_ARM, CMD_MESSAGE_INTERVAL, CMD_REQUEST_MESSAGE = 176, 400, 511, 512
INTEGER_TYPES = {1: "<B3x", 2: "<b3x", 3: "<H2x", 4: "<h2x", 5: "<I", 6: "<i"}


class FlightError(Exception):
    """A flight that could not be flown; the text is for a person."""


class Starved(FlightError):
    """The simulation lost its step, mostly because the computer was too busy for that speed; another try may succeed."""


class Firmware:
    """One firmware process in a fresh folder, with a MAVLink link to it."""

    kind, int_params_bytewise = None, False
    estimate_limit = 0.15  # metres, of a flight with little noise

    def __init__(self, options, home):
        self.options, self.home = options, home
        self.clock = 0.0  # simulated seconds since the firmware's start
        self.armed = self.ready = False
        self.landed_state = self.mission_state = self.current_item = 0
        self.acks, self.values, self.texts = {}, {}, []
        self.home_position = self.position = None
        self.version = "?"
        self.process = self.link = None
        self.ekf_flags, self.starved = 0, False
        self.ordered = False  # whether --return-at was obeyed already
        self.posts = terrain.Posts(terrain.read(options.terrain), home, *options.terrain_error) if options.terrain else None
        self.lock, self.instance = self._instance()
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix=f"fly-{options.firmware}-"))

    def _instance(self):
        """A number nobody else uses; every port of the firmware follows from it."""
        folder = pathlib.Path(tempfile.gettempdir())
        for number in range(20, 100):
            lock = open(folder / f"fly-{self.options.firmware}-{number}.lock", "w")
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                with socket.socket(socket.AF_INET, self.kind) as probe:
                    if self.kind == socket.SOCK_STREAM:
                        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
                    probe.bind(("127.0.0.1", self.port(number)))
                return lock, number
            except OSError:
                lock.close()
        raise FlightError("No free port was found for the firmware.")

    def port(self, number):
        raise NotImplementedError

    def launch(self, command, environment):
        if os.geteuid() == 0 and shutil.which("setpriv"):  # root's PX4 would take real-time priorities and starve itself
            command = ["setpriv", "--bounding-set=-sys_nice", "--inh-caps=-sys_nice", *command]
        self.output = open(self.folder / "output.txt", "wb")
        self.process = subprocess.Popen(command, cwd=self.folder, env=environment, stdin=subprocess.DEVNULL,
                                        stdout=self.output, stderr=subprocess.STDOUT, start_new_session=True)

    def stop(self):
        """Ends the firmware: asks first, so that its log is closed."""
        if self.link:
            self.link.close()
        if self.process and self.process.poll() is None:
            for how, patience in ((signal.SIGINT, 5), (signal.SIGTERM, 5), (signal.SIGKILL, 10)):
                self.process.send_signal(how)
                try:
                    self.process.wait(patience)
                    break
                except subprocess.TimeoutExpired:
                    continue
        if self.process:
            self.output.close()
        self.lock.close()

    # What the firmware says.

    def on_message(self, m):
        if m.name == "HEARTBEAT" and m.component == 1:
            if not self.link.system:
                self.link.system = m.system
            self.armed, self.mode = bool(m.base_mode & ARMED_FLAG), m.custom_mode
        elif m.name in ("GLOBAL_POSITION_INT", "SYSTEM_TIME"):
            self.clock = max(self.clock, m.time_boot_ms * 1e-3)
            if m.name == "GLOBAL_POSITION_INT":
                self.position = m
        elif m.name == "SYS_STATUS":
            self.ready = bool(m.sensors_health & 1 << 28)  # the checks before arming pass
        elif m.name == "EKF_STATUS_REPORT":
            self.ekf_flags = m.flags
        elif m.name == "EXTENDED_SYS_STATE":
            self.landed_state = m.landed_state
        elif m.name == "MISSION_CURRENT":
            self.mission_state, self.current_item = m.mission_state, m.seq
        elif m.name == "COMMAND_ACK":
            self.acks[m.command] = m.result
        elif m.name == "HOME_POSITION":
            self.home_position = m
        elif m.name == "AUTOPILOT_VERSION":
            v = m.flight_sw_version
            commit = m.flight_custom_version.rstrip(b"\0")
            commit = commit.decode() if self.options.firmware == "arducopter" else commit[::-1].hex()
            self.version = f"{v >> 24}.{v >> 16 & 255}.{v >> 8 & 255} ({commit})"
        elif m.name == "PARAM_VALUE":
            name = m.param_id.rstrip(b"\0").decode()
            value = m.param_value
            if self.int_params_bytewise and m.param_type in INTEGER_TYPES:
                value = struct.unpack_from(INTEGER_TYPES[m.param_type][:2], struct.pack("<f", value))[0]
            self.values[name] = (value, m.param_type, m.param_index, m.param_count)
        elif m.name == "TERRAIN_REQUEST" and self.posts:
            for answer in self.posts.answers(m):
                self.link.send("TERRAIN_DATA", **answer)
        elif m.name == "STATUSTEXT":
            text = m.text.rstrip(b"\0").decode(errors="replace").strip()
            self.texts.append((self.clock, m.severity, text))
            # a sensor came late or no more: a thread of the firmware did not get its turn
            self.starved = self.starved or "TIMEOUT" in text or "No valid data from" in text
            if self.options.verbose:
                print(f"{self.clock:9.2f} [{m.severity}] {text}", file=sys.stderr)

    def pump(self, timeout=0.02):
        if self.process.poll() is not None:
            raise FlightError(f"The firmware ended by itself (code {self.process.returncode}). It said:\n{self.tail()}")
        if self.starved:
            raise Starved(f"At {self.clock:.1f} s a sensor came late or no more ({self.texts[-1][2]}).")
        self.link.heartbeat(min(0.5, 1.0 / self.options.speedup))
        return self.link.receive(timeout)

    def tail(self):
        text = (self.folder / "output.txt").read_text(errors="replace")
        return "\n".join(re.sub(r"\x1b\[[0-9;]*[A-Za-z]", "", text).splitlines()[-30:])

    def wait(self, condition, wall, what):
        end = time.monotonic() + wall
        while not condition():
            if time.monotonic() > end:
                said = "; ".join(text for _, _, text in self.texts[-5:])
                raise FlightError(f"Waited {wall:g} s in vain for {what}. The firmware's last words: {said or 'none'}.")
            self.pump()

    def rest(self, simulated):
        until = self.clock + simulated
        self.wait(lambda: self.clock >= until, 60 + simulated, "the simulation's clock")

    # What is said to the firmware.

    def command(self, number, *params, wall=5.0, tries=4):
        """Sends a command until its answer comes; returns the answer's result (0 is yes)."""
        params = dict(zip((f"param{i}" for i in range(1, 8)), params))
        for attempt in range(tries):
            self.acks.pop(number, None)
            self.link.send("COMMAND_LONG", command=number, confirmation=attempt, **params)
            end = time.monotonic() + wall / tries
            while number not in self.acks and time.monotonic() < end:
                self.pump()
            if number in self.acks:
                return self.acks[number]
        return None

    def stream(self, name, hertz):
        """Asks for a message at a rate of simulated time; 0 switches it off."""
        self.command(CMD_MESSAGE_INTERVAL, mavlink.MESSAGES[name][0], -1 if hertz == 0 else 1e6 / hertz, wall=2.0)

    def read_param(self, name):
        self.values.pop(name, None)
        for _ in range(5):
            self.link.send("PARAM_REQUEST_READ", param_index=-1, param_id=name)
            end = time.monotonic() + 0.6
            while name not in self.values and time.monotonic() < end:
                self.pump()
            if name in self.values:
                return self.values[name]
        return None

    def set_param(self, name, value):
        """Sets a parameter unless it has that value already, and reads it back."""
        for _ in range(4):
            known = self.read_param(name)
            if known is None:
                raise FlightError(f"The firmware has no parameter {name}.")
            if abs(known[0] - value) <= 1e-6 * max(1.0, abs(value)):
                return
            kind, wire = known[1], value
            if self.int_params_bytewise and kind in INTEGER_TYPES:
                wire = struct.unpack("<f", struct.pack(INTEGER_TYPES[kind], int(value)))[0]
            self.link.send("PARAM_SET", param_id=name, param_value=wire, param_type=kind)
            self.pump(0.1)
        raise FlightError(f"The parameter {name} stayed at {known[0]:g} when {value:g} was set.")

    def all_params(self):
        """Every parameter: {name: (value, type)}."""
        self.values.clear()
        self.link.send("PARAM_REQUEST_LIST")
        last, quiet = -1, time.monotonic()
        for _ in range(40):
            while time.monotonic() - quiet < 1.5:
                self.pump()
                if len(self.values) != last:
                    last, quiet = len(self.values), time.monotonic()
            if not self.values:
                self.link.send("PARAM_REQUEST_LIST")
                quiet = time.monotonic()
                continue
            count = max(v[3] for v in self.values.values())
            missing = set(range(count)) - {v[2] for v in self.values.values()}
            if not missing:
                break
            for index in sorted(missing)[:50]:
                self.link.send("PARAM_REQUEST_READ", param_index=index)
                self.pump(0.005)
            quiet = time.monotonic() - 1.2
        return {name: value[:2] for name, value in sorted(self.values.items())}

    def upload(self, items, mission_type):
        """Hands over a list of mission items (type 0), of a fence (1) or of rally points (2)."""
        what = ("mission", "fence", "rally points")[mission_type]
        for _ in range(6):  # the firmware's patience is simulated time, which is short for a busy computer
            result = self._upload_once(items, mission_type)
            if result == 0:
                return
            self.rest(2)
        said = "; ".join(text for _, _, text in self.texts[-3:])
        raise FlightError(f"The firmware refused the {what} (result {result}): {said or 'without a reason'}.")

    def _upload_once(self, items, mission_type):
        """The result of the firmware's MISSION_ACK, or None when nothing is heard for two seconds."""
        self.link.send("MISSION_COUNT", count=len(items), mission_type=mission_type)
        heard = time.monotonic()
        while time.monotonic() - heard < 2:
            for m in self.pump():
                if getattr(m, "mission_type", None) != mission_type:
                    continue
                if m.name in ("MISSION_REQUEST", "MISSION_REQUEST_INT") and m.seq < len(items):
                    heard = time.monotonic()
                    self.link.send("MISSION_ITEM_INT", seq=m.seq, current=int(m.seq == 0), mission_type=mission_type,
                                   **items[m.seq].wire())
                elif m.name == "MISSION_ACK":
                    return m.type
        return None

    def arm(self):
        for _ in range(60):
            result = self.command(CMD_ARM, 1, 0)
            if result == 0:
                break
            self.rest(1)
        else:
            said = "; ".join(text for _, _, text in self.texts[-3:])
            raise FlightError(f"The firmware refused to arm (result {result}): {said}.")
        self.wait(lambda: self.armed, 10, "the armed state")

    def disarm_by_force(self):
        self.command(CMD_ARM, 0, 21196)


class Px4(Firmware):
    """PX4 with its simulator SIH. Its clock is simulated time: the simulator waits for the firmware at every step."""

    kind, int_params_bytewise = socket.SOCK_DGRAM, True
    # data/vehicles/quad2kg.json in the simulator's terms
    QUAD2KG = {"SIH_MASS": 2.0, "SIH_IXX": 0.0216667, "SIH_IYY": 0.0216667, "SIH_IZZ": 0.04, "SIH_T_MAX": 8.54858,
               "SIH_Q_MAX": 0.136777, "SIH_L_ROLL": 0.174, "SIH_L_PITCH": 0.174, "SIH_KDV": 0.244, "SIH_KDW": 0.025,
               "SIH_T_TAU": 0.0125, "MPC_THR_HOVER": 0.5736}
    # what --return-at orders: the mode as the firmware's log has it (nav_state), main mode and its part
    RETURNS = {"rtl": (5, (4, 5)), "land": (18, (4, 6)), "hold": (4, (4, 3))}
    # messages that PX4 streams by itself and nobody here reads: targets, attitudes, outputs, altitude, and so on
    UNREAD = (85, 30, 31, 83, 36, 106, 65, 141, 74, 230, 241)

    def port(self, number):
        return 18570 + number

    def start(self):
        where = os.environ.get("SKYWAY_PX4")
        if not where:
            raise FlightError("SKYWAY_PX4 is not set. Give it PX4's build folder (px4_sitl_default) or the program bin/px4.")
        binary = pathlib.Path(where).resolve()
        if binary.is_dir():
            binary = binary / "bin" / "px4"
        if not binary.exists():
            raise FlightError(f"{binary} does not exist.")
        build = binary.parent.parent
        known = binary.read_bytes()
        options = self.options
        params = dict(self.QUAD2KG) if options.airframe == "quad2kg" else {}
        params.update(SDLOG_PROFILE=1, SDLOG_MODE=1)
        environment = {k: v for k, v in os.environ.items() if not k.startswith("PX4_")}
        environment.update(PX4_SIM_MODEL="sihsim_quadx", PX4_SIM_SPEED_FACTOR=f"{options.speedup:g}")
        noise = 0.1 if options.noise is None else options.noise
        if noise == 0:
            raise FlightError("PX4 does not start without any noise; give --noise a small number such as 0.01.")
        if b"PX4_SIM_NOISE" in known:
            environment["PX4_SIM_NOISE"] = f"{noise:g}"
        elif options.noise is None:
            print("fly.py: this PX4 has no scale for its sensors' noise; it flies with all of it.", file=sys.stderr)
        elif noise != 1:
            raise FlightError("This PX4 does not read PX4_SIM_NOISE, so --noise has to be 1 (README.md, noise).")
        if options.wind:
            speed, direction = options.wind
            north, east = -speed * math.cos(math.radians(direction)), -speed * math.sin(math.radians(direction))
            if b"PX4_SIM_WIND" in known:
                environment["PX4_SIM_WIND"] = f"{north:.4f},{east:.4f}"
            elif b"SIH_WIND_N" in known:
                params.update(SIH_WIND_N=-north, SIH_WIND_E=-east)
            else:
                raise FlightError("This PX4 has no wind: neither PX4_SIM_WIND nor SIH_WIND_N (README.md, wind).")
        params.update(options.set)
        if options.setpoints:
            params.setdefault("MIS_TAKEOFF_ALT", -options.setpoints[0][3])
        self._write_startup(build / "etc", params)
        self.launch([str(binary), "-d", "-i", str(self.instance), str(self.folder / "startup")], environment)
        self.link = mavlink.Link("udp", self.port(self.instance), self.on_message, time.monotonic() + 30)
        self.wait(lambda: self.link.system, 60, "the first heartbeat")
        for number in self.UNREAD:
            self.command(CMD_MESSAGE_INTERVAL, number, -1, wall=1.0, tries=2)
        self.stream("LOCAL_POSITION_NED", 0)
        self.stream("GLOBAL_POSITION_INT", 10)
        self.stream("EXTENDED_SYS_STATE", 5)
        self.stream("SYS_STATUS", 5)
        self.command(CMD_REQUEST_MESSAGE, 148)
        for name, value in params.items():
            self.set_param(name, value)
        delay = self.read_param("EKF2_GPS_DELAY")
        if delay and delay[0] > 0:  # 1.15: a delay that the simulated receiver does not have
            self.estimate_limit = 1.5
        self.wait(lambda: self.ready, 120, "the checks before arming")
        self.rest(10)  # the estimator settles

    def _write_startup(self, etc, params):
        """Copies the firmware's start-up scripts; parameters are set in them just before the simulator starts.

        The simulator's place is in degrees, or (1.15 and before) in 1e-7 degrees as an integer.
        """
        startup = self.folder / "startup"
        shutil.copytree(etc, startup)
        script = startup / "init.d-posix" / "px4-rc.simulator"
        latitude, longitude, altitude = self.home
        lines = ["#!/bin/sh", 'case "$(param show -q SIH_LOC_LAT0)" in',
                 f"*.*) param set SIH_LOC_LAT0 {latitude:.9f}; param set SIH_LOC_LON0 {longitude:.9f};;",
                 f"*) param set SIH_LOC_LAT0 {round(latitude * 1e7)}; param set SIH_LOC_LON0 {round(longitude * 1e7)};;",
                 "esac", f"param set SIH_LOC_H0 {altitude:.4f}",
                 *(f"param set {name} {value:.9g}" for name, value in params.items()), ""]
        script.write_text("\n".join(lines) + script.read_text())

    def set_mode(self, main, sub=0):
        for _ in range(20):
            if self.command(CMD_SET_MODE, 1, main, sub) == 0:
                return
            self.rest(0.5)
        said = "; ".join(text for _, _, text in self.texts[-3:])
        raise FlightError(f"The firmware refused the mode {main}.{sub}: {said}.")

    def upload_all(self, mission):
        if mission.fence:
            self.upload(mission.fence, 1)
        if mission.rally:
            self.upload(mission.rally, 2)
        self.upload(missions.shifted(mission.items, -1), 0)
        self.rest(2)  # the navigator checks the mission again after each upload

    def start_mission(self):
        self.set_mode(4, 4)
        self.rest(1)  # armed sooner, the vehicle would take off from another mode, and otherwise
        self.arm()

    def truth(self):
        found = sorted(self.folder.glob("log/**/*.ulg"))
        if not found:
            raise FlightError("The firmware wrote no log.")
        self.log = found[-1]
        return logs.px4(self.log)

    def write_params(self, path):
        with open(path, "w", encoding="ascii") as out:
            out.write("# Onboard parameters for Vehicle 1\n#\n# Stack: PX4 Pro\n# Vehicle: Multi-Rotor\n"
                      f"# Version: {self.version.split()[0]}\n# Git Revision: {self.version.split()[-1].strip('()')}\n"
                      "#\n# Vehicle-Id Component-Id Name Value Type\n")
            for name, (value, kind) in self.all_params().items():
                text = str(value) if kind in INTEGER_TYPES else f"{value:.18g}"
                out.write(f"1\t1\t{name}\t{text}\t{kind}\n")

    def fly_setpoints(self, rows):
        """Take-off, then setpoints at 50 Hz in offboard mode, then a landing."""
        self.set_mode(4, 2)
        self.arm()
        order, action = self.options.return_at or (math.inf, None)
        order += self.clock
        height = -rows[0][3]
        self.stream("LOCAL_POSITION_NED", 50)
        self.command(CMD_REQUEST_MESSAGE, 242)
        self.wait(lambda: self.home_position is not None, 10, "the home position")
        home, state = self.home_position, {}

        def see(m):
            if m.name == "LOCAL_POSITION_NED":
                state.update(z=m.z - home.z, now=m.time_boot_ms * 1e-3)

        def step(seconds):
            row = _setpoint(rows, seconds)
            n, e, d = row[1] - rows[0][1] + home.x, row[2] - rows[0][2] + home.y, row[3] + home.z
            self.link.send("SET_POSITION_TARGET_LOCAL_NED", time_boot_ms=int(self.clock * 1000), coordinate_frame=1, x=n,
                           y=e, z=d, vx=row[4], vy=row[5], vz=row[6], afx=row[7], afy=row[8], afz=row[9], yaw=row[10],
                           yaw_rate=row[11], type_mask=0)

        def run(until, at, what):
            end, last = time.monotonic() + 600, -1.0
            while not until():
                if time.monotonic() > end:
                    raise FlightError(f"Waited in vain for {what}.")
                for m in self.pump():
                    see(m)
                if at is not None and state.get("now", -1) >= last + 0.02:
                    last = state["now"]
                    step(at(last))

        run(lambda: state.get("z", 0) < -height + 0.3, None, "the height of the first setpoint")
        settled = state["now"] + 5
        run(lambda: state["now"] >= settled, lambda now: 0.0, "the simulation's clock")
        self.acks.pop(CMD_SET_MODE, None)
        self.link.send("COMMAND_LONG", command=CMD_SET_MODE, param1=1, param2=6)
        begin = state["now"] + 2
        finish = begin + rows[-1][0] + 3
        run(lambda: state["now"] >= min(finish, order), lambda now: max(0.0, now - begin), "the last setpoint")
        if self.acks.get(CMD_SET_MODE) != 0:
            raise FlightError("The firmware refused the offboard mode.")
        self.ordered = state["now"] >= order
        self.set_mode(*(self.RETURNS[action][1] if self.ordered else (4, 6)))


class ArduCopter(Firmware):
    """ArduCopter in SITL, its own model of a quadrotor."""

    kind = socket.SOCK_STREAM
    # what --return-at orders: the mode as the firmware's log has it, and its number
    RETURNS = {"rtl": (6, (6,)), "land": (9, (9,)), "hold": (17, (17,))}
    # for a program away from its source tree, where copter.parm is: a quadrotor "+", its calibration, its motors
    DEFAULTS = {"FRAME_CLASS": 1, "FRAME_TYPE": 0, "BATT_MONITOR": 4, "MOT_THST_EXPO": 0.65, "MOT_THST_HOVER": 0.39,
                "MOT_BAT_VOLT_MIN": 9.6, "MOT_BAT_VOLT_MAX": 12.8, "ATC_RAT_YAW_P": 0.3, "ATC_RAT_YAW_I": 0.02,
                **{f"INS_ACC{n}OFFS_{axis}": 0.001 for n in ("", "2") for axis in "XYZ"},
                **{f"INS_ACC{n}SCAL_{axis}": 1.001 for n in ("", "2") for axis in "XYZ"},
                **{f"COMPASS_OFS{n}_{axis}": offset for n in ("", "2", "3") for axis, offset in zip("XYZ", (5, 13, -18))},
                **{f"RC{n}_{what}": value for n in range(1, 9) for what, value in (("MIN", 1000), ("MAX", 2000))}}

    def port(self, number):
        return 5760 + 10 * number

    def start(self):
        where = os.environ.get("SKYWAY_ARDUCOPTER")
        if not where:
            raise FlightError("SKYWAY_ARDUCOPTER is not set. Give it the program arducopter, built for SITL.")
        binary = pathlib.Path(where).resolve()
        if not binary.exists():
            raise FlightError(f"{binary} does not exist.")
        options = self.options
        defaults = []
        for folder in binary.parents[:5]:
            stock = folder / "Tools" / "autotest" / "default_params" / "copter.parm"
            if stock.exists():
                defaults = [str(stock)]
                break
        noise = options.noise or 0.0
        params = {"AUTO_OPTIONS": 3, "LOG_DISARMED": 1}
        offered = {} if defaults else dict(self.DEFAULTS)  # names differ between releases: what is unknown is ignored
        offered.update(SIM_GPS1_NOISE=0.5 * noise, SIM_GPS_NOISE=0.5 * noise, SIM_BARO_RND=0.2 * noise, SIM_MAG_RND=0,
                       SIM_ACC1_RND=0.3 * noise, SIM_ACC2_RND=0.3 * noise, SIM_GYR1_RND=0.5 * noise,
                       SIM_GYR2_RND=0.5 * noise)
        if options.wind:
            params.update(SIM_WIND_SPD=options.wind[0], SIM_WIND_DIR=options.wind[1], SIM_WIND_T=1)
        params.update(options.set)
        own = self.folder / "own.parm"
        own.write_text("".join(f"{k} {v:.9g}\n" for k, v in {**offered, **params}.items()))
        home = f"{self.home[0]:.9f},{self.home[1]:.9f},{self.home[2]:g},0"
        self.launch([str(binary), "--model", "+", "--speedup", f"{options.speedup:g}", "--home", home, "--defaults",
                     ",".join([*defaults, str(own)]), "-I", str(self.instance)], dict(os.environ))
        self.link = mavlink.Link("tcp", self.port(self.instance), self.on_message, time.monotonic() + 30)
        self.wait(lambda: self.link.system, 60, "the first heartbeat")
        self.stream("GLOBAL_POSITION_INT", 10)
        self.stream("EXTENDED_SYS_STATE", 5)
        self.stream("SYS_STATUS", 5)
        self.stream("MISSION_CURRENT", 5)
        self.stream("EKF_STATUS_REPORT", 5)
        if self.posts:
            self.stream("TERRAIN_REQUEST", 5)
        self.command(CMD_REQUEST_MESSAGE, 148)
        for name, value in params.items():
            self.set_param(name, value)
        self.wait(lambda: self.ready and self.ekf_flags & 0x90 == 0x10, 180, "the position estimate")  # absolute, not held
        self.rest(5)

    def set_mode(self, number):
        for _ in range(20):
            if self.command(CMD_SET_MODE, 1, number) == 0:
                return
            self.rest(0.5)
        said = "; ".join(text for _, _, text in self.texts[-3:])
        raise FlightError(f"The firmware refused the mode {number}: {said}.")

    def upload_all(self, mission):
        first = missions.Item(16, 0, [0, 0, 0, 0, *self.home])
        self.upload([first, *mission.items], 0)
        if mission.fence:
            self.upload(mission.fence, 1)
        if mission.rally:
            self.upload(mission.rally, 2)

    def start_mission(self):
        self.set_mode(3)
        self.arm()

    def truth(self):
        found = sorted(self.folder.glob("logs/*.BIN"))
        if not found:
            raise FlightError("The firmware wrote no log.")
        self.log = found[-1]
        return logs.arducopter(self.log, self.home)

    def write_params(self, path):
        with open(path, "w", encoding="ascii") as out:
            for name, (value, _) in self.all_params().items():
                out.write(f"{name},{value:.9g}\n")

    def fly_setpoints(self, rows):
        raise FlightError("Setpoints are flown with PX4 only.")


def _setpoint(rows, seconds):
    """The last row that is not after that moment."""
    low, high = 0, len(rows)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if rows[middle][0] <= seconds + 1e-9 else (low, middle)
    return rows[low]


def read_setpoints(path):
    with open(path, encoding="ascii") as file:
        rows = list(csv.reader(file))
    if not rows or rows[0][:4] != ["t_s", "n_m", "e_m", "d_m"]:
        raise FlightError(f"{path}: the first line is not that of a file of setpoints (t_s,n_m,e_m,d_m,...).")
    return [[float(v) for v in row] for row in rows[1:]]


def _rests_below(firmware):
    """True while the estimator says: near the take-off height, at rest."""
    m = firmware.position
    return abs(m.relative_alt) < 2000 and abs(m.vz) < 15 and abs(m.vx) < 30 and abs(m.vy) < 30


HOLDS = 25  # seconds after the order that a flight is watched which is to stay in the air


def watch(firmware, options, mission):
    """Waits until the flight is over; returns how it ended, and when by the simulation's clock."""
    start = clock = firmware.clock
    last_seen = time.monotonic()
    order, action = options.return_at or (math.inf, None)
    stays = action == "hold"
    lands = (options.setpoints or any(i.command in (CMD_LAND, CMD_RETURN) for i in mission.items) or action) and not stays
    ordered = clock if firmware.ordered else None
    high = False
    since = {"hovers": None, "armed on the ground": None}

    def lasts(what, holds, seconds):
        since[what] = (since[what] or clock) if holds else None
        return since[what] is not None and clock - since[what] > seconds

    while True:
        firmware.pump()
        if firmware.clock != clock:
            clock, last_seen = firmware.clock, time.monotonic()
        elif time.monotonic() - last_seen > 30:
            raise FlightError("The simulation's clock stands still.")
        if not firmware.armed:
            return "landed" if firmware.landed_state == 1 else "disarmed", clock
        if clock - start > options.timeout:
            return "cut", clock
        if ordered is None and clock - start >= order:
            firmware.set_mode(*firmware.RETURNS[action][1])
            ordered = clock
        if ordered is not None and stays and clock - ordered > HOLDS:
            return "holds", clock
        high = high or firmware.position.relative_alt > 2500
        if lasts("hovers", firmware.mission_state == 5 and not lands, 10):
            return "hovers", clock
        if lasts("armed on the ground", high and lands and _rests_below(firmware), 40):
            return "grounded", since["armed on the ground"]


def returned_at(truth, firmware, options, end):
    """When after arming, and where, the firmware's log has the mode that was ordered; for the last line."""
    if not options.return_at:
        return ""
    action = options.return_at[1]
    mode = firmware.RETURNS[action][0]
    moments = [moment for moment, number in truth.modes if number == mode and truth.armed < moment < end]
    if not moments:
        raise FlightError(f"The log does not say that the mode {action} began.")
    place = min(truth.samples, key=lambda sample: abs(sample[0] - moments[0]))
    return f"{action} at {moments[0] - truth.armed:.3f} s from {place[1]:.7f} {place[2]:.7f} {place[3]:.2f} m, "


def fly(options):
    options.setpoints, mission = None, missions.Mission(None)
    if options.mission.endswith(".csv"):
        options.setpoints = read_setpoints(options.mission)
        if not options.home:
            raise FlightError("A file of setpoints needs --home: the place and the ground below its first setpoint.")
    else:
        mission = missions.read(options.mission)
    home = options.home or mission.home
    if home is None:
        raise FlightError(f"{options.mission}: the mission has no planned home position. Give one with --home.")
    if options.terrain and options.firmware != "arducopter":
        raise FlightError("--terrain is for ArduCopter: PX4 loads no mission with heights above terrain.")
    firmware = {"px4": Px4, "arducopter": ArduCopter}[options.firmware](options, home)
    kept = False
    try:
        firmware.start()
        if options.params_out:
            firmware.write_params(options.params_out)
        wall = time.monotonic()
        begin = firmware.clock
        if options.setpoints:
            firmware.fly_setpoints(options.setpoints)
        else:
            firmware.upload_all(mission)
            wall, begin = time.monotonic(), firmware.clock
            firmware.start_mission()
        ended, stopped_at = watch(firmware, options, mission)
        rate = (firmware.clock - begin) / max(time.monotonic() - wall, 1e-3)
        if firmware.armed:
            firmware.disarm_by_force()
        firmware.rest(3)
        firmware.stop()
        truth = firmware.truth()
        if truth.armed is None:
            raise FlightError("The log does not say when the vehicle was armed.")
        end = truth.disarmed if truth.disarmed and ended in ("landed", "disarmed") else stopped_at
        silence = truth.longest_silence(truth.armed, end)
        if silence > 0.4:
            raise Starved(f"A sensor was silent for {silence:.1f} s of the flight.")
        error = truth.estimate_error(truth.armed, end)
        if error and (options.noise or 0) <= 0.2 and max(error) > firmware.estimate_limit:
            raise Starved(f"The estimate was off by {max(error):.2f} m (rms), too much for so little noise.")
        returned = returned_at(truth, firmware, options, end)
        track = logs.at_ten_hertz(truth.samples, truth.armed, end)
        if not track:
            raise FlightError("The log holds no ground truth.")
        if truth.lost_ms:
            print(f"fly.py: the log lost {truth.lost_ms} ms.", file=sys.stderr)
        if options.log_out:
            shutil.copyfile(firmware.log, options.log_out)
        part = pathlib.Path(f"{options.output}.part")
        logs.write_track(track, part)
        os.replace(part, options.output)
        notes = [text for clock, severity, text in firmware.texts if severity <= 4 and begin <= clock <= stopped_at]
        print(f"{options.mission}: {ended} after {track[-1][0]:.1f} s, {len(track)} samples, {rate:.1f} times real time, "
              + returned + (f"estimate off by {error[0]:.2f} m across, {error[1]:.2f} m up (rms), " if error else "")
              + f"{options.firmware} {firmware.version}" + (f"; said: {'; '.join(notes[-4:])}" if notes else ""))
    except FlightError:
        kept = options.keep
        raise
    finally:
        with contextlib.suppress(OSError):
            firmware.stop()
        if kept:
            print(f"fly.py: the firmware's folder is {firmware.folder}", file=sys.stderr)
        else:
            shutil.rmtree(firmware.folder, ignore_errors=True)


def _numbers(count):
    def parse(text):
        values = tuple(float(v) for v in text.split(","))
        if len(values) != count:
            raise argparse.ArgumentTypeError(f"{text}: expected {count} numbers with commas between")
        return values
    return parse


def _assignment(text):
    name, sign, value = text.partition("=")
    if not sign:
        raise argparse.ArgumentTypeError(f"{text}: expected NAME=VALUE")
    return name, float(value)


def _terrain_error(text):
    metres, _, rest = text.partition(",")
    how, _, seed = rest.partition(",")
    if how not in terrain.ERRORS:
        raise argparse.ArgumentTypeError(f"{text}: expected METRES, then one of {', '.join(terrain.ERRORS)}")
    return float(metres), how, int(seed or 0)


def _order(text):
    seconds, _, action = text.partition(",")
    if action not in ("", "rtl", "land", "hold"):
        raise argparse.ArgumentTypeError(f"{text}: expected SECONDS, or SECONDS and rtl, land or hold")
    return float(seconds), action or "rtl"


def parser():
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    p.add_argument("mission", metavar="MISSION", help=".waypoints, .plan, or setpoints (.csv, PX4 only)")
    p.add_argument("-o", "--output", required=True, metavar="TRACK.csv")
    p.add_argument("--firmware", choices=("px4", "arducopter"), default="px4")
    p.add_argument("--airframe", choices=("quad2kg", "stock"), default="quad2kg", help="PX4's simulated vehicle")
    p.add_argument("--set", type=_assignment, action="append", default=[], metavar="NAME=VALUE", help="a parameter")
    p.add_argument("--noise", type=float, metavar="X",
                   help="scale of the sensors' noise, 1 as the firmware has it (default: PX4 0.1, ArduCopter 0)")
    p.add_argument("--wind", type=_numbers(2), metavar="SPEED,FROM", help="m/s, and the degrees it blows from")
    p.add_argument("--speedup", type=float, default=10, metavar="N", help="at most N simulated seconds a second (10)")
    p.add_argument("--terrain", metavar="GRID.asc", help="the ground, metres above the sea (terrain.py); ArduCopter alone")
    p.add_argument("--terrain-error", type=_terrain_error, default=(), metavar="METRES,HOW[,SEED]",
                   help=f"of the terrain that the autopilot gets; HOW: {', '.join(terrain.ERRORS)}")
    p.add_argument("--home", type=_numbers(3), metavar="LAT,LON,ALT", help="instead of the mission's")
    p.add_argument("--timeout", type=float, default=1200, metavar="SECONDS", help="of simulated time, from arming (1200)")
    p.add_argument("--return-at", type=_order, metavar="SECONDS[,ACTION]",
                   help="after arming, ends the mission by a change of mode: rtl, land or hold")
    p.add_argument("--params-out", metavar="FILE", help="all parameters, as flown")
    p.add_argument("--log-out", metavar="FILE", help="the firmware's own log")
    p.add_argument("--keep", action="store_true", help="keep the firmware's folder when a flight fails")
    p.add_argument("--verbose", action="store_true", help="print what the firmware says")
    return p


def main():
    options = parser().parse_args()
    options.set = dict(options.set)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    try:
        while True:
            try:
                fly(options)
                break
            except Starved as error:
                if options.speedup < 2:
                    raise
                options.speedup /= 2
                print(f"fly.py: {error} Again at {options.speedup:g} times real time.", file=sys.stderr)
    except (FlightError, OSError, ValueError) as error:
        print(f"fly.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
