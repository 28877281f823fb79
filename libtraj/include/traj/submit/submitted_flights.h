#pragma once

// Flights of a folder for an authority, read and proved as the folder's method says.
//
// Example:
//   geom::Scenes scenes(map, {.vehicle = vehicle, .margin = 0.2}, geom::Differences::refused, 1e9);
//   traj::SubmissionMethod method{.made_for = geom::provenance_of(scene), .limits = limits};
//   const traj::SubmittedFlights flights(scenes, method, {});
//   assert(flights.reading().placement.origin->latitude == method.origin.latitude);

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/ground_model.h"
#include "geom/record/scenes.h"
#include "traj/mission/formats/reading.h"
#include "traj/submit/submitted_flight.h"

namespace traj {

// The scene stays as long as the flight.
struct FlightInScene {
  std::shared_ptr<const geom::CollisionScene> scene;
  std::unique_ptr<SubmittedFlight> flight;
  std::vector<std::string> notes = {};  // what its user should know before flying it
  bool ends_at_home = false;  // a mission that ends with a return, at a height that no file says
};

// The files of a folder on which the reading of missions rests, by their texts, where the method
// names them.
struct MethodFiles {
  std::optional<std::string> params = {};
  std::optional<std::string> geoid_grid = {};
  const TubeReports* tubes = nullptr;         // those of the method; must outlive what reads them
  const geom::GroundModel* ground = nullptr;  // likewise
};
inline constexpr const char* kParamsFile = "autopilot.params";
inline constexpr const char* kGeoidFile = "geoid.gtx";
inline constexpr const char* kGroundFile = "terrain.ground";

// Which words of a method about the ground its missions use.
struct TerrainUse {
  bool error = false;    // heights above an autopilot's own terrain
  bool surface = false;  // an aircraft that follows the surface

  void take(const ReportRecord& report);
  // The first of the method's "terrain_error" and "surface_band" that no mission uses.
  std::optional<std::string_view> idle(const SubmissionMethod& method) const;
};

class SubmittedFlights {
 public:
  // All must outlive this, and what it gives. Throws UsageError for an autopilot that nobody knows,
  // and InputError for parameters as set_autopilot(), for a grid that is none, and for the ground
  // of another map.
  SubmittedFlights(geom::Scenes& scenes, const SubmissionMethod& method, const MethodFiles& files);

  // How missions are read.
  const MissionReading& reading() const { return reading_; }

  // Of a line of flights.jsonl. Threads may call at once. Throws geom::InputError(source, line, …)
  // for a path and for what is no record.
  FlightInScene of_record(const std::string& text, const std::string& source,
                          std::size_t line) const;
  // All of a file that an autopilot flies. Throws geom::InputError as read_mission().
  std::vector<FlightInScene> of_mission(const std::string& text, const std::string& source) const;

 private:
  geom::Scenes& scenes_;
  const SubmissionMethod& method_;
  MissionReading reading_;
  const TubeReports* tubes_;
  mutable geom::Scenes bare_;  // without a margin, for tubes
};

// The file of a folder with the proved tubes of its trajectories.
inline constexpr const char* kTubesFile = "tubes.jsonl";

// The files of a flight in a folder, by its id.
std::string volumes_file(const std::string& name);
std::string risk_file(const std::string& name);

}  // namespace traj
