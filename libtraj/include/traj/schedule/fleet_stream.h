#pragma once

// The flights of a stream of trajectories, other ways that they may take, and flights of others.
//
// Example:
//   traj::TrajectoryRecord record{.id = "q1", .status = traj::TrajectoryStatus::solved};
//   record.trajectory = trajectory;
//   std::istringstream in(traj::to_json_line(record));
//   traj::FleetStream stream({.max_delay = 60}, {});
//   stream.read(in, "trajectories.jsonl");
//   assert(stream.flights().size() == 1 && stream.flights()[0].latest == 60);

#include <deque>
#include <istream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/record/agreed_room.h"
#include "traj/fleet/fleet_flight.h"
#include "traj/record/trajectory_record.h"
#include "traj/together/spacing.h"

namespace traj {

struct StreamRules {
  double max_delay = 600;         // seconds that a flight may wait
  bool by_vehicles = false;       // the distance follows from the vehicles' sizes
  bool moving = false;            // what keeps clear of obstacles that move is the vehicle's box
  geom::AskedRoom asked;          // the vehicle and margin of flights that name none
  std::optional<Zone> zone = {};  // that is to hold two vehicles
};

class FleetStream {
 public:
  // `run`: its threads read records.
  FleetStream(const StreamRules& rules, const geom::Execution& run)
      : rules_(rules), run_(run), vehicles_(rules.zone) {}

  // The flights, in the order in which they come. Throws InputError for an id that comes again, for
  // records of another map, frame or epoch, and what no departure can be chosen for. Throws
  // UsageError for a zone that is smaller than two of the vehicles.
  void read(std::istream& in, const std::string& source);
  // Other ways for them, with their ids. What is no solved trajectory is passed over. Throws
  // InputError as read() does, and for a way that begins or ends elsewhere, or has less room. After
  // read().
  void read_ways(std::istream& in, const std::string& source);
  // Flights that are settled, as another operator's: each depart at its start. They have numbers
  // after those of the stream, and are no entries. Throws InputError as read() does, and for one
  // without a trajectory or a start. After read().
  void read_others(std::istream& in, const std::string& source);

  // Of all ways; those of a number follow each other, the stream's own first. Once all is read.
  std::vector<FleetFlight> flights() const;

  // Of way `i` of flights().
  const TrajectoryRecord& record(std::size_t i) const { return *ways_.at(i).record; }
  // How many numbers are flights of the stream, and how many after them are of others.
  std::size_t own() const { return own_.size(); }
  std::size_t others() const { return others_.size(); }

  // All records of the stream in their order, with their number where they are flights.
  struct Entry {
    const TrajectoryRecord* record = nullptr;
    std::optional<std::uint32_t> number;
  };
  const std::vector<Entry>& entries() const { return entries_; }

  const geom::Provenance& provenance() const { return provenance_; }
  const std::optional<std::string>& epoch() const { return epoch_; }

 private:
  struct Way {
    const TrajectoryRecord* record = nullptr;
    FleetFlight flight;
  };

  using Add = void (FleetStream::*)(TrajectoryRecord, const std::string&, std::size_t);
  void read_each(std::istream& in, const std::string& source, Add member);
  void add(TrajectoryRecord record, const std::string& source, std::size_t line);
  void add_way(TrajectoryRecord record, const std::string& source, std::size_t line);
  void add_other(TrajectoryRecord record, const std::string& source, std::size_t line);
  void gather();
  void require_agrees(const TrajectoryRecord& record, const std::string& source, std::size_t line);
  geom::Vec3 room_of(const TrajectoryRecord& record, const std::string& source, std::size_t line);
  geom::Vec3 room_of_other(const TrajectoryRecord& record, const std::string& source,
                           std::size_t line);

  StreamRules rules_;
  geom::Execution run_;
  VehiclesInZone vehicles_;
  std::deque<TrajectoryRecord> records_;  // stay where they are
  std::vector<Entry> entries_;
  std::vector<Way> own_;                                      // by number
  std::vector<Way> alternatives_;                             // as they come
  std::vector<Way> others_;                                   // as they come, without numbers
  std::vector<Way> ways_;                                     // all, by number
  std::map<std::string, std::size_t, std::less<>> entry_of_;  // by id
  std::set<std::string, std::less<>> others_ids_;
  bool any_ = false;
  geom::Provenance provenance_;  // map and frame of those that say them
  std::optional<std::string> epoch_;
};

}  // namespace traj
