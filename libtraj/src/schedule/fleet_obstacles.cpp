#include "traj/schedule/fleet_obstacles.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "geom/base/parallel.h"
#include "traj/fleet/forbidden_by_moving.h"

namespace traj {
namespace {

// Whether any departure that the flight may have is forbidden.
bool bars(std::span<const DepartureSpan> spans, const FleetFlight& flight) {
  return std::any_of(spans.begin(), spans.end(), [&](const DepartureSpan& span) {
    return span.low <= flight.latest && span.high >= flight.earliest;
  });
}

}  // namespace

void FleetObstacles::add_map(TimedMap map, TimedMap::LookAt look_at) {
  map_.emplace(std::move(map));
  look_at_ = std::move(look_at);
}

void FleetObstacles::add_moving(MovingObstacles moving, const MovingObstacles::LookAt& look_at) {
  if (map_) {
    geom::NamedMap named(map_->map());
    moving.require_of(named, look_at);
  }
  if (stream_.own() > 0) {
    if (!map_) moving.require_of(stream_.provenance());
    moving.require_epoch(stream_.epoch());
  }
  moving_.emplace(std::move(moving));
}

void FleetObstacles::close(std::vector<FleetFlight>& flights) {
  barred_.assign(flights.size(), {});
  if (map_) close_for_map(flights);
  if (moving_) close_for_moving(flights);
}

void FleetObstacles::close_for_map(std::vector<FleetFlight>& flights) {
  map_->close(stream_, parked_, look_at_, flights);
  for (std::size_t i = 0; i < flights.size(); ++i) {
    barred_[i].by_map = bars(flights[i].forbidden, flights[i]);
  }
}

void FleetObstacles::close_for_moving(std::vector<FleetFlight>& flights) {
  const std::vector<MovingBox> boxes = moving_->boxes();
  geom::parallel_for(flights.size(), run_, [&](std::size_t i) {
    FleetFlight& flight = flights[i];
    if (flight.settled) return;
    const auto of = forbidden_by_moving(*flight.trajectory, flight.room, boxes, parked_);
    for (std::size_t k = 0; k < of.size(); ++k) {
      if (bars(of[k], flight)) barred_[i].moving.push_back(moving_->id(k));
      flight.forbidden.insert(flight.forbidden.end(), of[k].begin(), of[k].end());
    }
    flight.forbidden = united(std::move(flight.forbidden));
  });
}

std::optional<MovingSummary> FleetObstacles::prove(std::span<const FleetFlight> flights,
                                                   const Departures& departures) const {
  if (map_) map_->prove(stream_, flights, departures, parked_);
  if (!moving_) return std::nullopt;
  return prove_moving(flights, departures);
}

MovingSummary FleetObstacles::prove_moving(std::span<const FleetFlight> flights,
                                           const Departures& departures) const {
  TogetherTask task;
  task.rule.parked = parked_;
  task.epoch = stream_.epoch();
  std::vector<TimedFlight> timed;
  for (const Departure& departure : departures.of) {
    const FleetFlight& flight = flights[departure.flight];
    if (!departure.start || flight.settled) continue;
    timed.push_back({flight.trajectory, *departure.start, flight.room});
    task.ids.push_back(stream_.record(departure.flight).id);
  }
  const auto found = moving_->check(timed, task, 0, false, run_);
  if (found.summary.ok()) return found.summary;
  throw std::runtime_error(
      fmt::format("the departures that were chosen could not be proved: {}; nothing was written",
                  in_words(found.conflicts.front())));
}

}  // namespace traj
