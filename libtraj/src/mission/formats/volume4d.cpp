#include "geom/record/volume4d.h"

#include <fmt/format.h>

#include "geom/base/text_stream.h"
#include "geom/base/usage_error.h"
#include "traj/mission/airspace/flight_volumes.h"
#include "traj/mission/formats/mission_formats.h"
#include "traj/record/check_in_tube.h"
#include "traj/record/verdict.h"

namespace traj {
namespace {

// Why none can be written: no trajectory, no start or no epoch.
std::string unfit(const ExportFlight& flight) {
  if (!flight.path.empty()) {
    return "volumes of airspace have times, and a path has none: make a trajectory of it "
           "(skyway-traj)";
  }
  const geom::FlightTime& time = flight.time;
  if (time.start && time.epoch) return "";
  return fmt::format(
      "volumes of airspace say when, and the record has no \"{}\": give it to the query, or let "
      "skyway-fleet choose departures",
      time.epoch ? "start" : "epoch");
}

geom::GeodeticOrigin origin_of(const MissionTask& task) {
  const geom::GeodeticOrigin origin = task.options.placement.mission_frame(task.frame).origin;
  if (knows_height(task)) return origin;
  throw geom::UsageError(
      "altitudes of volumes are above the ellipsoid, and the map does not say how high above it "
      "its z = 0 is (0 m, as maps have whose height nobody gave): give --origin "
      "latitude,longitude,height");
}

// `half`: what holds the vehicle around its reference point, m in the map's axes.
FlightOnEarth on_earth(const Vec3& half, const MissionTask& task) {
  return {{&task.enu, *task.flight->time.start,
           geom::to_enu(task.frame.axes, half).cwiseAbs() + Vec3::Constant(task.options.buffer)},
          *task.flight->time.epoch,
          origin_of(task)};
}

// The tube that is to be flown in, over the map without any margin.
std::optional<TubeReport> tube_of(const geom::CollisionScene& scene, const MissionTask& task) {
  if (!task.options.tubes) return std::nullopt;
  const geom::CollisionScene bare(scene.map(), scene.vehicle(), 0);
  return check_as_geography(bare, task.flight->id, task.flight->trajectory, *task.options.tubes);
}

// The details of an operational intent (ASTM F3548) for a flight that is clear of the map and
// within its limits: volumes that hold the vehicle with its margin, or its proved tube, and the
// buffer at every instant, read back from the text.
MissionProof prove(const geom::CollisionScene& scene, const MissionTask& task) {
  const auto tube = tube_of(scene, task);
  const FlightOnEarth flight =
      on_earth(tube ? geography_half(scene.vehicle(), *tube) : scene.half(), task);
  CheckOptions options;
  options.limits = task.limits;
  options.clearance = Clearance::left_out;
  MissionProof proof{{}, check(scene, task.flight->trajectory, options)};
  if (!proof.result.ok) return proof;
  if (tube && !tube->check.clear) {
    proof.refusal = in_words(*tube, geom::provenance_of(scene), scene.map());
    return proof;
  }
  if (tube)
    proof.written.note =
        fmt::format("its volumes hold {}, as its report says, which was not proved again",
                    in_words(tube->claim));
  const std::string& id = task.flight->id;
  for (const Segment& s : task.enu.segments) {
    require_near_origin({s.point.begin(), s.point.end()}, flight.origin, id);
  }
  const auto volumes = flight_volumes(flight, task.options.volumes, id);
  proof.written.text = geom::operational_intent_details(volumes, task.flight->time.priority);
  geom::TextInput in(proof.written.text);
  const auto read = geom::read_volumes_4d(in, "what was written");
  if (const auto why = why_not_held(flight, read, "what was written")) proof.refusal = *why;
  return proof;
}

}  // namespace

constinit const MissionFormat kVolume4d{
    .format = {.word = "volume4d", .what = "volumes of airspace (ASTM F3548)"},
    .prove = prove,
    .unfit = unfit,
    .writes_with = {FileOption::origin, FileOption::volumes, FileOption::buffer,
                    FileOption::returns, FileOption::return_height, FileOption::autopilot,
                    FileOption::params, FileOption::drag, FileOption::navigation},
    .says_when = true};

}  // namespace traj
