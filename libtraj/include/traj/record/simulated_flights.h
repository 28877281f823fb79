#pragma once

// All trajectories of a stream, flown by the simulated quadrotor.
//
// Example, not run:
//   traj::SimulatedFlights flights({.profile = {.vehicle = vehicle}}, nullptr);
//   std::ifstream file("trajectories.jsonl");
//   flights.read(file, "trajectories.jsonl", {});
//   flights.fly({}, [](const traj::SimulatedFlight& flown) {
//     std::cout << flown.report.id << ": " << flown.log.samples.size() << " rows\n";
//   });

#include <functional>
#include <istream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/base/shard.h"
#include "geom/record/scenes.h"
#include "traj/flight/monte_carlo.h"
#include "traj/flight/tune.h"
#include "traj/flight/vehicle_profile.h"
#include "traj/record/flight_report.h"
#include "traj/record/trajectory_record.h"

namespace traj {

struct SimulationOptions {
  VehicleProfile profile;  // of the vehicle that flies
  FlightOptions flight;
  std::optional<MonteCarloOptions> spread;   // further runs, of which a tube is made
  std::optional<Disturbances> disturbances;  // prove a tube for them
  bool certificate = false;                  // of the proof, with the tube that it shows
  bool tube = false;                         // check these tubes; only over a map
  int log_period = 10;                       // ms between rows of the log, a multiple of 10
  // Seconds, from whenever: of the CPU of the calling thread. Empty: not measured.
  std::function<double()> clock = {};
};

// One of them.
struct SimulatedFlight {
  FlightReport report;
  FlightLog log;
  std::string certificate;        // a line; empty: not asked for, or there is no proof
  std::optional<double> seconds;  // simulated, hovering included; nothing: there was no trajectory
  double cpu = 0;                 // seconds that simulating it took
};

class SimulatedFlights {
 public:
  // `scenes`: of the map that is flown over, by whose vehicle; null: none. Must outlive this.
  SimulatedFlights(SimulationOptions options, geom::Scenes* scenes)
      : options_(std::move(options)), scenes_(scenes) {}

  // Asked of each trajectory over a map; it may throw.
  using LookAt = std::function<void(const Trajectory&, std::size_t line)>;

  // Those trajectories that the shard takes. Returns how many there are. Throws InputError for
  // records that are none, for flights of more than ten hours, and for those that were made for
  // another vehicle than flies.
  std::size_t read(std::istream& in, const std::string& source, const geom::Shard& shard,
                   const LookAt& look_at = {});

  // Flies all, and gives each to `told`, in order.
  void fly(const geom::Execution& run, const std::function<void(SimulatedFlight)>& told);

  // Throws InputError where there is no solved trajectory.
  TuneResult tune(const FlightCost& cost, const geom::Execution& run) const;
  // For the least proved tube. There must be disturbances. Throws as above.
  TuneResult tune_tube(const geom::Execution& run) const;

  const geom::BoxMap* map() const { return scenes_ ? &scenes_->map() : nullptr; }

 private:
  struct Entry {
    TrajectoryRecord record;
    std::size_t line;
  };
  struct Flown;

  geom::Axes axes(const Entry& entry) const;
  std::string map_of(const Entry& entry) const;  // its hash; empty where nothing names one
  [[noreturn]] void refuse_size(const geom::Vehicle& made_for, std::size_t line) const;
  void require_vehicle(const Entry& entry) const;
  const geom::CollisionScene& scene_for(const Entry& entry);
  ReferenceTrack track_of(const Entry& entry) const;
  std::vector<ReferenceTrack> solved_tracks() const;
  void add(const TrajectoryRecord& record, std::size_t line, const LookAt& look_at);
  Flown flown(const Entry& entry) const;
  FlightReport report_of(const Entry& entry, const ReferenceTrack* track, const Flight& flight);
  void add_runs(const Entry& entry, std::span<const RunOutcome> runs, FlightReport& report);
  std::vector<double> at_tilt(std::span<const double> radius, double tilt) const;
  void add_proof(const Entry& entry, const ReferenceTrack& track, const geom::Execution& run,
                 FlightReport& report);
  std::string certificate_of(const Entry& entry, const FlightReport& report) const;
  void judge(const Entry& entry, const Flight& flight, FlightReport& report);

  SimulationOptions options_;
  geom::Scenes* scenes_;
  std::string source_;
  std::vector<Entry> entries_;
};

}  // namespace traj
