// skyway-export: drone files of trajectories and paths, read back and proved as the drone will fly
// them.

#include <fmt/format.h>

#include <map>
#include <span>

#include "cli/run.h"
#include "cli/tell.h"
#include "exporter.h"
#include "flight.h"
#include "options.h"
#include "outputs.h"
#include "show.h"
#include "traj/drone_file/crazyflie.h"
#include "writer.h"

namespace {

using exporting::Exporter;
using exporting::Flight;
using exporting::Options;
using exporting::Outputs;
using exporting::Task;
using exporting::Written;

nlohmann::ordered_json statistics(const Task& task, const Written& written) {
  nlohmann::ordered_json stats = {{"format", task.format}, {"bytes", written.text.size()}};
  if (task.format != "crazyflie") return stats;
  const traj::CrazyflieMemory memory = traj::crazyflie_memory(task.enu);
  stats["segments"] = task.enu.segments.size();
  stats["memory"] = memory.bytes;
  stats["memory_fits"] = memory.fits;
  stats["compressed_memory"] = memory.compressed_bytes;
  stats["compressed_fits"] = memory.compressed_fits;
  return stats;
}

// Of missions: how long they take, beside the trajectories that they were made of.
class Times {
 public:
  void add(const Flight& flight, const Written& written) {
    if (written.estimates.empty()) return;
    ++missions_;
    if (flight.path.empty()) planned_ += traj::duration(flight.trajectory);
    rests_ += written.estimates.front().time.rests;
    waypoints_ += written.estimates.front().time.waypoints;
    for (const exporting::Estimate& one : written.estimates) {
      seconds_[one.autopilot] += one.time.seconds;
    }
  }

  // "74 s as planned; as a mission about 152 s (px4:1.11-1.17) to the last waypoint, with rests at
  // 12 of 13 waypoints"; empty without a mission.
  std::string text() const {
    if (missions_ == 0) return "";
    std::string times;
    for (const auto& [autopilot, seconds] : seconds_) {
      times += fmt::format("{}about {:.0f} s ({})", times.empty() ? "" : ", ", seconds, autopilot);
    }
    return fmt::format("{}as {} {} to the last waypoint, with rests at {} of {} waypoints",
                       planned_ > 0 ? fmt::format("{:.0f} s as planned; ", planned_) : "",
                       missions_ == 1 ? "a mission" : fmt::format("{} missions", missions_), times,
                       rests_, waypoints_);
  }

 private:
  std::size_t missions_ = 0;
  double planned_ = 0;  // s
  std::size_t rests_ = 0;
  std::size_t waypoints_ = 0;
  std::map<std::string, double> seconds_;  // by autopilot
};

// A file for the one record, or one for each.
cli::Exit export_files(const cli::Common& common, Outputs& outputs, Exporter& exporter,
                       const std::string& format, std::span<const Flight> flights) {
  for (const Flight& flight : flights) outputs.add(flight.id);
  std::size_t refused = 0;
  nlohmann::ordered_json stats;
  Times times;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    const auto [made, written] = exporter.make(flights[i]);
    if (!written) {
      ++refused;
      if (outputs.each()) exporting::warn_of_stale(common, outputs.stale(i));
      continue;
    }
    outputs.save(i, made.format, *written);
    times.add(flights[i], *written);
    if (!outputs.each()) stats = statistics(made, *written);
  }
  if (outputs.each()) {
    stats = {{"format", format}, {"records", flights.size()}, {"refused", refused}};
    if (refused) {
      cli::complain("skyway-export", fmt::format("{} of {} were refused: no file was written for "
                                                 "them",
                                                 refused, flights.size()));
    }
  }
  if (!times.text().empty()) cli::tell(common, "skyway-export", times.text());
  if (!stats.is_null()) common.write_stats(stats);
  return refused ? cli::Exit::no : cli::Exit::yes;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Write a trajectory as a drone file, proved as it will be flown.", "skyway-export"};
  cli::Common common(app);
  Options options;
  Task task;
  options.add_to(app, task);
  return cli::run_tool(app, argc, argv, [&] {
    options.require_sound(app, task);
    task.autopilot.settle(options.vehicle.profile());
    Outputs outputs(options);
    const bool all = outputs.each() || !options.show.empty();
    const auto flights = exporting::read_flights(options.input(), options.id, all);
    task.ned = options.axes == "ned";
    task.lands = !options.hover;
    task.checked = !options.unchecked;
    Exporter exporter(common, options, task);
    return options.show.empty() ? export_files(common, outputs, exporter, task.format, flights)
                                : export_show(common, options, exporter, flights);
  });
}
