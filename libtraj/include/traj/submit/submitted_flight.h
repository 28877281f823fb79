#pragma once

// One flight of a folder for an authority: its volumes, and the proof that they hold it.
//
// Example:
//   traj::TrajectoryRecord record{.id = "q1", .status = traj::TrajectoryStatus::solved};
//   record.trajectory = trajectory;
//   record.limits[traj::Limit::speed] = 10;
//   record.time = {.epoch = "2026-05-04T06:30:00Z", .start = 12};
//   traj::SubmissionMethod method{.origin = {47.4, 8.5, 400}};
//   method.risk.dimension = 0.7;
//   const traj::SubmittedTrajectory flight(scene, record, method, {}, "t.jsonl", 1);
//   if (flight.refusal().empty()) std::cout << traj::volumes_json(flight.intent());

#include <optional>
#include <string>
#include <string_view>

#include "geom/collision/collision.h"
#include "traj/check/flight_set.h"
#include "traj/home/flight_return.h"
#include "traj/mission/airspace/held.h"
#include "traj/mission/read_mission.h"
#include "traj/record/report_record.h"
#include "traj/record/tube_reports.h"
#include "traj/submit/risk_volumes.h"
#include "traj/submit/submission.h"

namespace traj {

// Proved when it is made. Scene and method must outlive it.
class SubmittedFlight {
 public:
  SubmittedFlight(const geom::CollisionScene& scene, const SubmissionMethod& method);
  virtual ~SubmittedFlight() = default;
  SubmittedFlight(const SubmittedFlight&) = delete;
  SubmittedFlight& operator=(const SubmittedFlight&) = delete;

  const ReportRecord& report() const { return report_; }

  // Why the flight cannot be in a folder: the check refuses it, it has no time, no limit on its
  // speed, a battery that does not last, or it comes down below what is said to be the lowest
  // ground. Empty: it can.
  std::string refusal() const;

  // Only of a flight without a refusal:

  // The volumes of airspace: nominal and, for ways home, off-nominal.
  virtual geom::IntentVolumes intent() const = 0;
  // Nothing where these volumes hold the flight and, for ways home, its returns. Else why not.
  virtual std::optional<std::string> why_not_held(const geom::IntentVolumes& intent) const = 0;
  virtual std::string begins() const = 0;  // instants
  virtual std::string ends() const = 0;
  virtual std::string_view kind() const = 0;
  virtual double duration() const = 0;  // s

  // m/s that it never exceeds, by its proved limits: on the speed, or on both of its parts.
  std::optional<double> speed() const;
  RiskTask risk_task() const;

  // The ground below the flights of a folder, where a height model is given.
  void know_ground(const std::optional<TerrainRules>& ground) { ground_ = ground; }
  // The claims that follow from the volumes as they were read; paths and people are left open.
  FlightClaims claims(const geom::IntentVolumes& intent, const RiskVolumes& risk) const;

 protected:
  virtual std::optional<std::string> why_no_times() const = 0;
  // The z of its lowest place, m, of a flight whose times are known.
  virtual double lowest() const = 0;

  const geom::CollisionScene& scene_;
  const SubmissionMethod& method_;
  ReportRecord report_;
  std::optional<FlightReturn> return_;  // where its volumes are to be ways home
  std::string_view aircraft_;           // that its file names, as vehicle_named() takes it

 private:
  // Why the operation's vehicle is neither the one that was proved nor the one that the file names.
  std::optional<std::string> why_not_of_vehicle() const;

  std::optional<TerrainRules> ground_;
};

// The proved tubes of trajectories, and the scene of the vehicle without a margin.
struct SubmittedTubes {
  const TubeReports& tubes;
  const geom::CollisionScene& scene;
};

class SubmittedTrajectory : public SubmittedFlight {
 public:
  // Checks it in exact numbers too. With `tubes`, its volumes hold the vehicle in its proved tube,
  // which must be clear of the map, in place of the margin. Throws geom::InputError(source, line,
  // …) as check_record() and check_as_geography().
  SubmittedTrajectory(const geom::CollisionScene& scene, const TrajectoryRecord& record,
                      const SubmissionMethod& method, const Flier& flier, std::string_view source,
                      std::size_t line, const std::optional<SubmittedTubes>& tubes = {});

  geom::IntentVolumes intent() const override;
  std::optional<std::string> why_not_held(const geom::IntentVolumes& intent) const override;
  std::string begins() const override;
  std::string ends() const override;
  std::string_view kind() const override { return "trajectory"; }
  double duration() const override;

  // A line that anyone can follow (docs/certificates.md). Only of a flight without a refusal.
  std::string certificate() const;

  // As FlightSet::add(), with the room that it was checked for.
  void add_to(FlightSet& flights, std::string_view source, std::size_t line) const {
    flights.add(record_, room_of(scene_, record_), source, line);
  }

 private:
  std::optional<std::string> why_no_times() const override;
  double lowest() const override;
  FlightOnEarth on_earth() const;

  TrajectoryRecord record_;
  Trajectory enu_;
};

// A file that an autopilot flies. Its volumes are there from the method's begin to its end.
class SubmittedMission : public SubmittedFlight {
 public:
  SubmittedMission(const geom::CollisionScene& scene, const FileFlight& file,
                   const SubmissionMethod& method, const Flier& flier);

  geom::IntentVolumes intent() const override;
  std::optional<std::string> why_not_held(const geom::IntentVolumes& intent) const override;
  std::string begins() const override { return *method_.begins; }
  std::string ends() const override { return *method_.ends; }
  std::string_view kind() const override { return "mission"; }
  double duration() const override { return seconds_; }

 private:
  // Places of the vehicle, and metres along each axis of the map that it reaches around them.
  struct Region {
    std::vector<Vec3> hull;
    Vec3 room;
  };

  std::optional<std::string> why_no_times() const override;
  double lowest() const override;
  std::vector<Region> regions() const;

  FlownMission mission_;
  double seconds_ = 0;
  bool is_mission_ = false;
};

// Of the details of an operational intent: what stands in a file of volumes/.
std::string volumes_json(const geom::IntentVolumes& intent, std::optional<int> priority = {});

}  // namespace traj
