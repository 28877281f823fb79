#include "traj/submit/submitted_flights.h"

#include <memory>
#include <utility>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"
#include "geom/text/json_fields.h"
#include "geom/zone/ground_band.h"
#include "traj/check/check_record.h"
#include "traj/mission/formats/mission_formats.h"
#include "traj/mission/read_mission.h"
#include "traj/record/trajectory_record.h"

namespace traj {
namespace {

Flier flier_of(const SubmissionMethod& method, const std::optional<std::string>& params) {
  Flier flier;
  flier.navigation = method.navigation;
  return with_autopilots(std::move(flier), {.word = method.autopilot,
                                            .parameters = params,
                                            .parameters_name = kParamsFile,
                                            .drag = method.drag});
}

}  // namespace

SubmittedFlights::SubmittedFlights(geom::Scenes& scenes, const SubmissionMethod& method,
                                   const MethodFiles& files)
    : scenes_(scenes),
      method_(method),
      tubes_(files.tubes),
      bare_(scenes.map(), {}, geom::Differences::refused, scenes.budget()) {
  reading_.flier = flier_of(method, files.params);
  reading_.rules.return_height = method.return_height;
  reading_.placement.origin = method.origin;
  reading_.placement.geoid = method.geoid;
  reading_.placement.ground = method.ground;
  if (files.ground) {
    geom::require_same_zero(*files.ground, scenes.map(), kGroundFile);
    reading_.rules.terrain = TerrainRules{files.ground, scenes.map().spec().frame.axes,
                                          method.terrain_error, method.surface};
  }
  if (!files.geoid_grid) return;
  geom::TextInput in(*files.geoid_grid);
  reading_.placement.geoid_grid =
      std::make_shared<const geom::GeoidGrid>(geom::read_geoid_grid(in, kGeoidFile));
}

FlightInScene SubmittedFlights::of_record(const std::string& text, const std::string& source,
                                          std::size_t line) const {
  const geom::JsonFields fields(text, source, line);
  if (fields.text("type") == "path") {
    throw geom::InputError(source, line,
                           {.expected = "a trajectory",
                            .found = "a path, which has no times",
                            .advice = "make a trajectory of it (skyway-traj)"});
  }
  const TrajectoryRecord record = read_trajectory_record(fields);
  FlightInScene out;
  out.scene = scenes_.shared_scene_for(record.provenance, source, line);
  std::shared_ptr<const geom::CollisionScene> bare;
  std::optional<SubmittedTubes> tubes;
  if (tubes_) {
    geom::Provenance room = geom::provenance_of(*out.scene);
    room.margin = 0;
    bare = bare_.shared_scene_for(room, source, line);
    tubes.emplace(*tubes_, *bare);
  }
  out.flight = std::make_unique<SubmittedTrajectory>(*out.scene, record, method_, reading_.flier,
                                                     source, line, tubes);
  out.flight->know_ground(reading_.rules.terrain);
  return out;
}

std::vector<FlightInScene> SubmittedFlights::of_mission(const std::string& text,
                                                        const std::string& source) const {
  if (tubes_) {
    throw geom::InputError(source, {.expected = "trajectories alone, which proved tubes are of",
                                    .found = "a mission",
                                    .advice = "leave --tube or the mission out"});
  }
  const MissionFormat& format = recognised_mission_format(text);
  const std::shared_ptr<const geom::CollisionScene> scene = scenes_.shared_scene_for({}, source, 0);
  std::vector<FlightInScene> out;
  for (const FileFlight& one :
       read_mission(text, source, format, reading_, scene->map().spec().frame)) {
    out.push_back(
        {scene, std::make_unique<SubmittedMission>(*scene, one, method_, reading_.flier)});
    out.back().flight->know_ground(reading_.rules.terrain);
    out.back().notes = one.notes;
    const FlownMission* const mission = mission_of(one.flown);
    out.back().ends_at_home = mission && mission->ends_at_home;
    if (std::string note = corner_note(one.flown); !note.empty()) {
      out.back().notes.push_back(std::move(note));
    }
  }
  return out;
}

void TerrainUse::take(const ReportRecord& report) {
  if (!report.terrain) return;
  (report.terrain->surface ? surface : error) = true;
}

std::optional<std::string_view> TerrainUse::idle(const SubmissionMethod& method) const {
  if (method.terrain_error && !error) return "terrain_error";
  if (method.surface && !surface) return kSurfaceBandKey;
  return std::nullopt;
}

std::string volumes_file(const std::string& name) { return "volumes/" + name + ".json"; }
std::string risk_file(const std::string& name) { return "risk/" + name + ".geojson"; }

}  // namespace traj
