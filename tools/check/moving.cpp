#include "moving.h"

#include <fmt/format.h>

#include <set>

#include "cli/file/files.h"
#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "geom/record/flight_time.h"

namespace checking {

void Moving::add_to(CLI::App& app) {
  app.add_option("--moving", file_,
                 "obstacles that move, JSON Lines: prove each trajectory clear of each at every "
                 "instant, too")
      ->type_name("FILE");
}

void Moving::read(const geom::BoxMap& map) {
  cli::InputFile file(file_);
  std::set<std::string> ids;
  file.for_each_line([&](const std::string& line, std::size_t number) {
    traj::MovingRecord record = traj::parse_moving_record(line, file.name(), number);
    const auto refuse = [&](const std::string& message) {
      throw geom::InputError(file.name(), number, message);
    };
    if (!ids.insert(record.id).second) {
      refuse(fmt::format("expected each id once, found \"{}\" again", record.id));
    }
    if (!obstacles_.empty()) {
      geom::require_epoch_agrees(record.epoch, obstacles_.front().epoch, file.name(), number);
    }
    const geom::Axes axes = map.spec().frame.axes;
    if (record.frame && *record.frame != axes) {
      refuse(
          fmt::format("expected the map's frame, {}, found {}", name(axes), name(*record.frame)));
    }
    if (record.map && *record.map != map.hash()) {
      refuse(fmt::format("expected an obstacle over this map, {}, found one over {}", map.hash(),
                         *record.map));
    }
    obstacles_.push_back(std::move(record));
  });
}

Moving::Found Moving::check(std::span<const traj::TimedFlight> flights,
                            const traj::TogetherTask& task, std::size_t left_out,
                            const geom::Execution& run) const {
  if (!flights.empty() || left_out > 0) {
    geom::require_epoch_agrees(obstacles_.front().epoch, task.epoch, file_, 0);
  }
  Found out;
  traj::MovingSummary& summary = out.summary;
  summary = {flights.size(), left_out, obstacles_.size(), 0, 0, task.rule.parked, task.epoch};
  struct Looked {
    std::size_t pieces = 0;
    std::vector<traj::MovingConflict> conflicts;
  };
  std::vector<Looked> of(flights.size());
  geom::parallel_for(flights.size(), run, [&](std::size_t i) {
    for (const traj::MovingRecord& obstacle : obstacles_) {
      traj::MovingResult result = traj::check_moving(flights[i], obstacle.box, task.rule.parked);
      of[i].pieces += result.pieces;
      if (!result.clear) of[i].conflicts.push_back({task.ids[i], obstacle.id, result});
    }
  });
  for (Looked& looked : of) {
    summary.pieces += looked.pieces;
    for (traj::MovingConflict& one : looked.conflicts) out.conflicts.push_back(std::move(one));
  }
  summary.refused = out.conflicts.size();
  return out;
}

}  // namespace checking
