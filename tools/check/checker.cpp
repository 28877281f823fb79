#include "checker.h"

#include <fmt/format.h>

#include <utility>

#include "cli/run.h"
#include "geom/base/in_order.h"
#include "geom/record/start_on_map.h"
#include "geom/text/json_fields.h"
#include "geom/text/record_lines.h"
#include "traj/mission/judge/judge.h"

namespace checking {
namespace {

constexpr std::size_t kHeld = 128;  // records at a time

// Whether its numbers can be judged; else there is nothing to prove of its returns.
bool was_looked_at(const traj::ReportRecord& report) {
  return report.result.ok || report.result.looked;
}

}  // namespace

Checks Checker::solved(const geom::CollisionScene& scene, const traj::TrajectoryRecord& record,
                       const std::string& source, std::size_t line) const {
  Checks out{traj::check_record(scene, record, rules_.record, source, line)};
  if (rules_.returns && was_looked_at(out.report)) {
    traj::ReturnRules returns = *rules_.returns;
    returns.start = geom::start_on(scene.map(), record.time, source, line);
    out.report.returns = traj::check_return(scene, record, *rules_.flier, returns);
  }
  if (rules_.tubes) out.report.tube = rules_.tubes->check(scene, record);
  out.profile = profile_.rows(record.id, scene, record.trajectory, out.report.result.duration);
  return out;
}

Checker::Checked Checker::trajectory(traj::TrajectoryRecord record, const std::string& source,
                                     std::size_t line) const {
  Checked out;
  if (record.status != traj::TrajectoryStatus::solved) {
    out.checks.report = traj::unsolved_report(record);
  } else {
    const auto scene = scenes_.shared_scene_for(record.provenance, source, line);
    rules_.metres.check_input(scene->map().spec().frame, record.trajectory, source, line);
    if (together_.collects()) out.room = traj::room_of(*scene, record);
    try {
      out.checks = solved(*scene, record, source, line);
    } catch (...) {
      out.failure = std::current_exception();
    }
  }
  if (together_.collects()) out.flight = std::move(record);
  return out;
}

Checks Checker::path(const geom::PathRecord& record, const std::string& source,
                     std::size_t line) const {
  if (together_.collects()) together_.refuse_path(record.id, source, line);
  if (rules_.tubes) {
    throw geom::InputError(source, line,
                           {.expected = "a trajectory, which a tube (--tube) is of",
                            .found = "a path, which has no times"});
  }
  if (record.status != geom::PathStatus::found) return {traj::unsolved_report(record)};
  const auto scene = scenes_.shared_scene_for(record.provenance, source, line);
  rules_.metres.check_input(scene->map().spec().frame, record.points, source, line);
  traj::RecordRules rules = rules_.record;
  if (rules_.returns) rules.asked[traj::Limit::speed].reset();  // it is flown with that
  Checks out{traj::check_record(*scene, record, rules, source, line),
             profile_.rows(record.id, *scene, record.points)};
  if (rules_.returns && was_looked_at(out.report)) {
    out.report.returns = traj::check_return(*scene, record, *rules_.flier, *rules_.returns);
  }
  return out;
}

// What a drone makes of a file.
Checks Checker::flown(const traj::FileFlight& file) const {
  if (!scenes_.asked().vehicle && !file.vehicle.empty()) {
    throw cli::UsageError(fmt::format("no vehicle: {} is for an aircraft of DJI: give --vehicle {}",
                                      file.id, file.vehicle));
  }
  const auto& scene = scenes_.scene();
  const traj::FlownLegs* legs = traj::legs_of(file.flown);
  if (!file.format->is_flown) {
    rules_.metres.check_input(scene.map().spec().frame, legs->path, file.id, 0);
  }
  Checks out{traj::check_record(scene, file, *rules_.flier, rules_.record)};
  if (rules_.returns && was_looked_at(out.report)) {
    out.report.returns = traj::check_return(scene, file, *rules_.flier, *rules_.returns);
  }
  if (!legs) {
    out.profile =
        profile_.rows(file.id, scene, traj::trajectory_of(file.flown), out.report.result.duration);
  } else if (const traj::FlownMission* mission = traj::mission_of(file.flown);
             mission && mission->terrain) {
    if (!profile_.file().empty()) {
      throw cli::UsageError(
          "--profile takes ways, and a mission above terrain is a band of heights");
    }
  } else if (const auto way = traj::whole_way(scene, *legs)) {
    out.profile = profile_.rows(file.id, scene, *way);
  }
  return out;
}

Checker::Checked Checker::record(const std::string& text, const std::string& source,
                                 std::size_t line) const {
  const geom::JsonFields fields(text, source, line);
  if (fields.text("type") == "path") {
    return {.checks = path(geom::read_path_record(fields), source, line)};
  }
  return trajectory(traj::read_trajectory_record(fields), source, line);
}

struct Checker::Item {
  geom::RecordLine line;
  Checked checked = {};
  Told told = {};
};

std::size_t Checker::each_record(cli::InputFile& file, const geom::Shard& shard,
                                 Reports& reports) const {
  std::size_t total = 0;
  geom::RecordLines lines(file.stream(), file.name());
  const auto next = [&]() -> std::optional<Item> {
    while (auto line = lines.next()) {
      if (shard.takes(total++)) return Item{*std::move(line)};
    }
    return std::nullopt;
  };
  const auto work = [&](Item& item) {
    item.checked = record(item.line.text, file.name(), item.line.number);
    item.line.text = {};
    if (!item.checked.failure) item.told = reports.told(std::move(item.checked.checks));
  };
  const auto take = [&](Item& item) {
    if (item.checked.flight) {
      together_.add(*std::move(item.checked.flight), item.checked.room, file.name(),
                    item.line.number);
    }
    if (item.checked.failure) std::rethrow_exception(item.checked.failure);
    reports.add(std::move(item.told));
  };
  geom::in_order<Item>(common_.execution("records"), kHeld, next, work, take);
  return total;
}

std::size_t Checker::each_file(const std::string& text, const std::string& source,
                               const cli::DroneFileOptions& drone_file, const geom::Shard& shard,
                               Reports& reports) const {
  std::size_t total = 0;
  const geom::Frame& frame = scenes_.map().spec().frame;
  const auto flights = cli::read_drone_file(text, source, drone_file, frame);
  drone_file.require_used(flights, source);
  for (const traj::FileFlight& one : flights) {
    if (!shard.takes(total++)) continue;
    for (const std::string& note : one.notes) common_.warn(one.id + ": " + note);
    const std::string corners = traj::corner_note(one.flown);
    if (!corners.empty()) common_.warn(one.id + ": " + corners);
    reports.add(reports.told(flown(one)));
  }
  return total;
}

std::size_t Checker::each(cli::InputFile& file, const cli::DroneFileOptions& drone_file,
                          const geom::Shard& shard, Reports& reports) const {
  if (drone_file.format.empty()) return each_record(file, shard, reports);
  return each_file(file.read_all(), file.name(), drone_file, shard, reports);
}

}  // namespace checking
