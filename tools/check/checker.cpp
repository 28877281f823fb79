#include "checker.h"

#include "cli/run.h"
#include "geom/text/json_fields.h"
#include "traj/mission/judge/judge.h"

namespace checking {

traj::ReportRecord Checker::trajectory(const traj::TrajectoryRecord& record,
                                       const std::string& source, std::size_t line) const {
  if (record.status != traj::TrajectoryStatus::solved) {
    together_.add(record, nullptr, source, line);
    return traj::unsolved_report(record);
  }
  const auto& scene = scenes_.scene_for(record.provenance, source, line);
  rules_.metres.check_input(scene.map().spec().frame, record.trajectory, source, line);
  together_.add(record, &scene, source, line);
  const auto report = traj::check_record(scene, record, rules_.record, source, line);
  profile_.add(record.id, scene, record.trajectory, report.result.duration);
  return report;
}

traj::ReportRecord Checker::path(const geom::PathRecord& record, const std::string& source,
                                 std::size_t line) const {
  if (together_.collects()) together_.refuse_path(record.id, source, line);
  if (record.status != geom::PathStatus::found) return traj::unsolved_report(record);
  const auto& scene = scenes_.scene_for(record.provenance, source, line);
  rules_.metres.check_input(scene.map().spec().frame, record.points, source, line);
  const auto report = traj::check_record(scene, record, rules_.record, source, line);
  profile_.add(record.id, scene, record.points);
  return report;
}

// What a drone makes of a file.
traj::ReportRecord Checker::flown(const traj::FileFlight& file) const {
  const auto& scene = scenes_.scene();
  const traj::FlownLegs* legs = traj::legs_of(file.flown);
  if (!file.format->is_flown) {
    rules_.metres.check_input(scene.map().spec().frame, legs->path, file.id, 0);
  }
  const auto report = traj::check_record(scene, file, *rules_.flier, rules_.record);
  if (!legs) {
    profile_.add(file.id, scene, traj::trajectory_of(file.flown), report.result.duration);
  } else if (const auto way = traj::whole_way(scene, *legs)) {
    profile_.add(file.id, scene, *way);
  }
  return report;
}

traj::ReportRecord Checker::record(const std::string& text, const std::string& source,
                                   std::size_t line) const {
  const geom::JsonFields fields(text, source, line);
  return fields.text("type") == "path"
             ? path(geom::read_path_record(fields), source, line)
             : trajectory(traj::read_trajectory_record(fields), source, line);
}

std::size_t Checker::each(cli::InputFile& file, const cli::DroneFileOptions& drone_file,
                          const geom::Shard& shard, const Answer& answer) const {
  std::size_t total = 0;
  if (drone_file.format.empty()) {
    file.for_each_line([&](const std::string& line, std::size_t number) {
      if (shard.takes(total++)) answer(record(line, file.name(), number));
    });
    return total;
  }
  const geom::Frame& frame = scenes_.map().spec().frame;
  const std::string text = file.read_all();
  for (const auto& one : cli::read_drone_file(text, file.name(), drone_file, frame)) {
    if (!shard.takes(total++)) continue;
    for (const std::string& note : one.notes) common_.warn(one.id + ": " + note);
    const std::string corners = traj::corner_note(one.flown);
    if (!corners.empty()) common_.warn(one.id + ": " + corners);
    answer(flown(one));
  }
  return total;
}

}  // namespace checking
