#pragma once

// Tubes of the trajectories of a stream, as skyway-fly reports them.
//
// Example:
//   std::istringstream file(R"({"type":"flight","id":"q1",)"
//                           R"("monte_carlo":{"tube":{"period":0.1,"radius":[0.2]}}})");
//   const auto tubes = traj::TubeReports::read(file, "flights.jsonl");
//   const traj::TrajectoryRecord other{.id = "q2"};
//   assert(!tubes.tube_of(other, {}));

#include <istream>
#include <map>
#include <string>

#include "traj/record/trajectory_record.h"
#include "traj/record/tube_record.h"

namespace traj {

class TubeReports {
 public:
  // Flights without a tube are left out. Throws InputError(source, line, …) as parse_tube(), and
  // for a second tube of one id.
  static TubeReports read(std::istream& in, const std::string& source);

  // The tube of a solved trajectory; null where no report has its id. `over` has the axes of the
  // trajectory and the vehicle that flies it, where they are known. Throws InputError (the report's
  // source and line, …) for a proof that was refused, and for a tube of another trajectory (by its
  // hash, which a proved tube has), axes, vehicle or duration.
  const TubeRecord* tube_of(const TrajectoryRecord& record, const geom::Provenance& over) const;

  const std::string& source() const { return source_; }
  bool empty() const { return tubes_.empty(); }

 private:
  struct Entry {
    std::size_t line = 0;
    TubeRecord tube;
  };
  void require_same(const Entry& entry, const TrajectoryRecord& record,
                    const geom::Provenance& over) const;
  void require_whole(const Entry& entry, double duration) const;

  std::string source_;
  std::map<std::string, Entry, std::less<>> tubes_;  // by id
};

}  // namespace traj
