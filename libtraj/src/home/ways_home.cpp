#include "traj/home/ways_home.h"

#include <algorithm>
#include <utility>

#include "home/clear_region.h"
#include "home/way_choice.h"
#include "home/way_time.h"

namespace traj {
namespace {

constexpr double kShareSlack = 50;    // m by which a shared way may be longer in any case
constexpr double kMuchShorter = 0.8;  // of a shared way's length: then another one is taken

class Search {
 public:
  Search(const geom::CollisionScene& scene, const WaysTask& task)
      : scene_(scene),
        task_(task),
        choice_(scene, task),
        time_(task.models, scene.vehicle().limits, task.energy) {}

  WaysHome of(std::span<const FlightStage> stages) && {
    if (!stages.empty()) out_.duration = stages.back().until - stages.front().from;
    for (const FlightStage& stage : stages) cover(stage);
    return std::move(out_);
  }

 private:
  void cover(const FlightStage& stage) {
    const Braking from = braking_of(task_.models, stage);
    if (clear_region(scene_, from.region, stage.stands_on) && found(stage, from)) return;
    const auto parts = extent(stage) > task_.finest ? halves(stage) : std::nullopt;
    if (!parts) return add_gap(stage);
    cover(parts->first);
    cover(parts->second);
  }

  // Whether a way was found for the whole stage, the last one or another.
  bool found(const FlightStage& stage, const Braking& from) {
    const bool shares = current_ && choice_.joins(from, current_->points.front());
    const double length = shares ? length_from(from, *current_) : 0;
    const double straight = choice_.straight(from.middle);
    if (shares && length <= task_.detour * straight + kShareSlack) return extend(stage, from);
    auto fresh = choice_.choose(from);
    if (shares && (!fresh || length_from(from, *fresh) > kMuchShorter * length)) {
      return extend(stage, from);
    }
    if (!fresh) return false;
    current_ = std::move(fresh);
    out_.ways.push_back({stage.from, stage.from, current_->site, current_->points});
    return extend(stage, from);
  }

  bool extend(const FlightStage& stage, const Braking& from) {
    WayHome& way = out_.ways.back();
    way.until = stage.until;
    way.length = std::max(way.length, length_from(from, *current_));
    const double duration = time_.at_most(from, current_->points);
    way.duration = std::max(way.duration, duration);
    depart(way, stage, duration);
    return true;
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
      out_.gaps.push_back({stage.from, stage.until, stage.where.front()});
    }
  }

  const geom::CollisionScene& scene_;
  const WaysTask& task_;
  WayChoice choice_;
  WayTime time_;
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
