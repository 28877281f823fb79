#include "submitted_flights.h"

#include <memory>
#include <sstream>

#include "cli/answer/exit.h"
#include "cli/option/autopilot_option.h"
#include "geom/base/error.h"
#include "geom/text/json_fields.h"
#include "traj/mission/formats/mission_formats.h"
#include "traj/mission/read_mission.h"
#include "traj/record/trajectory_record.h"

namespace cli {
namespace {

traj::Flier flier_of(const traj::SubmissionMethod& method,
                     const std::optional<std::string>& params) {
  if (!traj::autopilots_of(method.autopilot)) {
    throw UsageError("--autopilot: expected " + traj::autopilot_words() + ", found \"" +
                     method.autopilot + '"');
  }
  AutopilotOptions options{.word = method.autopilot, .drag = method.drag};
  options.params = kParamsFile;
  options.params_text = params;
  if (!params) options.params.clear();
  options.flier.navigation = method.navigation;
  options.settle(std::nullopt);
  return options.flier;
}

}  // namespace

SubmittedFlights::SubmittedFlights(geom::Scenes& scenes, const traj::SubmissionMethod& method,
                                   const MethodFiles& files)
    : scenes_(scenes),
      method_(method),
      flier_(flier_of(method, files.params)),
      tubes_(files.tubes),
      bare_(scenes.map(), {}, geom::Differences::refused, scenes.budget()) {
  placement_.origin = method.origin;
  placement_.geoid = method.geoid;
  placement_.ground = method.ground;
  if (!files.geoid_grid) return;
  std::istringstream in(*files.geoid_grid);
  placement_.geoid_grid =
      std::make_shared<const geom::GeoidGrid>(geom::read_geoid_grid(in, kGeoidFile));
}

SubmittedFlight SubmittedFlights::of_record(const std::string& text, const std::string& source,
                                            std::size_t line) const {
  const geom::JsonFields fields(text, source, line);
  if (fields.text("type") == "path") {
    throw geom::InputError(source, line,
                           {.expected = "a trajectory",
                            .found = "a path, which has no times",
                            .advice = "make a trajectory of it (skyway-traj)"});
  }
  const traj::TrajectoryRecord record = traj::read_trajectory_record(fields);
  SubmittedFlight out;
  out.scene = scenes_.shared_scene_for(record.provenance, source, line);
  std::shared_ptr<const geom::CollisionScene> bare;
  std::optional<traj::SubmittedTubes> tubes;
  if (tubes_) {
    geom::Provenance room = geom::provenance_of(*out.scene);
    room.margin = 0;
    bare = bare_.shared_scene_for(room, source, line);
    tubes.emplace(*tubes_, *bare);
  }
  out.flight = std::make_unique<traj::SubmittedTrajectory>(*out.scene, record, method_, flier_,
                                                           source, line, tubes);
  return out;
}

std::vector<SubmittedFlight> SubmittedFlights::of_mission(const std::string& text,
                                                          const std::string& source) const {
  if (tubes_) {
    throw geom::InputError(source, {.expected = "trajectories alone, which proved tubes are of",
                                    .found = "a mission",
                                    .advice = "leave --tube or the mission out"});
  }
  traj::MissionReading reading;
  reading.placement = placement_;
  reading.rules.return_height = method_.return_height;
  reading.flier = flier_;
  const traj::MissionFormat& format = traj::recognised_mission_format(text);
  const std::shared_ptr<const geom::CollisionScene> scene = scenes_.shared_scene_for({}, source, 0);
  std::vector<SubmittedFlight> out;
  for (const traj::FileFlight& one :
       traj::read_mission(text, source, format, reading, scene->map().spec().frame)) {
    out.push_back({scene, std::make_unique<traj::SubmittedMission>(*scene, one, method_, flier_)});
  }
  return out;
}

std::string volumes_file(const std::string& name) { return "volumes/" + name + ".json"; }
std::string risk_file(const std::string& name) { return "risk/" + name + ".geojson"; }

}  // namespace cli
