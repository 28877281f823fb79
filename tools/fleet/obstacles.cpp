#include "obstacles.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "geom/base/parallel.h"
#include "traj/fleet/forbidden_by_moving.h"

namespace fleet {
namespace {

// Whether any departure that the flight may have is forbidden.
bool bars(std::span<const traj::DepartureSpan> spans, const traj::FleetFlight& flight) {
  return std::any_of(spans.begin(), spans.end(), [&](const traj::DepartureSpan& span) {
    return span.low <= flight.latest && span.high >= flight.earliest;
  });
}

}  // namespace

void Obstacles::add_map(const std::string& file, const cli::VehicleOptions& vehicle) {
  map_.emplace(file, vehicle, metres_, common_);
}

void Obstacles::add_moving(cli::Moving moving) {
  moving.read();
  if (map_) {
    cli::NamedMap named(map_->map());
    moving.require_of(named, metres_);
  }
  if (stream_.own() > 0) {
    if (!map_) moving.require_of(stream_.provenance());
    moving.require_epoch(stream_.epoch());
  }
  moving_.emplace(std::move(moving));
}

void Obstacles::close(std::vector<traj::FleetFlight>& flights) {
  barred_.assign(flights.size(), {});
  if (map_) close_for_map(flights);
  if (moving_) close_for_moving(flights);
}

void Obstacles::close_for_map(std::vector<traj::FleetFlight>& flights) {
  map_->close(stream_, parked_, flights);
  for (std::size_t i = 0; i < flights.size(); ++i) {
    barred_[i].by_map = bars(flights[i].forbidden, flights[i]);
  }
}

void Obstacles::close_for_moving(std::vector<traj::FleetFlight>& flights) {
  const std::vector<traj::MovingBox> boxes = moving_->boxes();
  geom::parallel_for(flights.size(), common_.execution("moving"), [&](std::size_t i) {
    traj::FleetFlight& flight = flights[i];
    if (flight.settled) return;
    const auto of = traj::forbidden_by_moving(*flight.trajectory, flight.room, boxes, parked_);
    for (std::size_t k = 0; k < of.size(); ++k) {
      if (bars(of[k], flight)) barred_[i].moving.push_back(moving_->id(k));
      flight.forbidden.insert(flight.forbidden.end(), of[k].begin(), of[k].end());
    }
    flight.forbidden = traj::united(std::move(flight.forbidden));
  });
}

std::optional<traj::MovingSummary> Obstacles::prove(std::span<const traj::FleetFlight> flights,
                                                    const traj::Departures& departures) const {
  if (map_) map_->prove(stream_, flights, departures, parked_);
  if (!moving_) return std::nullopt;
  return prove_moving(flights, departures);
}

traj::MovingSummary Obstacles::prove_moving(std::span<const traj::FleetFlight> flights,
                                            const traj::Departures& departures) const {
  traj::TogetherTask task;
  task.rule.parked = parked_;
  task.epoch = stream_.epoch();
  std::vector<traj::TimedFlight> timed;
  for (const traj::Departure& departure : departures.of) {
    const traj::FleetFlight& flight = flights[departure.flight];
    if (!departure.start || flight.settled) continue;
    timed.push_back({flight.trajectory, *departure.start, flight.room});
    task.ids.push_back(stream_.record(departure.flight).id);
  }
  const auto found = moving_->check(timed, task, 0, false, common_.execution("moving"));
  if (found.summary.ok()) return found.summary;
  throw std::runtime_error(
      fmt::format("the departures that were chosen could not be proved: {}; nothing was written",
                  traj::in_words(found.conflicts.front())));
}

}  // namespace fleet
