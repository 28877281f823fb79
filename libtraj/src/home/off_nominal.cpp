#include "traj/home/off_nominal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "geom/base/error.h"
#include "geom/text/instant.h"
#include "traj/mission/airspace/volume_around.h"

namespace traj {
namespace {

// A region of a return in east, north, up, with its room, and its time after the flight's begin.
struct Reached {
  AirspacePrism prism;
  double from = 0;
  double until = 0;
};

AirspacePrism prism_of(const Prism& region, const Vec3& room, geom::Axes axes) {
  std::vector<Vec2> plan;
  for (const Vec2& p : region.plan) {
    for (const double x : {-room.x(), room.x()}) {
      for (const double y : {-room.y(), room.y()}) {
        plan.push_back(geom::to_enu(axes, Vec3(p.x() + x, p.y() + y, 0)).head<2>());
      }
    }
  }
  return {plan_hull(std::move(plan)), region.low - room.z(), region.high + room.z()};
}

std::vector<ReturnSweep> all_sweeps(const ReturnModel& model, const FlightStage& stage,
                                    const ReturnTask& task) {
  std::vector<ReturnSweep> out = return_sweeps(model, stage, {task.home, 0});
  for (const Vec3& rally : task.rally) {
    const Vec3 ground(rally.x(), rally.y(), task.home.z());
    const auto more = return_sweeps(model, stage, {ground, rally.z() - ground.z()});
    out.insert(out.end(), more.begin(), more.end());
  }
  return out;
}

std::vector<Reached> all_reached(const FlightReturn& flight, const ReturnsOnEarth& over) {
  std::vector<Reached> out;
  for (std::size_t i = 0; i < flight.stages.size(); ++i) {
    const ReturnModel& model = flight.task.models[i];
    const Vec3 room = over.room + model.around + flight.task.room;
    for (const FlightStage& stage : flight.stages[i]) {
      const auto sweeps = all_sweeps(model, stage, flight.task);
      const double lasts = longest_seconds(model, sweeps);
      for (const ReturnSweep& one : sweeps) {
        out.push_back({prism_of(one.region, room, over.axes), stage.from, stage.until + lasts});
      }
    }
  }
  return out;
}

void add(const Reached& other, Reached& to) {
  if (to.prism.outline.empty()) {
    to = other;
    return;
  }
  std::vector<Vec2>& plan = to.prism.outline;
  plan.insert(plan.end(), other.prism.outline.begin(), other.prism.outline.end());
  plan = plan_hull(std::move(plan));
  to.prism.low = std::min(to.prism.low, other.prism.low);
  to.prism.high = std::max(to.prism.high, other.prism.high);
  to.from = std::min(to.from, other.from);
  to.until = std::max(to.until, other.until);
}

std::string instant(const std::optional<std::string>& made, std::string_view source) {
  if (made) return *made;
  throw geom::InputError(source, {.expected = "returns within the years 0 to 9999"});
}

}  // namespace

std::vector<geom::Volume4d> off_nominal_volumes(const FlightReturn& flight,
                                                const ReturnsOnEarth& over, std::size_t most,
                                                std::string_view source) {
  assert(most >= 1);
  const std::vector<Reached> reached = all_reached(flight, over);
  double duration = 0;
  for (const auto& stages : flight.stages) {
    for (const FlightStage& stage : stages) duration = std::max(duration, stage.until);
  }
  std::vector<Reached> stretches(most);
  for (const Reached& one : reached) {
    const double share = duration > 0 ? one.from / duration : 0;
    const auto stretch = static_cast<std::size_t>(share * static_cast<double>(most));
    add(one, stretches[std::min(stretch, most - 1)]);
  }
  std::vector<geom::Volume4d> out;
  for (const Reached& one : stretches) {
    if (one.prism.outline.empty()) continue;
    geom::Volume4d& volume = out.emplace_back(volume_around(one.prism, over.origin, source));
    volume.start = instant(geom::instant_not_after(over.epoch, over.start + one.from), source);
    volume.end = instant(geom::instant_not_before(over.epoch, over.start + one.until), source);
  }
  return out;
}

std::optional<std::string> why_returns_not_held(const FlightReturn& flight,
                                                const ReturnsOnEarth& over,
                                                std::span<const geom::Volume4d> volumes,
                                                std::string_view source) {
  const auto is_in = [&](const Reached& one, const geom::Volume4d& volume) {
    return volume.lower && volume.upper && volume.start && volume.end &&
           geom::is_not_after(*volume.start, over.epoch, over.start + one.from) &&
           geom::is_not_before(*volume.end, over.epoch, over.start + one.until) &&
           holds_prism(volume, one.prism, over.origin, source);
  };
  for (const Reached& one : all_reached(flight, over)) {
    const bool held = std::any_of(volumes.begin(), volumes.end(),
                                  [&](const geom::Volume4d& volume) { return is_in(one, volume); });
    if (held) continue;
    return fmt::format("no off-nominal volume holds the return that begins at {:.3f} s", one.from);
  }
  return std::nullopt;
}

}  // namespace traj
