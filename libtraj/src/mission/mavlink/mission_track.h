#pragma once

// A mission's path while it is being flown, and where the vehicle may be instead.

#include <optional>
#include <vector>

#include "mission/firmware/mission_drift.h"
#include "mission/flown/flown_regions.h"
#include "mission_corners.h"
#include "traj/mission/mavlink/mission_flight.h"

namespace traj {

class FlownTrack {
 public:
  const geom::Polyline& path() const { return path_; }

  // Appends a point, and sweeps the way there where it does not begin at the last point. Where it
  // passes, it may turn from wherever it comes within the radius.
  void go(const Vec3& p, double hold, const FlightPart& part, Turn turn);
  void sweep(Hull hull, const FlightPart& part, std::optional<double> stands_on = {});
  void stay(double seconds) { hold_.back() += seconds; }

  // Where it may be when the last point counts as reached, as points of a hull: within the radius,
  // and before points that may count as reached at once.
  Hull reached() const;
  // The next leg may begin anywhere in the hull.
  void leave_from(Hull hull) { leaving_ = std::move(hull); }
  void leave_when_reached();
  Hull from_where();  // it goes on from: takes that hull
  bool starts_at_point() const { return leaving_.empty(); }
  bool rests() const { return leaving_.empty() && turns_.back().radius == 0; }

  void say_speed(double speed);
  void say_no_speed() {
    unsaid_speed_ = own_ = true;
    now_.reset();
  }
  // From here on at that speed or at the one before, nobody knows which; `own`: the vehicle's own,
  // m/s, the fastest that may fly it.
  void may_fly_at(double speed, double own);
  void may_fly_at_own(double own);
  // The largest that any leg may be flown with; `unsaid` where the file says none.
  double most_speed(double unsaid) const;

  std::size_t tight_radii(const Autopilot& autopilot) const;  // items whose leg is not followed
  // Where each of the autopilots may be, from take-off to landing. `out` has the ends of the
  // flight.
  std::vector<Drift> drift(std::span<const Autopilot> autopilots, const FlightPart& landing,
                           double return_height, const FlownMission& out) const;

  // Gives `out` the path and all that belongs to it, corners swept. Call last.
  void finish(const FlightPart& landing, double braking_way, FlownMission& out);

 private:
  Hull begin_of_turn(std::size_t point) const;

  geom::Polyline path_;
  std::vector<double> hold_;  // of each point, as legs_ and turns_
  std::vector<FlightPart> legs_;
  std::vector<Turn> turns_;
  std::vector<std::optional<double>> speeds_;  // m/s, said before the leg to each point
  std::vector<Sweep> sweeps_;
  Hull leaving_;  // from where the next leg may begin, where that is not the last point
  std::optional<double> speed_;  // the largest that was said
  std::optional<double> now_;    // the last, or the largest of those that it may be
  bool own_ = true;              // it may be flying at the vehicle's own speed
  bool unsaid_speed_ = false;    // so it may have flown a leg, the ascent aside
};

}  // namespace traj
