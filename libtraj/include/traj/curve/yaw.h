#pragma once

// Where the vehicle looks: yaw along a trajectory.
//
// Example:
//   traj::Trajectory flight = trajectory;
//   traj::add_yaw({.kind = traj::YawOptions::Kind::towards, .target = {5, 9, 1}}, flight);
//   std::cout << *traj::yaw_at(flight, 1.5) << " rad\n";

#include <optional>

#include "traj/curve/trajectory.h"

namespace traj {

// Radians in the map's horizontal axes, from x towards y: in an ENU frame counterclockwise from
// east, in a NEU frame clockwise from north.
struct YawOptions {
  enum class Kind {
    along,   // the velocity
    fixed,   // `angle`
    towards  // `target`
  };
  Kind kind = Kind::along;
  double angle = 0;
  Vec3 target = Vec3::Zero();        // its height does not matter
  double rate = 1.5707963267948966;  // rad/s, > 0: the largest
};

// Sets the yaw of every segment: at the joints what is asked for, as far as the rate allows, with
// rates that never turn back on the way; between them the degree-7 polynomial with these ends and
// no second and third derivative there. So it is continuous to the third derivative, unwrapped, and
// its rate never above `rate`. Where the vehicle rests (slower than 0.1 m/s across the ground) it
// looks along the way to the next joint; where that is straight up, or the target within 0.1 m, it
// goes on to look where it did, and before the first motion where it will.
void add_yaw(const YawOptions& options, Trajectory& trajectory);

// The yaw at time t, clamped to [0, duration], in radians in the map's axes; nothing where that
// segment (at a joint: the later) has none. The trajectory has at least one segment.
std::optional<double> yaw_at(const Trajectory& trajectory, double t);

struct Heading {
  double yaw = 0;   // radians
  double rate = 0;  // rad/s
};

// At u of the segment, 0 to 1; nothing where it has no yaw.
std::optional<Heading> heading(const Segment& segment, double u);

// The largest |yaw rate|, rad/s: an upper bound by the control points of 256 parts; 0 without yaw.
double yaw_rate_bound(const Segment& segment);

}  // namespace traj
