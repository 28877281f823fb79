#pragma once

// Tubes of the trajectories of a stream, as skyway-fly reports them.
//
// Example:
//   std::istringstream file(
//       R"({"type":"flight","id":"q1","controller":"cascade","monte_carlo":{"lost":0,"tube":)"
//       R"({"period":0.1,"largest":0.2,"tilt":0.2,"trajectory":"abc","radius":[0.2]}}})");
//   const auto tubes = traj::TubeReports::read(file, "flights.jsonl");
//   assert(!tubes.tube_of("q2", trajectory, {}));

#include <istream>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "geom/base/error.h"
#include "traj/curve/trajectory.h"
#include "traj/record/tube_record.h"

namespace traj {

// Nothing where a tube is of this trajectory: by its hash (which a proved tube has), axes, vehicle
// and duration; and where its proof was not refused. Else what is wrong. `over` has the axes of the
// trajectory and the vehicle that flies it, where they are known.
std::optional<geom::Fault> why_not_of(const TubeRecord& tube, const Trajectory& trajectory,
                                      const geom::Provenance& over);

class TubeReports {
 public:
  // Flights without a tube are left out. Throws InputError(source, line, …) as parse_tube(), and
  // for a second tube of one id.
  static TubeReports read(std::istream& in, const std::string& source);

  // The tube of the trajectory of an id; null where no report has it. Throws InputError (the
  // report's source and line, …) for what why_not_of() tells.
  const TubeRecord* tube_of(std::string_view id, const Trajectory& trajectory,
                            const geom::Provenance& over) const;
  // The same; throws InputError where there is none.
  const TubeRecord& require_tube(std::string_view id, const Trajectory& trajectory,
                                 const geom::Provenance& over) const;

  const std::string& source() const { return source_; }
  bool empty() const { return tubes_.empty(); }

 private:
  struct Entry {
    std::size_t line = 0;
    TubeRecord tube;
  };
  std::string source_;
  std::map<std::string, Entry, std::less<>> tubes_;  // by id
};

}  // namespace traj
