#include "traj/flight/flown_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "curve/bernstein.h"
#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "traj/proof/domain.h"

namespace traj {
namespace {

// What is added to the vehicle on the way of one chord.
class Sweep {
 public:
  Sweep(const geom::CollisionScene& scene, const Vec3& half) : scene_(scene), half_(half) {
    extra_ = (half - scene.half()).cwiseMax(0);
  }

  bool in_bounds(const Vec3& p, double stray) const {
    const Vec3 room = extra_.array() + stray;
    return scene_.inside_bounds(p + room) && scene_.inside_bounds(p - room);
  }
  bool clear(const Vec3& a, const Vec3& b, double stray) const {
    return in_bounds(a, stray) && in_bounds(b, stray) &&
           !scene_.sweep_hits(a, b, half_.array() + stray);
  }
  bool touches(const Vec3& a, const Vec3& b) const {
    return extra_.isZero(0) ? scene_.hits(a, b) : scene_.sweep_hits(a, b, half_);
  }

 private:
  const geom::CollisionScene& scene_;
  Vec3 half_;
  Vec3 extra_;
};

FlightPathCheck verdict(const geom::CollisionScene& scene, Reason reason, double time,
                        const Vec3& place) {
  FlightPathCheck out;
  out.reason = reason;
  out.time = time;
  out.place = place;
  if (out.reason == Reason::bounds) return out;
  if (const auto nearest = scene.nearest(place, scene.half().maxCoeff() + 1)) {
    out.box = nearest->box;
  }
  return out;
}

}  // namespace

FlightPathCheck check_flight_path(const geom::CollisionScene& scene, const Quadrotor& quadrotor,
                                  const TiltedVehicle& vehicle, const Flight& flight) {
  const geom::Axes axes = scene.map().spec().frame.axes;
  // Between the samples of the air's speed gusts change it by less than 1 m/s, the vehicle by what
  // it accelerates.
  const double air = flight.fastest_air + 1;
  const double most =
      acceleration_bound(quadrotor, air + kSamplePeriod * acceleration_bound(quadrotor, air));
  const double chord = kStepsPerSample * kStep;
  const double coarse = most * chord * chord / 8;
  const double fine = most * kStep * kStep / 8;
  const auto at = [&](std::size_t i) { return geom::to_enu(axes, flight.path[i]); };
  FlightPathCheck out;
  for (std::size_t i = 0; i + 1 < flight.path.size() || i == 0; i += kStepsPerSample) {
    const std::size_t end = std::min(i + kStepsPerSample, flight.path.size() - 1);
    const std::size_t k = i / kStepsPerSample;  // tilts are of the samples at both ends
    const double tilt = std::max(flight.tilt[std::min(k, flight.tilt.size() - 1)],
                                 flight.tilt[std::min(k + 1, flight.tilt.size() - 1)]);
    Vec3 half = scene.half();
    if (tilt > vehicle.tilt_max && vehicle.half_at) {
      half = half.cwiseMax(Vec3(vehicle.half_at(tilt).array() + scene.margin()));
    }
    const Sweep sweep(scene, half);
    if (sweep.clear(at(i), at(end), coarse)) continue;
    for (std::size_t j = i; j < end || j == i; ++j) {
      const Vec3 a = at(j);
      const Vec3 b = at(std::min(j + 1, end));
      if (sweep.clear(a, b, fine)) continue;
      const bool outside = !sweep.in_bounds(a, 0) || !sweep.in_bounds(b, 0);
      out = verdict(scene,
                    outside               ? Reason::bounds
                    : sweep.touches(a, b) ? Reason::collision
                                          : Reason::undecided,
                    static_cast<double>(j) / 1000, a);
      out.between = fine;
      return out;
    }
  }
  out.clear = true;
  out.between = fine;
  return out;
}

namespace {

// A radius that is not a number would be clear of all.
void require_tube(std::span<const double> radius, double period) {
  if (radius.empty()) {
    throw geom::InputError("tube", {.key = "radius", .expected = "metres", .found = "none"});
  }
  for (const double one : radius) geom::require_length("radius", one, geom::kFarthest);
  if (!(period > 0 && std::isfinite(period))) {
    throw geom::InputError(
        "tube", {.key = "period", .expected = "seconds > 0", .found = fmt::to_string(period)});
  }
}

}  // namespace

FlightPathCheck check_tube(const geom::CollisionScene& scene, const Trajectory& trajectory,
                           std::span<const double> radius, double period) {
  require_tube(radius, period);
  if (const auto outside = outside_domain(trajectory, {})) return {.reason = outside->reason};
  double begin = 0;
  for (const Segment& segment : trajectory.segments) {
    double most = 0;
    for (const Vec3& a : acceleration_points(segment)) most = std::max(most, a.norm());
    const auto parts = static_cast<std::size_t>(std::ceil(segment.duration / kSamplePeriod));
    const double chord = segment.duration / static_cast<double>(parts);
    const double sagitta = most * chord * chord / 8;
    Vec3 a = segment.point.front();
    for (std::size_t i = 0; i < parts; ++i) {
      const double from = begin + static_cast<double>(i) * chord;
      const Vec3 b = evaluate(segment, static_cast<double>(i + 1) * chord).position;
      double stray = 0;
      const auto first = static_cast<std::size_t>(from / period);
      const auto last = static_cast<std::size_t>((from + chord) / period);
      for (std::size_t k = first; k <= last; ++k) {
        stray = std::max(stray, radius[std::min(k, radius.size() - 1)]);
      }
      const Sweep sweep(scene, scene.half());
      if (!sweep.clear(a, b, stray + sagitta)) {
        const bool outside =
            !sweep.in_bounds(a, stray + sagitta) || !sweep.in_bounds(b, stray + sagitta);
        return verdict(scene, outside ? Reason::bounds : Reason::collision, from, a);
      }
      a = b;
    }
    begin += segment.duration;
  }
  FlightPathCheck out;
  out.clear = true;
  return out;
}

}  // namespace traj
