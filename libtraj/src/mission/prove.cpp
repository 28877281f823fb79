#include "prove.h"

#include <utility>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"
#include "traj/curve/to_enu.h"
#include "traj/mission/formats/fence_file.h"
#include "traj/mission/judge/judge.h"
#include "traj/mission/read_mission.h"
#include "traj/mission/straight_legs.h"

namespace traj {
namespace {

constexpr int kAttempts = 10;  // of tolerances, halved each time

// The flight keeps to fences in a file of their own, too.
void add_fences(const WrittenMission& written, const Placement& placement, const geom::Frame& frame,
                Flown& flown) {
  auto* mission = std::get_if<FlownMission>(&flown.way);
  if (written.fences.empty() || !mission) return;
  geom::TextInput in(written.fences);
  const geom::GeodeticOrigin origin = placement.mission_frame(frame).origin;
  for (const GeodeticFence& one : read_fences(in, "the fences that were written")) {
    Fence fence = fence_on_map(one, origin, "the fences that were written");
    for (geom::Vec2& p : fence.ring) {
      p = geom::to_enu(frame.axes, Vec3(p.x(), p.y(), 0)).head<2>();
    }
    mission->fences.push_back(std::move(fence));
  }
}

// What the bytes make the drone fly, judged.
CheckResult judge_written(const geom::CollisionScene& scene, const MissionTask& task,
                          const WrittenMission& written) {
  Flown flown = read_again(task, written);
  add_fences(written, written.reading.placement, task.frame, flown);
  CheckResult result = judge(scene, flown, task.limits, Clearance::left_out);
  const double missed = missed_end(task, flown);
  if (!result.ok || missed <= kEndGap) return result;
  const FlownLegs* legs = legs_of(flown);
  result.ok = false;
  result.reason = Reason::end;
  result.time = static_cast<double>(legs->path.size() - 1);
  result.place = legs->path.back();
  result.worst = missed;
  return result;
}

geom::Polyline pushed_legs(const geom::CollisionScene& scene, const MissionTask& task,
                           const geom::Polyline& legs, double distance) {
  return to_enu(task.frame.axes, pushed_off(scene, to_enu(task.frame.axes, legs), distance));
}

// Writes the legs and judges what was written, until it is accepted or the format knows no more.
MissionProof write_and_judge(const geom::CollisionScene& scene, MissionTask task,
                             const geom::Polyline& legs) {
  const MissionFormat& format = *task.format;
  if (format.prepare) format.prepare(task, legs);
  while (true) {
    WrittenMission written = format.write(task, legs);
    const CheckResult result = judge_written(scene, task, written);
    if (result.ok || !format.mend || !format.mend(written, result, task)) {
      return {std::move(written), result};
    }
  }
}

// Whether other legs would not help.
bool is_settled(Reason reason) {
  return reason != Reason::collision && reason != Reason::bounds && reason != Reason::end;
}

}  // namespace

Flown read_again(const MissionTask& task, const WrittenMission& written) {
  constexpr const char* kWritten = "what was written";
  MissionReading reading = written.reading;
  reading.flier = task.options.flier;
  auto read = read_mission(written.text, kWritten, *task.format, reading, task.frame);
  if (read.size() != 1) throw geom::InputError(kWritten, {.expected = "one flight"});
  return std::move(read.front().flown);
}

double missed_end(const MissionTask& task, const Flown& flown) {
  const FlownLegs* legs = legs_of(flown);
  if (!legs) return 0;
  const Vec3 end = geom::to_enu(task.frame.axes, task.enu.segments.back().point[kDegree]);
  return (legs->path.back() - end).norm();
}

MissionProof write_proved(const geom::CollisionScene& scene, const MissionTask& task) {
  const MissionFormat& format = *task.format;
  if (format.prove) return format.prove(scene, task);
  if (!format.has_legs) return write_and_judge(scene, task, {});
  MissionProof made;
  const auto attempt = [&](const geom::Polyline& legs) {
    made = write_and_judge(scene, task, legs);
    return is_settled(made.result.reason);
  };
  if (!task.path.empty()) {
    if (attempt(task.path)) return made;
    for (double off = format.rounding; off <= task.options.tolerance; off *= 2) {
      if (attempt(pushed_legs(scene, task, task.path, off))) break;
    }
    return made;
  }
  double tolerance = task.options.tolerance;
  for (int i = 0; i < kAttempts; ++i, tolerance /= 2) {
    const geom::Polyline legs = straight_legs(task.enu, tolerance);
    if (attempt(legs)) break;
    if (attempt(pushed_legs(scene, task, legs, tolerance + format.rounding))) break;
  }
  return made;
}

}  // namespace traj
