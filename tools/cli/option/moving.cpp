#include "moving.h"

#include <fmt/format.h>

#include <array>
#include <set>

#include "cli/file/files.h"
#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "geom/record/flight_time.h"

namespace cli {
namespace {

geom::Provenance provenance_of(const traj::MovingRecord& record) {
  geom::Provenance out;
  out.map = record.map;
  out.frame = record.frame;
  return out;
}

}  // namespace

void Moving::add_to(CLI::App& app, const std::string& what) {
  app.add_option("--moving", file_, "obstacles that move, JSON Lines: " + what)->type_name("FILE");
}

void Moving::read() {
  InputFile file(file_);
  name_ = file.name();
  std::set<std::string> ids;
  file.for_each_line([&](const std::string& line, std::size_t number) {
    traj::MovingRecord record = traj::parse_moving_record(line, name_, number);
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

void Moving::require_of(NamedMap& map, const MetresOption& metres) const {
  for (std::size_t i = 0; i < count(); ++i) {
    const geom::Aabb& box = obstacles_[i].box.box;
    map.require(provenance_of(obstacles_[i]), name_, lines_[i]);
    metres.check_input(map.map().spec().frame, std::array{box.min, box.max}, name_, lines_[i]);
  }
}

void Moving::require_of(geom::Provenance said) const {
  for (std::size_t i = 0; i < count(); ++i) {
    const geom::Provenance here = provenance_of(obstacles_[i]);
    geom::require_map_agrees(here, said, name_, lines_[i]);
    if (!said.map) said.map = here.map;
    if (!said.frame) said.frame = here.frame;
  }
}

void Moving::require_epoch(const std::optional<std::string>& flights) const {
  geom::require_epoch_agrees(obstacles_.at(0).epoch, flights, name_, 0);
}

std::vector<traj::MovingBox> Moving::boxes() const {
  std::vector<traj::MovingBox> out;
  for (const traj::MovingRecord& record : obstacles_) out.push_back(record.box);
  return out;
}

Moving::Found Moving::check(std::span<const traj::TimedFlight> flights,
                            const traj::TogetherTask& task, std::size_t left_out, bool exact,
                            const geom::Execution& run) const {
  if (!flights.empty() || left_out > 0) {
    require_epoch(task.epoch);
  }
  Found out;
  traj::MovingSummary& summary = out.summary;
  summary = {flights.size(), left_out, obstacles_.size(), 0, 0, task.rule.parked, task.epoch};
  struct Looked {
    std::size_t pieces = 0;
    std::vector<traj::MovingConflict> conflicts;
    std::vector<traj::ProvedMoving> proved;
  };
  std::vector<Looked> of(flights.size());
  geom::parallel_for(flights.size(), run, [&](std::size_t i) {
    for (const traj::MovingRecord& obstacle : obstacles_) {
      traj::MovingResult result = traj::check_moving(flights[i], obstacle.box, task.rule.parked);
      of[i].pieces += result.pieces;
      bool clear = result.clear;
      if (clear && exact) {
        auto proof = traj::check_moving_exactly(flights[i], obstacle.box, task.rule.parked);
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
    for (traj::MovingConflict& one : looked.conflicts) out.conflicts.push_back(std::move(one));
    for (traj::ProvedMoving& one : looked.proved) out.proved.push_back(std::move(one));
  }
  summary.refused = out.conflicts.size();
  out.claim = claim(flights, task);
  return out;
}

traj::MovingClaim Moving::claim(std::span<const traj::TimedFlight> flights,
                                const traj::TogetherTask& task) const {
  traj::MovingClaim out;
  out.flights = task.ids;
  out.parked = task.rule.parked;
  out.map = task.map;
  out.epoch = task.epoch;
  for (const traj::TimedFlight& flight : flights) out.rooms.push_back(flight.room);
  for (const traj::MovingRecord& obstacle : obstacles_) out.obstacles.push_back(obstacle.id);
  return out;
}

}  // namespace cli
