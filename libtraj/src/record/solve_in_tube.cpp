#include "traj/record/solve_in_tube.h"

#include <fmt/format.h>

#include <algorithm>

#include "traj/curve/to_enu.h"
#include "traj/curve/trajectory_hash.h"
#include "traj/flight/tilted_radius.h"
#include "traj/proof/check.h"
#include "traj/record/verdict.h"

namespace traj {
namespace {

// What the next round keeps beyond the tube of this one: that of the next may be a little wider,
// and its chords have a sagitta.
constexpr double kMore = 1.05;
constexpr double kMoreMetres = 5e-4;

class Search {
 public:
  Search(const TubeTask& task, const geom::PathRecord& path, const TubeRooms& rooms,
         const geom::Execution& run)
      : task_(task), given_(path), rooms_(rooms), run_(run) {}

  TubeSolved result() {
    double margin = given_.provenance.margin.value_or(0);
    while (out_.rounds.size() < kMostTubeRounds) {
      const auto next = round(margin);
      if (!next) return std::move(out_);
      margin = *next;
    }
    return refused(fmt::format("no tube was clear after {} rounds ({})", out_.rounds.size(),
                               in_words(out_.rounds)));
  }

 private:
  // Nothing where it is the last; else the margin of the next.
  std::optional<double> round(double margin) {
    TubeRound& now = out_.rounds.emplace_back(TubeRound{.margin = margin});
    const auto scene = rooms_.scene(margin);
    const auto path = path_in(*scene, now);
    if (!path) return end(no_room(margin));
    out_.solved = solve_record(*scene, *path, task_.solve, task_.yaw);
    report(*scene);
    if (out_.solved.record.status != TrajectoryStatus::solved) {
      return end(fmt::format("with a margin of {:.4g} m: {}", margin, out_.solved.record.message));
    }
    const double reach = prove();
    if (out_.report.proved.trouble) return end(in_words(out_.report, nullptr));
    now.largest = out_.report.proved.largest;
    now.clear = out_.report.proved_check->clear;
    if (now.clear) return std::nullopt;
    return kMore * std::max(reach, margin) + kMoreMetres;
  }

  // The path itself while its legs are free, else another. The solver judges it first.
  std::optional<geom::PathRecord> path_in(const geom::CollisionScene& scene, TubeRound& now) const {
    if (out_.rounds.size() == 1) return given_;
    if (check_path(scene, given_.points, {}, Clearance::left_out).ok) return given_;
    now.is_new = true;
    if (!rooms_.path || !given_.hold.empty() || !given_.velocity.empty()) return std::nullopt;
    geom::PathRecord out = rooms_.path(scene);
    if (out.status != geom::PathStatus::found) return std::nullopt;
    out.id = given_.id;
    out.time = given_.time;
    return out;
  }

  std::string no_room(double margin) const {
    const double widest = out_.rounds[out_.rounds.size() - 2].largest;
    return fmt::format(
        "the tube is up to {:.4g} m wide, and no path keeps {:.4g} m from everything; fly slower "
        "(--vmax), allow less wind or gusts, or find other gains",
        widest, margin);
  }

  void report(const geom::CollisionScene& scene) {
    const TrajectoryRecord& record = out_.solved.record;
    out_.report = {.id = record.id, .status = record.status};
    out_.report.options = task_.flight;
    out_.report.provenance = geom::provenance_of(scene);
    out_.report.time = record.time;
  }

  // The tube of the trajectory of this round; the largest radius, m, with what its tilt adds.
  double prove() {
    const TrajectoryRecord& record = out_.solved.record;
    FlightReport& report = out_.report;
    const auto scene = rooms_.scene(0);
    const ReferenceTrack track(to_enu(scene->map().spec().frame.axes, record.trajectory));
    report.duration = track.duration();
    report.trajectory = trajectory_hash(record.trajectory);
    report.disturbances = task_.disturbances;
    report.proved = prove_tube(track, task_.flight, task_.disturbances, run_);
    if (report.proved.trouble) return 0;
    const std::vector<double> radius = tilted_radius(report.proved.radius, report.proved.tilt,
                                                     scene->vehicle(), task_.profile.body);
    report.proved_check = check_tube(*scene, record.trajectory, radius, kTubePeriod);
    return *std::max_element(radius.begin(), radius.end());
  }

  std::nullopt_t end(std::string why) {
    refuse(std::move(why));
    return std::nullopt;
  }

  TubeSolved refused(std::string why) {
    refuse(std::move(why));
    return std::move(out_);
  }

  // No trajectory stays that somebody might fly.
  void refuse(std::string why) {
    TrajectoryRecord& record = out_.solved.record;
    if (record.id.empty()) {
      record = {.id = given_.id, .limits = task_.solve.limits, .time = given_.time};
      record.provenance = given_.provenance;
      out_.report = {.id = given_.id};
    }
    record.status = TrajectoryStatus::infeasible;
    record.trajectory = {};
    record.rung.reset();
    record.solver.clear();
    record.bound.reset();
    record.duration_bound.reset();
    record.message = why;
    if (!out_.report.disturbances) out_.report.status = TrajectoryStatus::infeasible;
    out_.solved.corridor = {};
    out_.why = std::move(why);
  }

  const TubeTask& task_;
  const geom::PathRecord& given_;
  const TubeRooms& rooms_;
  const geom::Execution& run_;
  TubeSolved out_;
};

}  // namespace

TubeSolved solve_in_tube(const TubeTask& task, const geom::PathRecord& path, const TubeRooms& rooms,
                         const geom::Execution& run) {
  if (path.status == geom::PathStatus::found) return Search(task, path, rooms, run).result();
  TubeSolved out;
  out.solved.record = without_path(path, task.solve.limits);
  out.report = {.id = path.id, .status = TrajectoryStatus::no_path};
  out.why = in_words(out.solved.record);
  return out;
}

std::string in_words(const std::vector<TubeRound>& rounds) {
  std::string out;
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    const TubeRound& one = rounds[i];
    out += fmt::format("{}round {}: {:.4g} m kept{}, {}", i == 0 ? "" : "; ", i + 1, one.margin,
                       one.is_new ? " along another path" : "",
                       one.largest == 0 ? "no tube"
                                        : fmt::format("tube {:.4g} m, {}", one.largest,
                                                      one.clear ? "clear" : "touches"));
  }
  return out;
}

}  // namespace traj
