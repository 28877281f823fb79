#include "cruise.h"

#include <algorithm>

#include "curve/portable_math.h"
#include "solve/nominal.h"

namespace traj {
namespace {

constexpr double kStraight = 1e-14;   // of coordinates: how far joints lie off a straight leg
constexpr double kLeastRunUp = 20;    // metres
constexpr double kLeastSettling = 1;  // seconds, five times over

const Vec3& joint(const Corridor& corridor, std::size_t i) {
  return i < corridor.size() ? corridor[i].from : corridor.back().to;
}

bool straight(const Corridor& corridor, std::size_t first, std::size_t last) {
  const Vec3& a = joint(corridor, first);
  const Vec3& b = joint(corridor, last);
  const Vec3 along = (b - a).normalized();
  const double far = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  for (std::size_t i = first + 1; i < last; ++i) {
    const Vec3 to = joint(corridor, i) - a;
    if ((to - to.dot(along) * along).norm() > kStraight * (1 + far)) return false;
  }
  return true;
}

// One past the last piece of the straight leg that begins with piece `first`.
std::size_t end_of_leg(const Corridor& corridor, std::size_t first) {
  std::size_t last = first + 1;
  while (last < corridor.size() && straight(corridor, first, last + 1)) ++last;
  return last;
}

// Metres from rest to the speed of the profile, with time for snap and jerk to fade: a jump of
// acceleration is worth spreading over about (rho amax vmax)^(1/5) seconds, which this is above.
double run_up(const SpeedProfile& profile, const Limits& limits, double rho) {
  double settling = std::max(kLeastSettling, 2 * cube_root(rho * profile.amax * profile.vmax));
  if (limits[Limit::jerk]) settling += profile.amax / *limits[Limit::jerk];
  return std::max(kLeastRunUp,
                  profile.vmax * profile.vmax / (2 * profile.amax) + 5 * settling * profile.vmax);
}

// What cruises of the leg of pieces [first, last), or nothing: first == last.
CruisePart cruise_in(const Corridor& corridor, const CruisePart& within, const Limits& limits,
                     double rho) {
  const std::size_t first = within.first;
  const std::size_t last = within.last;
  const Vec3 leg = joint(corridor, last) - joint(corridor, first);
  const double length = leg.norm();
  const auto profile = cruise_profile(leg, limits);
  if (!profile) return {last, last};
  const double far = run_up(*profile, limits, rho);
  const auto beyond = [&](std::size_t i) {
    return (joint(corridor, i) - joint(corridor, first)).norm();
  };
  CruisePart out{first, last};
  while (out.first < last && beyond(out.first) < far) ++out.first;
  while (out.last > out.first && length - beyond(out.last) < far) --out.last;
  out.velocity =
      profile->vmax * (joint(corridor, out.last) - joint(corridor, out.first)).normalized();
  return out;
}

}  // namespace

std::vector<CruisePart> cruise_parts(const Corridor& corridor, const Limits& limits, double rho) {
  std::vector<CruisePart> out;
  std::size_t done = 0;
  for (std::size_t first = 0; first < corridor.size();) {
    const std::size_t last = end_of_leg(corridor, first);
    const CruisePart found = cruise_in(corridor, {first, last}, limits, rho);
    if (found.first < found.last && found.first >= done + 2 && found.last + 2 <= corridor.size()) {
      out.push_back({done, found.first});
      out.push_back(found);
      done = found.last;
    }
    first = last;
  }
  out.push_back({done, corridor.size()});
  return out;
}

Trajectory cruise(std::span<const CorridorPiece> pieces, const Vec3& velocity) {
  const Vec3 from = pieces.front().from;
  const Vec3 way = pieces.back().to - from;
  const double seconds = way.norm() / velocity.norm();
  const auto n = static_cast<double>(pieces.size());
  Trajectory out;
  for (double k = 0; k < n; ++k) {
    Segment segment;
    segment.duration = seconds / n;
    for (int i = 0; i < kPoints; ++i) {
      const double part = (k + i / static_cast<double>(kDegree)) / n;
      segment.point[static_cast<std::size_t>(i)] = from + part * way;
    }
    out.segments.push_back(segment);
  }
  out.segments.back().point.back() = pieces.back().to;
  return out;
}

}  // namespace traj
