#include "traj/record/moving_obstacles.h"

#include <fmt/format.h>

#include <set>

#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "geom/record/flight_time.h"
#include "geom/text/record_lines.h"

namespace traj {
namespace {

geom::Provenance provenance_of(const MovingRecord& record) {
  geom::Provenance out;
  out.map = record.map;
  out.frame = record.frame;
  return out;
}

}  // namespace

MovingObstacles::MovingObstacles(std::istream& in, std::string source) : name_(std::move(source)) {
  std::set<std::string> ids;
  geom::for_each_line(in, name_, [&](const std::string& line, std::size_t number) {
    MovingRecord record = parse_moving_record(line, name_, number);
    if (!ids.insert(record.id).second) {
      throw geom::InputError(
          name_, number,
          {.expected = "each id once", .found = fmt::format("\"{}\" again", record.id)});
    }
    if (!obstacles_.empty()) {
      geom::require_epoch_agrees(record.epoch, obstacles_.front().epoch, name_, number);
    }
    obstacles_.push_back(std::move(record));
    lines_.push_back(number);
  });
}

void MovingObstacles::require_of(geom::NamedMap& map, const LookAt& look_at) const {
  for (std::size_t i = 0; i < count(); ++i) {
    const geom::Aabb& box = obstacles_[i].box.box;
    map.require(provenance_of(obstacles_[i]), name_, lines_[i]);
    look_at(box, name_, lines_[i]);
  }
}

void MovingObstacles::require_of(geom::Provenance said) const {
  for (std::size_t i = 0; i < count(); ++i) {
    const geom::Provenance here = provenance_of(obstacles_[i]);
    geom::require_map_agrees(here, said, name_, lines_[i]);
    if (!said.map) said.map = here.map;
    if (!said.frame) said.frame = here.frame;
  }
}

void MovingObstacles::require_epoch(const std::optional<std::string>& flights) const {
  geom::require_epoch_agrees(obstacles_.at(0).epoch, flights, name_, 0);
}

std::vector<MovingBox> MovingObstacles::boxes() const {
  std::vector<MovingBox> out;
  for (const MovingRecord& record : obstacles_) out.push_back(record.box);
  return out;
}

MovingObstacles::Found MovingObstacles::check(std::span<const TimedFlight> flights,
                                              const TogetherTask& task, std::size_t left_out,
                                              bool exact, const geom::Execution& run) const {
  if (!flights.empty() || left_out > 0) {
    require_epoch(task.epoch);
  }
  Found out;
  MovingSummary& summary = out.summary;
  summary = {flights.size(), left_out, obstacles_.size(), 0, 0, task.rule.parked, task.epoch};
  struct Looked {
    std::size_t pieces = 0;
    std::vector<MovingConflict> conflicts;
    std::vector<ProvedMoving> proved;
  };
  std::vector<Looked> of(flights.size());
  geom::parallel_for(flights.size(), run, [&](std::size_t i) {
    for (const MovingRecord& obstacle : obstacles_) {
      MovingResult result = check_moving(flights[i], obstacle.box, task.rule.parked);
      of[i].pieces += result.pieces;
      bool clear = result.clear;
      if (clear && exact) {
        auto proof = check_moving_exactly(flights[i], obstacle.box, task.rule.parked);
        clear = proof.clear;
        result.time = proof.time;
        result.place = proof.place;
        if (clear) of[i].proved.push_back({task.ids[i], obstacle.id, std::move(proof)});
      }
      if (!clear) of[i].conflicts.push_back({task.ids[i], obstacle.id, result});
    }
  });
  for (Looked& looked : of) {
    summary.pieces += looked.pieces;
    for (MovingConflict& one : looked.conflicts) out.conflicts.push_back(std::move(one));
    for (ProvedMoving& one : looked.proved) out.proved.push_back(std::move(one));
  }
  summary.refused = out.conflicts.size();
  out.claim = claim(flights, task);
  return out;
}

MovingClaim MovingObstacles::claim(std::span<const TimedFlight> flights,
                                   const TogetherTask& task) const {
  MovingClaim out;
  out.flights = task.ids;
  out.parked = task.rule.parked;
  out.map = task.map;
  out.epoch = task.epoch;
  for (const TimedFlight& flight : flights) out.rooms.push_back(flight.room);
  for (const MovingRecord& obstacle : obstacles_) out.obstacles.push_back(obstacle.id);
  return out;
}

}  // namespace traj
