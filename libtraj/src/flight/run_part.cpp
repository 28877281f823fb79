#include "traj/flight/run_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/text/parse_json.h"

namespace traj {
namespace {

constexpr std::size_t kColumns = 10;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::array<double, kColumns> row_of(const RunOutcome& outcome) {
  const Tracking& t = outcome.tracking;
  return {t.mean,
          t.rms,
          t.p99,
          t.largest,
          t.largest_time,
          t.arrival,
          t.final_distance,
          t.settling.value_or(kNone),
          outcome.saturated,
          outcome.tilt};
}

RunOutcome outcome_of(std::span<const double> row) {
  RunOutcome out;
  out.tracking = {row[0], row[1], row[2], row[3], row[4], row[5], row[6], std::nullopt};
  if (!std::isnan(row[7])) out.tracking.settling = row[7];
  out.saturated = row[8];
  out.tilt = row[9];
  return out;
}

bool possible(double value) { return value >= 0 && std::isfinite(value); }

}  // namespace

geom::PartArrays arrays_of(std::span<const std::vector<RunOutcome>> outcomes, int runs) {
  struct Columns {
    std::vector<std::uint8_t> lost;
    std::vector<double> tracking;
    std::vector<double> largest;
    std::vector<std::uint64_t> ends;  // of each run's in `largest`
  };
  const auto columns = std::make_shared<Columns>();
  for (const auto& of_trajectory : outcomes) {
    for (const RunOutcome& run : of_trajectory) {
      const auto row = row_of(run);
      columns->lost.push_back(run.lost ? 1 : 0);
      columns->tracking.insert(columns->tracking.end(), row.begin(), row.end());
      columns->largest.insert(columns->largest.end(), run.largest.begin(), run.largest.end());
      columns->ends.push_back(columns->largest.size());
    }
  }
  const nlohmann::json content = {{"trajectories", outcomes.size()}, {"runs", runs}};
  return {content.dump(),
          {geom::named_array<std::uint8_t>("lost", columns->lost),
           geom::named_array<double>("tracking", columns->tracking, kColumns),
           geom::named_array<double>("largest", columns->largest),
           geom::named_array<std::uint64_t>("ends", columns->ends)},
          columns};
}

JoinedRuns::JoinedRuns(std::vector<geom::ShardFile> shards) : shards_(std::move(shards)) {
  const geom::ShardFile& first = shards_.front();
  const nlohmann::json content = geom::parse_json(first.content, first.archive.name());
  const auto count = [&](const char* key) {
    const auto at = content.find(key);
    const bool known = first.kind == "runs" && at != content.end() && at->is_number_unsigned();
    if (!known)
      throw geom::InputError(
          first.archive.name(),
          {.expected = "a shard of --runs", .found = "one of another kind, or a damaged one"});
    return at->get<std::size_t>();
  };
  trajectories_ = count("trajectories");
  runs_ = count("runs");
  if (runs_ == 0)
    throw geom::InputError(first.archive.name(), {.expected = "at least one run", .found = "none"});
  for (const geom::ShardFile& shard : shards_) {
    const std::size_t taken = shard.shard.taken(runs_);
    const std::size_t rows = shard.archive.array<std::uint8_t>("lost").size();
    const bool fits = shard.content == first.content &&
                      (taken ? rows / taken == trajectories_ && rows % taken == 0 : rows == 0) &&
                      shard.archive.array<std::uint64_t>("ends").size() == rows &&
                      shard.archive.array<double>("tracking", kColumns).size() == kColumns * rows;
    if (fits) continue;
    throw geom::InputError(
        shard.archive.name(),
        {.expected = fmt::format("a row for each of its runs and trajectories, {} in all",
                                 taken * trajectories_),
         .found = fmt::to_string(rows),
         .advice = "the file is damaged"});
  }
}

RunOutcome JoinedRuns::outcome(const geom::ShardFile& shard, std::size_t row,
                               std::size_t periods) const {
  const auto refuse = [&] {
    throw geom::InputError(shard.archive.name(),
                           {.says = fmt::format("run {} does not fit the rest", row + 1),
                            .advice = "the file is damaged"});
  };
  const auto lost = shard.archive.array<std::uint8_t>("lost")[row];
  const auto ends = shard.archive.array<std::uint64_t>("ends");
  const auto largest = shard.archive.array<double>("largest");
  const std::uint64_t begin = row ? ends[row - 1] : 0;
  const std::size_t expected = lost ? 0 : periods;
  if (lost > 1 || begin > ends[row] || ends[row] > largest.size() ||
      ends[row] - begin != expected) {
    refuse();
  }
  const auto values =
      shard.archive.array<double>("tracking", kColumns).subspan(kColumns * row, kColumns);
  RunOutcome out = outcome_of(values);
  out.lost = lost == 1;
  const auto errors = largest.subspan(begin, expected);
  out.largest.assign(errors.begin(), errors.end());
  const bool told = std::all_of(values.begin(), values.end() - 3, possible) &&
                    possible(out.tracking.settling.value_or(0)) && out.saturated >= 0 &&
                    out.saturated <= 1 && possible(out.tilt) &&
                    std::all_of(errors.begin(), errors.end(), possible);
  if (!told) refuse();
  return out;
}

std::vector<RunOutcome> JoinedRuns::outcomes(std::size_t trajectory, double duration) const {
  std::vector<RunOutcome> out;
  for (std::size_t run = 0; run < runs_; ++run) {
    const geom::ShardFile& shard = shards_[run % shards_.size()];
    const std::size_t row = trajectory * shard.shard.taken(runs_) + run / shards_.size();
    out.push_back(outcome(shard, row, tube_periods(duration)));
  }
  return out;
}

}  // namespace traj
