#pragma once

// Where a vehicle is, and how it is turned, over time: of a trajectory or of a flight.
//
// Example:
//   const traj::MovingVehicle vehicle("q1", trajectory, map.spec().frame.axes);
//   const geom::picture::View view = geom::picture::view_from({}, vehicle.pose(1.5));
//   const geom::picture::Film film(map, {.vehicle = vehicle.filmed()}, {});
//   assert(film.width() == view.width);

#include <string>
#include <vector>

#include "geom/map/frame.h"
#include "geom/picture/camera.h"
#include "geom/picture/film.h"
#include "traj/curve/trajectory.h"
#include "traj/flight/flight_log.h"

namespace traj {

class MovingVehicle {
 public:
  // As its controller would follow it exactly: attitude by differential flatness; where a segment
  // has no yaw, along the velocity (add_yaw). At least one segment.
  MovingVehicle(std::string id, Trajectory trajectory, geom::Axes axes);
  // As it was: linear between the rows, attitudes along the shortest turn. At least one row. Where
  // the log has no attitude, that of the row before, else level; no velocity, that of the way.
  explicit MovingVehicle(FlightLog flight);

  const std::string& id() const { return id_; }
  double begin() const { return begin_; }  // seconds
  double end() const { return end_; }
  geom::picture::Pose pose(double t) const;  // clamped to [begin, end]
  double speed(double t) const;              // m/s
  // Metres between a flight and its setpoint; 0 of a trajectory. Needs setpoints in all rows.
  double tracking_error(double t) const;
  bool has_setpoints() const;
  bool is_flight() const { return !flight_.samples.empty(); }

  // The way it takes, for drawing: points not further apart than `step` seconds.
  std::vector<Vec3> way(double step) const;

  // For films; must not outlive this.
  geom::picture::FilmedVehicle filmed() const;

 private:
  struct Between {
    std::size_t first;
    double share;
  };
  Between between(double t) const;
  State state(double t) const;

  std::string id_;
  Trajectory trajectory_;
  geom::Axes axes_ = geom::Axes::enu;
  FlightLog flight_;
  double begin_ = 0;
  double end_ = 0;
};

}  // namespace traj
