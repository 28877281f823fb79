#pragma once

// Tello scripts: the text commands of Ryze's SDK 1.3 and 2.0, `go x y z speed` above all.
//
// Example:
//   const traj::TelloStart start;
//   const std::vector<geom::Vec3> points = {{0, 2, 1}, {1, 2, 1}};
//   const traj::TelloFlight flight = traj::tello_flight(points, start, 50, true);
//   std::stringstream file;
//   traj::write_tello(file, flight);  // command, takeoff, go 200 0 0 50, go 0 -100 0 50, land
//   assert(traj::read_tello(file, "flight.txt").legs == flight.legs);

#include <iosfwd>
#include <span>
#include <string_view>
#include <vector>

#include "geom/shape/polyline.h"
#include "traj/curve/trajectory.h"
#include "traj/curve/vertical_ends.h"

namespace traj {

inline constexpr int kTelloFarthest = 500;  // cm a command may move along an axis
inline constexpr int kTelloNearest = 20;    // cm: one axis must move further
inline constexpr int kTelloSlowest = 10;    // cm/s
inline constexpr int kTelloFastest = 100;

// Where it stands before it takes off, in ENU, and where its nose points.
struct TelloStart {
  Vec3 ground = Vec3::Zero();  // m
  double heading = 0;          // radians clockwise from north
  double takeoff_height = 1;   // m above the ground, where `takeoff` ends
};

// `go`: centimetres forward, left and up of where it is, straight, and a stop.
struct TelloLeg {
  int x = 0;
  int y = 0;
  int z = 0;
  int speed = 0;  // cm/s

  friend bool operator==(const TelloLeg&, const TelloLeg&) = default;
};

struct TelloFlight {
  std::vector<TelloLeg> legs;
  bool lands = true;
};

// The flight from the take-off's end through `points` (ENU). Each leg is counted from where the
// centimetres so far have led, so their rounding never adds up: it is at most half a centimetre on
// each of the drone's axes. Legs beyond 500 cm are split in equal parts; points less than the SDK's
// smallest move from the last one are passed over, or the one before them where they are the end.
TelloFlight tello_flight(std::span<const Vec3> points, const TelloStart& start, int speed,
                         bool lands);

// `command`, `takeoff`, a `go` a leg, `land`: a line each.
void write_tello(std::ostream& out, const TelloFlight& flight);

// A Python program for the library DJITelloPy which flies that. `note` goes into its heading.
void write_tello_python(std::ostream& out, const TelloFlight& flight, const TelloStart& start,
                        std::string_view note);

// Header `leg,time_s,east_m,north_m,up_m,forward_cm,left_cm,up_cm,speed_cm_s`: the take-off as leg
// 0, then where each leg ends.
void write_tello_csv(std::ostream& out, const TelloFlight& flight, const TelloStart& start);

// Throws geom::InputError(source, line, …) for text that is not such a script (any other command of
// the SDK: up, cw, flip, curve, rc, …), for a move the SDK refuses (beyond 500 cm, 20 cm or less on
// all axes, a speed outside 10 to 100 cm/s), and for a last line without its end, which may have
// lost digits. A script that was cut between lines reads as one that ends in hovering.
TelloFlight read_tello(std::istream& in, std::string_view source);

// Where it flies, in ENU: the end of the take-off, then the end of each leg.
geom::Polyline tello_path(const TelloFlight& flight, const TelloStart& start);

// Seconds from the take-off to each point of the path, at 0.5 m/s up, then with 1 m/s2 up to the
// speed and down again, and a second of rest after each leg. The two are assumptions, and generous.
std::vector<double> tello_times(const TelloFlight& flight, const TelloStart& start);

// Ryze Tello specifications: 30 m, 100 m, 13 min.
inline constexpr FlightEnvelope kTelloEnvelope{30, 100, 780};

}  // namespace traj
