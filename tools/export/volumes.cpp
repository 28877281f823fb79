#include "volumes.h"

#include <fmt/format.h>

#include <sstream>

#include "cli/run.h"
#include "geom/record/volume4d.h"
#include "prove.h"
#include "traj/airspace/flight_volumes.h"
#include "traj/proof/check.h"

namespace exporting {
namespace {

geom::GeodeticOrigin origin_of(const Task& task) {
  const geom::GeodeticOrigin origin = task.placement.mission_frame(task.frame).origin;
  if (knows_height(task)) return origin;
  throw cli::UsageError(
      "altitudes of volumes are above the ellipsoid, and the map does not say how high above it "
      "its z = 0 is (0 m, as maps have whose height nobody gave): give --origin "
      "latitude,longitude,height");
}

std::optional<std::string> refused_by_map(const geom::CollisionScene& scene, const Flight& flight,
                                          const Task& task) {
  traj::CheckOptions options;
  options.limits = task.limits;
  options.clearance = traj::Clearance::left_out;
  const traj::CheckResult result = traj::check(scene, flight.trajectory, options);
  if (result.ok) return std::nullopt;
  return refusal(scene, task, result);
}

}  // namespace

std::string no_volumes_for(const Flight& flight) {
  if (!flight.path.empty()) {
    return "volumes of airspace have times, and a path has none: make a trajectory of it "
           "(skyway-traj)";
  }
  if (flight.time.start && flight.time.epoch) return "";
  return fmt::format(
      "volumes of airspace say when, and the record has no \"{}\": give it to the query, or let "
      "skyway-fleet choose departures",
      flight.time.epoch ? "start" : "epoch");
}

std::optional<Written> write_volumes(const geom::CollisionScene& scene, const Flight& flight,
                                     const Task& task) {
  const traj::FlightOnEarth on_earth{
      {&task.enu, *flight.time.start,
       geom::to_enu(task.frame.axes, geom::Vec3(scene.half())).cwiseAbs() +
           geom::Vec3::Constant(task.buffer)},
      *flight.time.epoch,
      origin_of(task)};
  if (const auto refused = refused_by_map(scene, flight, task)) {
    cli::complain("skyway-export", *refused);
    return std::nullopt;
  }
  for (const traj::Segment& s : task.enu.segments) {
    cli::require_near_origin({s.point.begin(), s.point.end()}, on_earth.origin, task.id);
  }
  const auto volumes = traj::flight_volumes(on_earth, task.volumes, task.id);
  Written written{geom::operational_intent_details(volumes, flight.time.priority), {}, {}, {}};
  std::istringstream in(written.text);
  const auto read = geom::read_volumes_4d(in, "what was written");
  if (const auto why = traj::why_not_held(on_earth, read, "what was written")) {
    cli::complain("skyway-export", fmt::format("{}: refused: {}", task.id, *why));
    return std::nullopt;
  }
  return written;
}

}  // namespace exporting
