#include "traj/home/ways_home.h"

#include <algorithm>
#include <utility>

#include "home/clear_hull.h"
#include "home/way_choice.h"
#include "home/way_time.h"
#include "traj/home/prism.h"
#include "traj/home/return_sweeps.h"

namespace traj {
namespace {

constexpr double kShareSlack = 50;    // m by which a shared way may be longer in any case
constexpr double kMuchShorter = 0.8;  // of a shared way's length: then another one is taken

double fastest(const FlightStage& stage) {
  double most = 0;
  for (const Vec3& v : stage.velocity) most = std::max(most, v.norm());
  return most;
}

// A stage and where the vehicle is until it rests.
struct Braked {
  const FlightStage& stage;
  std::vector<Vec3> hull;
};

class Search {
 public:
  Search(const geom::CollisionScene& scene, const WaysTask& task)
      : scene_(scene), task_(task), choice_(scene, task) {
    for (const ReturnModel& model : task.models) {
      speeds_.push_back(way_speeds(model, scene.vehicle().limits, task.energy));
    }
  }

  WaysHome of(std::span<const FlightStage> stages) && {
    if (!stages.empty()) out_.duration = stages.back().until - stages.front().from;
    for (const FlightStage& stage : stages) cover(stage);
    return std::move(out_);
  }

 private:
  void cover(const FlightStage& stage) {
    const Braked braked{stage, hull_of(stage)};
    if (clear_hull(scene_, braked.hull, stage.stands_on) && found(braked)) return;
    const auto parts = extent(stage) > task_.finest ? halves(stage) : std::nullopt;
    if (!parts) return add_gap(stage);
    cover(parts->first);
    cover(parts->second);
  }

  std::vector<Vec3> hull_of(const FlightStage& stage) const {
    std::vector<Vec3> out;
    for (const ReturnModel& model : task_.models) {
      const std::vector<Vec3> region = corners(braking_region(model, stage));
      out.insert(out.end(), region.begin(), region.end());
    }
    return corners(prism_around(out));
  }

  // Whether a way was found for the whole stage, the last one or another.
  bool found(const Braked& braked) {
    const bool shares = current_ && clear_join(scene_, braked.hull, current_->points.front(),
                                               braked.stage.stands_on);
    const double length = shares ? length_from(braked.hull, *current_) : 0;
    const double straight = choice_.straight(mean(braked.hull));
    if (shares && length <= task_.detour * straight + kShareSlack) return extend(braked);
    auto fresh = choice_.choose(braked.hull);
    if (shares && (!fresh || length_from(braked.hull, *fresh) > kMuchShorter * length)) {
      return extend(braked);
    }
    if (!fresh) return false;
    current_ = std::move(fresh);
    out_.ways.push_back({braked.stage.from, braked.stage.from, current_->site, current_->points});
    return extend(braked);
  }

  bool extend(const Braked& braked) {
    WayHome& way = out_.ways.back();
    way.until = braked.stage.until;
    way.length = std::max(way.length, length_from(braked.hull, *current_));
    const double duration = duration_of(braked);
    way.duration = std::max(way.duration, duration);
    depart(way, braked.stage, duration);
    return true;
  }

  // At most, by any of the models.
  double duration_of(const Braked& braked) const {
    double most = 0;
    for (std::size_t i = 0; i < task_.models.size(); ++i) {
      const ReturnModel& model = task_.models[i];
      const geom::Polyline& points = current_->points;
      double join = 0;
      for (const Vec3& p : braked.hull) {
        join = std::max(join, leg_time(model, speeds_[i], p, points.front()));
      }
      double along = landing_time(points[points.size() - 2].z() - points.back().z());
      for (std::size_t leg = 1; leg + 1 < points.size(); ++leg) {
        along += leg_time(model, speeds_[i], points[leg - 1], points[leg]);
      }
      most = std::max(most, braking_time(model, fastest(braked.stage)) + join + along);
    }
    return most;
  }

  // Moves the latest departure on, unless it ended before.
  void depart(WayHome& way, const FlightStage& stage, double duration) const {
    if (!task_.energy) return;
    const bool first = stage.from == way.from;
    if (!first && way.latest_departure != stage.from) return;
    const double latest = flying_time(*task_.energy) - duration;
    if (latest >= stage.from) way.latest_departure = std::min(latest, stage.until);
  }

  void add_gap(const FlightStage& stage) {
    current_.reset();
    if (!out_.gaps.empty() && out_.gaps.back().until == stage.from) {
      out_.gaps.back().until = stage.until;
    } else {
      out_.gaps.push_back({stage.from, stage.until, mean(stage.where)});
    }
  }

  const geom::CollisionScene& scene_;
  const WaysTask& task_;
  WayChoice choice_;
  std::vector<WaySpeeds> speeds_;     // of the models
  std::optional<ChosenWay> current_;  // that of the last in out_.ways
  WaysHome out_;
};

}  // namespace

double share(const WaysHome& home) {
  if (!(home.duration > 0)) return home.gaps.empty() ? 1 : 0;
  double without = 0;
  for (const WayGap& gap : home.gaps) without += gap.until - gap.from;
  return std::max(0.0, 1 - without / home.duration);
}

bool complete(const WaysHome& home, const WaysTask& task) {
  const auto reaches = [&](const WayHome& way) {
    return !task.energy || way.latest_departure == way.until;
  };
  return home.gaps.empty() && std::all_of(home.ways.begin(), home.ways.end(), reaches);
}

WaysHome ways_home(const geom::CollisionScene& scene, std::span<const FlightStage> stages,
                   const WaysTask& task) {
  return Search(scene, task).of(stages);
}

}  // namespace traj
