#include "traj/mission/formats/tello.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <istream>
#include <numbers>
#include <ostream>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"
#include "geom/base/usage_error.h"
#include "geom/map/frame.h"
#include "geom/text/beginning.h"
#include "mission/formats/text_head.h"
#include "traj/mission/formats/mission_formats.h"

namespace traj {
namespace {

using Centimetres = Eigen::Vector3i;

constexpr double kClimb = 0.5;         // m/s
constexpr double kAcceleration = 1.0;  // m/s2
constexpr double kRest = 1.0;          // s
constexpr int kMostLegs = 10000;       // far beyond its range and its battery

// The nose, as a unit vector east and north; exact for quarter turns.
std::array<double, 2> nose(double heading) {
  const double quarters = heading / (std::numbers::pi / 2);
  if (quarters == std::round(quarters)) {
    constexpr std::array<std::array<double, 2>, 4> kQuarters = {
        {{0.0, 1.0}, {1.0, 0.0}, {0.0, -1.0}, {-1.0, 0.0}}};
    const int k = static_cast<int>(std::fmod(quarters, 4));
    return kQuarters[static_cast<std::size_t>((k + 4) % 4)];
  }
  return {std::sin(heading), std::cos(heading)};
}

// East, north, up as forward, left, up.
Vec3 in_drone_axes(const Vec3& enu, double heading) {
  const auto [e, n] = nose(heading);
  return {enu.x() * e + enu.y() * n, enu.y() * e - enu.x() * n, enu.z()};
}

Vec3 from_drone_axes(const Vec3& v, double heading) {
  const auto [e, n] = nose(heading);
  return {v.x() * e - v.y() * n, v.x() * n + v.y() * e, v.z()};
}

Centimetres rounded(const Vec3& centimetres) {
  const auto whole = [](double v) {
    return static_cast<int>(std::lround(std::clamp(v, -1e9, 1e9)));
  };
  return {whole(centimetres.x()), whole(centimetres.y()), whole(centimetres.z())};
}

bool too_near(const Centimetres& move) { return move.cwiseAbs().maxCoeff() <= kTelloNearest; }

// The points that are flown to, each far enough from the one before, in centimetres from the end of
// the take-off.
std::vector<Centimetres> reachable(std::span<const Vec3> points, const TelloStart& start) {
  const Vec3 origin = start.ground + Vec3(0, 0, start.takeoff_height);
  std::vector<Centimetres> chosen = {Centimetres::Zero()};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Centimetres at = rounded(100 * in_drone_axes(points[i] - origin, start.heading));
    const bool last = i + 1 == points.size();
    while (last && chosen.size() > 1 && too_near(at - chosen.back())) chosen.pop_back();
    if (!too_near(at - chosen.back())) chosen.push_back(at);
  }
  return chosen;
}

void append_legs(const Centimetres& from, const Centimetres& to, int speed,
                 std::vector<TelloLeg>& legs) {
  const Centimetres whole = to - from;
  const int parts =
      std::min((whole.cwiseAbs().maxCoeff() + kTelloFarthest - 1) / kTelloFarthest, kMostLegs);
  Centimetres done = Centimetres::Zero();
  for (int k = 1; k <= parts && legs.size() < kMostLegs; ++k) {
    const Centimetres next = rounded(whole.cast<double>() * (static_cast<double>(k) / parts));
    const Centimetres move = next - done;
    legs.push_back({move.x(), move.y(), move.z(), speed});
    done = next;
  }
}

double length_of(const TelloLeg& leg) { return 0.01 * Vec3(leg.x, leg.y, leg.z).norm(); }

double time_of(const TelloLeg& leg) {
  const double speed = 0.01 * leg.speed;
  const double length = length_of(leg);
  const double ramp = speed * speed / kAcceleration;  // metres to speed up and slow down
  const double moving = length >= ramp ? length / speed + speed / kAcceleration
                                       : 2 * std::sqrt(length / kAcceleration);
  return moving + kRest;
}

struct ScriptReader {
  std::string_view source;
  std::size_t line = 0;

  [[noreturn]] void refuse(geom::Fault fault) const {
    throw geom::InputError(source, line, std::move(fault));
  }

  TelloLeg leg(std::string_view text) const {
    std::array<int, 4> value{};
    const char* at = text.data() + 2;  // after "go"
    const char* const end = text.data() + text.size();
    for (int& v : value) {
      while (at < end && *at == ' ') ++at;
      const auto [rest, error] = std::from_chars(at, end, v);
      if (error != std::errc() || (rest < end && *rest != ' ')) {
        refuse({.expected = "go and four whole numbers",
                .found = geom::in_quotes(text.substr(0, 60))});
      }
      at = rest;
    }
    if (at != end) {
      refuse(
          {.expected = "go and four whole numbers", .found = geom::in_quotes(text.substr(0, 60))});
    }
    const TelloLeg leg{value[0], value[1], value[2], value[3]};
    require_flyable(leg);
    return leg;
  }

  void require_flyable(const TelloLeg& leg) const {
    for (const int v : {leg.x, leg.y, leg.z}) {
      if (v < -kTelloFarthest || v > kTelloFarthest) {
        refuse({.key = "a move", .expected = "within -500 to 500 cm", .found = fmt::to_string(v)});
      }
    }
    if (too_near({leg.x, leg.y, leg.z})) {
      refuse({.says = "a move must go beyond 20 cm on one axis",
              .found = fmt::format("{} {} {}", leg.x, leg.y, leg.z)});
    }
    if (leg.speed < kTelloSlowest || leg.speed > kTelloFastest) {
      refuse({.key = "a speed",
              .expected = "within 10 to 100 cm/s",
              .found = fmt::to_string(leg.speed)});
    }
  }
};

}  // namespace

TelloFlight tello_flight(std::span<const Vec3> points, const TelloStart& start, int speed,
                         bool lands) {
  TelloFlight flight;
  flight.lands = lands;
  const std::vector<Centimetres> chosen = reachable(points, start);
  for (std::size_t i = 1; i < chosen.size(); ++i) {
    append_legs(chosen[i - 1], chosen[i], speed, flight.legs);
  }
  return flight;
}

void write_tello(std::ostream& out, const TelloFlight& flight) {
  out << "command\ntakeoff\n";
  for (const TelloLeg& leg : flight.legs) {
    out << fmt::format("go {} {} {} {}\n", leg.x, leg.y, leg.z, leg.speed);
  }
  if (flight.lands) out << "land\n";
}

TelloFlight read_tello(std::istream& in, std::string_view source) {
  ScriptReader reader{source};
  TelloFlight flight;
  flight.lands = false;
  bool flying = false;
  std::string text;
  while (std::getline(in, text)) {
    ++reader.line;
    if (in.eof()) {
      reader.refuse({.expected = "a line that ends with LF",
                     .found = "none",
                     .advice = "the file may be cut"});
    }
    if (reader.line == 1 && text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    if (text.ends_with('\r')) text.pop_back();
    if (text.empty()) continue;
    if (flight.lands)
      reader.refuse({.expected = "nothing after land", .found = geom::in_quotes(text)});
    if (text == "takeoff" && !flying) {
      flying = true;
    } else if (text.starts_with("go ") && flying) {
      flight.legs.push_back(reader.leg(text));
    } else if (text == "land" && flying) {
      flight.lands = true;
    } else if (text != "command" || flying) {
      reader.refuse({.expected = flying ? "go x y z speed or land" : "command or takeoff",
                     .found = geom::in_quotes(text.substr(0, 60))});
    }
  }
  if (!flying) throw geom::InputError(source, {.expected = "a takeoff", .found = "none"});
  return flight;
}

geom::Polyline tello_path(const TelloFlight& flight, const TelloStart& start) {
  const Vec3 origin = start.ground + Vec3(0, 0, start.takeoff_height);
  geom::Polyline path = {origin};
  Eigen::Matrix<std::int64_t, 3, 1> at = {0, 0, 0};
  for (const TelloLeg& leg : flight.legs) {
    at += Eigen::Matrix<std::int64_t, 3, 1>(leg.x, leg.y, leg.z);
    path.push_back(origin + from_drone_axes(0.01 * at.cast<double>(), start.heading));
  }
  return path;
}

std::vector<double> tello_times(const TelloFlight& flight, const TelloStart& start) {
  std::vector<double> times = {start.takeoff_height / kClimb + kRest};
  for (const TelloLeg& leg : flight.legs) times.push_back(times.back() + time_of(leg));
  return times;
}

namespace {

TelloStart start_of(const Placement& placement, const Vec3& enu_ground) {
  return {enu_ground, placement.heading.value_or(0) * std::numbers::pi / 180,
          placement.takeoff_height};
}

ReadFlights read(std::istream& in, const ReadTask& task) {
  if (!task.how.start) {
    throw geom::UsageError(
        "a Tello script does not say where it starts: give --takeoff-place x,y,z, the place where "
        "the "
        "drone stands");
  }
  const TelloFlight flight = read_tello(in, task.source);
  const TelloStart start =
      start_of(task.how.placement, geom::to_enu(task.frame.axes, *task.how.start));
  FlownLegs flown;
  flown.path = tello_path(flight, start);
  flown.ends.takeoff_from = start.ground.z();
  flown.lands_below = true;  // without `land` too: by itself, 15 s after the last command
  flown.envelope = kTelloEnvelope;
  flown.airborne = tello_times(flight, start).back();
  for (const TelloLeg& leg : flight.legs) {
    flown.speed = std::max(flown.speed.value_or(0), 0.01 * leg.speed);
  }
  ReadFlights out{{{std::move(flown)}}};
  if (!flight.lands) {
    out.notes.emplace_back(
        "the flight ends without landing, or the file was cut: the drone hovers until other "
        "commands come, and lands below after 15 s without one");
  }
  return out;
}

// Where the nose points: as asked, as the trajectory's yaw begins, or north.
double heading_deg(const MissionTask& task) {
  if (task.options.placement.heading) return *task.options.placement.heading;
  const auto& yaw = task.enu.segments.front().yaw;
  if (!yaw) return 0;
  const double degrees = std::remainder(90 - (*yaw)[0] * 180 / std::numbers::pi, 360);
  return std::round(degrees * 10) / 10;
}

// As asked, else what the limits allow.
int centimetres_a_second(const MissionTask& task) {
  const auto asked = task.options.speed ? task.options.speed : speed_limit(task.limits);
  const double speed = asked.value_or(1);
  if (speed < 0.1) {
    throw geom::UsageError(
        fmt::format("a Tello's legs are flown at 0.1 to 1 m/s, found {} m/s", speed));
  }
  return static_cast<int>(std::floor(100 * std::min(speed, 1.0) + 1e-9));
}

// Of the program, in which it stands between quotes.
std::string heading_note(const MissionTask& task) {
  std::string note = fmt::format("Flight \"{}\".{}{}", task.flight->id, task.checked ? "" : " ",
                                 unchecked_note(task));
  std::replace_if(
      note.begin(), note.end(),
      [](char c) { return c == '"' || c == '\\' || static_cast<unsigned char>(c) < ' '; }, '\'');
  return note;
}

// DJITelloPy sends a command again if no answer comes within 7 s, and programs of Ryze's send the
// next one after 15 s. Either way the drone would then fly elsewhere.
std::string note_of_answers(const TelloFlight& flight) {
  constexpr double kPatience = 7;  // s
  double most = 0;
  for (const TelloLeg& leg : flight.legs) most = std::max(most, time_of(leg));
  if (most <= kPatience) return "";
  return fmt::format(
      "a leg takes about {:.0f} s: what sends the script must wait that long for the drone's "
      "answer, and send no command twice (--python writes such a program)",
      most);
}

WrittenMission write(const MissionTask& task, const geom::Polyline& legs) {
  const int speed = centimetres_a_second(task);
  Placement placement = task.options.placement;
  placement.heading = heading_deg(task);
  const Vec3 ground(legs.front().x(), legs.front().y(), task.ground);
  const TelloStart start = start_of(placement, ground);
  const TelloFlight flight = tello_flight(legs, start, speed, task.options.lands);
  if (flight.legs.size() >= kMostLegs) {
    throw geom::InputError(
        task.flight->id, {.expected = fmt::format("a flight of fewer than {} legs, each of 5 m at "
                                                  "most along an axis",
                                                  kMostLegs),
                          .found = "a longer one"});
  }
  geom::TextOutput text;
  geom::TextOutput python;
  geom::TextOutput csv;
  write_tello(text, flight);
  write_tello_python(python, flight, start, heading_note(task));
  write_tello_csv(csv, flight, start);
  WrittenMission written{text.str(), python.str(), csv.str()};
  written.reading.placement = placement;
  written.reading.start = geom::to_enu(task.frame.axes, ground);
  written.note = note_of_answers(flight);
  const std::size_t count = flight.legs.size();
  written.estimates.push_back({"tello", {tello_times(flight, start).back(), count, count}});
  return written;
}

}  // namespace

constinit const MissionFormat kTello{
    .format = {.word = "tello",
               .what = "a Tello script",
               .begins = geom::text_begins_with<"command\n">,
               .readers = kDroneReaders},
    .may_be =
        [](std::string_view text) {
          const std::string_view head = text_head(text);
          return head.starts_with("command") || head.starts_with("takeoff");
        },
    .read = read,
    .write = write,
    .remedy = [](const MissionTask&, const CheckResult& result) -> std::string {
      return result.reason == Reason::takeoff ? "take off higher (--takeoff-height)" : "";
    },
    .reads_with = {FileOption::start, FileOption::takeoff_height, FileOption::heading,
                   FileOption::navigation, FileOption::tracking},
    .writes_with = {FileOption::tolerance, FileOption::speed, FileOption::hover, FileOption::ground,
                    FileOption::takeoff_height, FileOption::heading, FileOption::python,
                    FileOption::table, FileOption::navigation, FileOption::tracking},
    .has_legs = true,
    .fastest = 0.01 * kTelloFastest,
    .fastest_because = "0.1 to 1 m/s, as a Tello's go takes 10 to 100 cm/s"};

}  // namespace traj
