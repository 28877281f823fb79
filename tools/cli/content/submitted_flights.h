#pragma once

// Flights of a folder for an authority, read and proved as the folder's method says.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geom/record/scenes.h"
#include "traj/mission/formats/flier.h"
#include "traj/submit/submitted_flight.h"

namespace cli {

// The scene stays as long as the flight.
struct SubmittedFlight {
  std::shared_ptr<const geom::CollisionScene> scene;
  std::unique_ptr<traj::SubmittedFlight> flight;
};

class SubmittedFlights {
 public:
  // All must outlive this, and what it gives. `params`: the text of autopilot.params, where the
  // method names it. Throws UsageError for an autopilot that nobody knows, and InputError for
  // parameters as traj::set_autopilot().
  SubmittedFlights(geom::Scenes& scenes, const traj::SubmissionMethod& method,
                   const std::optional<std::string>& params);

  // Of a line of flights.jsonl. Threads may call at once. Throws geom::InputError(source, line, …)
  // for a path and for what is no record.
  SubmittedFlight of_record(const std::string& text, const std::string& source,
                            std::size_t line) const;
  // All of a file that an autopilot flies. Throws geom::InputError as traj::read_mission().
  std::vector<SubmittedFlight> of_mission(const std::string& text, const std::string& source) const;

 private:
  geom::Scenes& scenes_;
  const traj::SubmissionMethod& method_;
  traj::Flier flier_;
};

// The parameters of the autopilot in a folder.
inline constexpr const char* kParamsFile = "autopilot.params";

// The files of a flight in a folder, by its id.
std::string volumes_file(const std::string& name);
std::string risk_file(const std::string& name);

}  // namespace cli
