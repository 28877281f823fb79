#include "traj/home/home_flight.h"

#include <algorithm>

#include "geom/base/usage_error.h"
#include "traj/record/checked_hash.h"
#include "traj/record/trajectory_record.h"

namespace traj {
namespace {

// At one velocity from `a` to `b`: control points evenly spaced.
Segment straight(const Vec3& a, const Vec3& b, double duration) {
  Segment out;
  out.duration = duration;
  for (int i = 0; i < kPoints; ++i) {
    out.point[static_cast<std::size_t>(i)] = i == kDegree ? b : Vec3(a + (b - a) * i / kDegree);
  }
  return out;
}

// m/s with which the vehicle flies paths.
double path_speed(const std::optional<double>& vmax, const geom::Provenance& provenance) {
  if (vmax) return *vmax;
  std::optional<double> speed;
  const geom::Limits limits = provenance.vehicle ? provenance.vehicle->limits : geom::Limits{};
  for (const geom::Limit limit : {geom::Limit::speed, geom::Limit::horizontal_speed}) {
    if (limits[limit]) speed = std::min(speed.value_or(*limits[limit]), *limits[limit]);
  }
  if (speed) return *speed;
  throw geom::UsageError(
      "the speed of the paths is not known, so nobody knows how far their vehicle brakes: give it "
      "with --vmax");
}

HomeFlight flight_of(const geom::PathRecord& record, const std::optional<double>& vmax) {
  HomeFlight out{.id = record.id, .provenance = record.provenance, .kind = "path"};
  if (record.status == geom::PathStatus::found && record.points.size() > 1) {
    out.stages = stages_of(record, path_speed(vmax, record.provenance));
  }
  if (out.stages.empty()) out.without = "it has no path";
  out.checked_hash = checked_hash(record);
  return out;
}

HomeFlight flight_of(const TrajectoryRecord& record) {
  HomeFlight out{record.id, record.provenance, {}};
  if (record.status == TrajectoryStatus::solved) out.stages = stages_of(record.trajectory);
  if (out.stages.empty()) out.without = "it has no trajectory";
  out.checked_hash = checked_hash(record);
  return out;
}

}  // namespace

std::vector<Vec3> HomeFlight::places() const {
  std::vector<Vec3> out;
  for (const FlightStage& stage : stages) out.push_back(stage.where.front());
  return out;
}

void require_vmax_used(const std::optional<double>& vmax, bool any_path) {
  if (!vmax || any_path) return;
  throw geom::UsageError(
      "--vmax says how fast paths are flown, and every flight is a trajectory, which has its own "
      "speed: leave --vmax out");
}

HomeFlight read_home_flight(const geom::JsonFields& fields, const std::optional<double>& vmax) {
  if (fields.text("type", "") == "path") return flight_of(geom::read_path_record(fields), vmax);
  return flight_of(read_trajectory_record(fields));
}

std::vector<ReturnModel> return_models(const Flier& flier) {
  std::vector<ReturnModel> out;
  for (const Autopilot& autopilot : flier.autopilots) {
    out.push_back(return_model(autopilot));
    out.back().around += flier.allowance(false);
  }
  return out;
}

double least_margin(std::span<const ReturnModel> models) {
  double least = 0;
  for (const ReturnModel& model : models) least = std::max(least, model.around.maxCoeff());
  return least;
}

std::vector<FlightStage> stages_of(const geom::PathRecord& path, double speed) {
  std::vector<FlightStage> out;
  double time = 0;
  const auto hold = [&](std::size_t i) {
    if (path.hold.empty() || path.hold[i] == 0) return;
    out.push_back({.from = time, .until = time + path.hold[i], .where = {path.points[i]}});
    time = out.back().until;
  };
  if (!path.points.empty()) hold(0);
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Vec3 leg = path.points[i] - path.points[i - 1];
    const double length = leg.norm();
    if (length > 0) {
      FlightStage stage{.from = time, .until = time + length / speed};
      stage.where = {path.points[i - 1], path.points[i]};
      stage.velocity = {{leg * (speed / length)}};
      stage.curve = straight(path.points[i - 1], path.points[i], length / speed);
      out.push_back(std::move(stage));
      time = out.back().until;
    }
    hold(i);
  }
  return out;
}

}  // namespace traj
