// skyway-export: drone files of trajectories and paths, read back and proved as the drone will fly
// them.

#include <fmt/format.h>

#include <map>
#include <span>

#include "cli/run.h"
#include "cli/tell.h"
#include "exporter.h"
#include "flight.h"
#include "geopackage.h"
#include "options.h"
#include "outputs.h"
#include "show.h"

namespace {

using exporting::Exporter;
using exporting::Flight;
using exporting::Options;
using exporting::Outputs;
using traj::WrittenMission;

nlohmann::ordered_json statistics(const Options& options, const Flight& flight,
                                  const WrittenMission& written) {
  nlohmann::ordered_json stats = {{"format", options.word}, {"bytes", written.text.size()}};
  if (!written.memory) return stats;
  stats["segments"] = flight.way.trajectory.segments.size();
  stats["memory"] = written.memory->bytes;
  stats["memory_fits"] = written.memory->fits;
  stats["compressed_memory"] = written.memory->compressed_bytes;
  stats["compressed_fits"] = written.memory->compressed_fits;
  return stats;
}

// Of missions: how long they take, beside the trajectories that they were made of.
class Times {
 public:
  void add(const Flight& flight, const WrittenMission& written) {
    if (written.estimates.empty()) return;
    ++missions_;
    if (flight.way.path.empty()) planned_ += traj::duration(flight.way.trajectory);
    rests_ += written.estimates.front().time.rests;
    waypoints_ += written.estimates.front().time.waypoints;
    for (const traj::MissionEstimate& one : written.estimates) {
      Time& time = times_[one.autopilot];
      time.seconds += one.time.seconds;
      time.at_least = one.at_least;
    }
  }

  // "74 s as planned; as a mission about 152 s (px4:1.11-1.17) to the last waypoint, with rests at
  // 12 of 13 waypoints"; empty without a mission.
  std::string text() const {
    if (missions_ == 0) return "";
    std::string times;
    for (const auto& [autopilot, time] : times_) {
      times += fmt::format("{}{} {:.0f} s ({})", times.empty() ? "" : ", ",
                           time.at_least ? "at least" : "about", time.seconds, autopilot);
    }
    return fmt::format("{}as {} {} to the last waypoint, with rests at {} of {} waypoints",
                       planned_ > 0 ? fmt::format("{:.0f} s as planned; ", planned_) : "",
                       missions_ == 1 ? "a mission" : fmt::format("{} missions", missions_), times,
                       rests_, waypoints_);
  }

  // For --stats: seconds.
  void add_to(nlohmann::ordered_json& stats) const {
    if (missions_ == 0) return;
    if (planned_ > 0) stats["planned_s"] = planned_;
    for (const auto& [autopilot, time] : times_) {
      stats[time.at_least ? "flown_at_least_s" : "flown_s"][autopilot] = time.seconds;
    }
  }

 private:
  struct Time {
    double seconds = 0;
    bool at_least = false;
  };

  std::size_t missions_ = 0;
  double planned_ = 0;  // s
  std::size_t rests_ = 0;
  std::size_t waypoints_ = 0;
  std::map<std::string, Time> times_;  // by autopilot
};

// A file for the one record, or one for each.
cli::Exit export_files(const cli::Common& common, const Options& options, Outputs& outputs,
                       Exporter& exporter, std::span<const Flight> flights) {
  for (const Flight& flight : flights) outputs.add(flight.way.id);
  std::size_t refused = 0;
  nlohmann::ordered_json stats;
  Times times;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    const std::optional<WrittenMission> written = exporter.make(flights[i]);
    if (!written) {
      ++refused;
      if (outputs.each()) exporting::warn_of_stale(common, outputs.stale(i));
      continue;
    }
    outputs.save(i, options.format(), *written);
    times.add(flights[i], *written);
    if (!outputs.each()) stats = statistics(options, flights[i], *written);
  }
  if (outputs.each()) {
    stats = {{"format", options.word}, {"records", flights.size()}, {"refused", refused}};
    if (refused) {
      cli::complain("skyway-export", fmt::format("{} of {} were refused: no file was written for "
                                                 "them",
                                                 refused, flights.size()));
    }
  }
  if (!times.text().empty()) cli::tell(common, "skyway-export", times.text());
  if (stats.is_null()) return refused ? cli::Exit::no : cli::Exit::yes;
  times.add_to(stats);
  if (options.unchecked) stats["unchecked"] = true;
  common.write_stats(stats);
  return refused ? cli::Exit::no : cli::Exit::yes;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Write a trajectory as a drone file, proved as it will be flown.", "skyway-export"};
  cli::Common common(app);
  Options options;
  options.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    options.require_sound(app);
    options.settle();
    Outputs outputs(options);
    const bool all = outputs.each() || !options.show.empty() || options.is_geopackage();
    const auto flights = exporting::read_flights(options.input(), options.id, all);
    Exporter exporter(common, options);
    if (options.is_geopackage()) return export_geopackage(common, options, exporter, flights);
    return options.show.empty() ? export_files(common, options, outputs, exporter, flights)
                                : export_show(common, options, exporter, flights);
  });
}
