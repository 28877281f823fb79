#include "traj/home/return_proof.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/base/usage_error.h"
#include "geom/shape/hull.h"
#include "traj/curve/vertical_ends.h"
#include "traj/mission/judge/regions.h"

namespace traj {
namespace {

using geom::Aabb;

constexpr double kLevel = 1;     // m: ground that is as high as home's
constexpr double kNearer = 1;    // m by which a place that is nearest may seem to be further
constexpr double kStart = 1e-3;  // m above the ground from which a column is looked at

Vec3 sure(const Vec3& by) { return by * (1 + 1e-12) + Vec3::Constant(1e-9); }

Aabb box_of(const Prism& prism) {
  Aabb box{{prism.plan.front().x(), prism.plan.front().y(), prism.low},
           {prism.plan.front().x(), prism.plan.front().y(), prism.high}};
  for (const Vec2& p : prism.plan) {
    box = geom::merged(box, {{p.x(), p.y(), prism.low}, {p.x(), p.y(), prism.high}});
  }
  return box;
}

// Why a return from a stage is not clear; equal where the same thing is in the way.
struct Obstruction {
  ReturnPhase phase = ReturnPhase::braking;
  Reason reason = Reason::none;
  Vec3 place = Vec3::Zero();
  std::optional<std::size_t> box = {};
  std::optional<std::size_t> fence = {};

  bool is_same(const Obstruction& other) const {
    return phase == other.phase && reason == other.reason && box == other.box &&
           fence == other.fence;
  }
};

// One model over one map.
class Prover {
 public:
  Prover(const geom::CollisionScene& scene, const ReturnModel& model, const ReturnTask& task,
         bool first_gap_only)
      : scene_(scene), model_(model), task_(task), first_gap_only_(first_gap_only) {
    astray_ = sure(model.around + task.room);
    half_ = return_half(scene, model, task);
    extra_ = half_ - scene.half();
    free_ = geom::shrink(scene.map().spec().bounds, half_);
    for (const Vec3& rally : task.rally) {
      const double ground = task.home.z();
      places_.push_back({{rally.x(), rally.y(), ground}, rally.z() - ground});
    }
    places_.push_back({task.home, 0});
    for (const ReturnPlace& place : places_) grounds_.push_back(lands_level(place));
  }

  void prove(const FlightStage& stage) {
    if (done()) return;
    const auto found = obstruction(stage);
    if (!found) return keep(stage);
    const auto parts = extent(stage) > task_.finest ? halves(stage) : std::nullopt;
    if (!parts) return add_gap(stage, *found);
    if (const auto all_along = met_all_along(stage)) return add_gap(stage, *all_along);
    prove(parts->first);
    prove(parts->second);
  }

  std::vector<ReturnGap> gaps;
  double longest = 0;  // s
  bool keeps = false;  // what it proves:
  std::vector<ProvedStage> proved;

 private:
  void keep(const FlightStage& stage) {
    if (!keeps) return;
    ProvedStage one{0, stage, {}, 0};
    for (std::vector<ReturnSweep>& sweeps : all_sweeps(stage)) {
      one.lasts = std::max(one.lasts, longest_seconds(model_, sweeps));
      one.sweeps.insert(one.sweeps.end(), sweeps.begin(), sweeps.end());
    }
    proved.push_back(std::move(one));
  }

  // To each place where it may land.
  std::vector<std::vector<ReturnSweep>> all_sweeps(const FlightStage& stage) const {
    if (task_.action == ReturnAction::hold) return {holding_sweeps(model_, stage)};
    if (task_.action == ReturnAction::land) return {sweeps_below(stage)};
    std::vector<std::vector<ReturnSweep>> out;
    for (const std::size_t i : nearest_places(braking_region(model_, stage))) {
      out.push_back(return_sweeps(model_, stage, places_[i]));
    }
    return out;
  }

  std::vector<ReturnSweep> sweeps_below(const FlightStage& stage) const {
    const double floor = scene_.map().spec().bounds.min.z();
    return landing_sweeps(model_, stage, task_.home.z(), floor);
  }

  bool done() const { return first_gap_only_ && !gaps.empty(); }

  // A trajectory has no items.
  static std::optional<FlightPart> part_of(const FlightStage& stage) {
    if (stage.curve) return std::nullopt;
    return stage.part;
  }

  void add_gap(const FlightStage& stage, const Obstruction& found) {
    gaps.push_back({stage.from, stage.until, part_of(stage), model_.autopilot, name(found.phase),
                    found.reason, found.place, found.box, found.fence});
  }

  // --- places -------------------------------------------------------------------------------

  bool lands_level(const ReturnPlace& place) const {
    const double height = place.above_ground + model_.height;
    const Vec3 above(place.ground.x(), place.ground.y(),
                     place.ground.z() + std::max(height, scene_.half().z() + kStart));
    const Vec3 beside = astray_ + Vec3(model_.overshoot, model_.overshoot, 0) +
                        Vec3(model_.overshoot_time, model_.overshoot_time, 0) * model_.speed;
    const LandingGround ground = landing_ground(scene_, above, beside, kLevel);
    return ground.whole && std::abs(ground.height - place.ground.z()) <= kLevel;
  }

  // Those that may be the nearest from some place of the region.
  std::vector<std::size_t> nearest_places(const Prism& region) const {
    double sure = std::numeric_limits<double>::infinity();
    for (const ReturnPlace& place : places_) {
      sure = std::min(sure, furthest(region.plan, place.ground.head<2>()));
    }
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const bool home = i + 1 == places_.size();
      const double away = distance(region.plan, places_[i].ground.head<2>());
      if (away <= sure + kNearer || (home && model_.home_always)) out.push_back(i);
    }
    return out;
  }

  // --- one stage ----------------------------------------------------------------------------

  // The first thing that some return from the stage meets.
  std::optional<Obstruction> obstruction(const FlightStage& stage) {
    if (!model_.known) return Obstruction{ReturnPhase::landing, Reason::return_home, task_.home};
    if (task_.action == ReturnAction::hold) return first_met(stage, holding_sweeps(model_, stage));
    if (task_.action == ReturnAction::land) {
      const auto sweeps = sweeps_below(stage);
      if (const auto met = first_met(stage, sweeps)) return met;
      return uneven_below(sweeps.front().region);
    }
    for (const std::size_t i : nearest_places(braking_region(model_, stage))) {
      if (const auto met = first_met(stage, return_sweeps(model_, stage, places_[i]))) return met;
      if (grounds_[i]) continue;
      return Obstruction{ReturnPhase::landing, Reason::landing, places_[i].ground};
    }
    return std::nullopt;
  }

  // Of a landing anywhere in the region: there must be ground as high as home's.
  std::optional<Obstruction> uneven_below(const Prism& region) const {
    const Aabb box = box_of(region);
    const Vec3 middle = 0.5 * (box.min + box.max);
    const Vec3 above(middle.x(), middle.y(), region.high);
    Vec3 beside = 0.5 * (box.max - box.min) + astray_;
    beside.z() = 0;
    const LandingGround ground = landing_ground(scene_, above, beside, kLevel);
    if (ground.whole && std::abs(ground.height - task_.home.z()) <= kLevel) return std::nullopt;
    return Obstruction{ReturnPhase::landing, Reason::landing,
                       Vec3(middle.x(), middle.y(), ground.height)};
  }

  std::optional<Obstruction> first_met(const FlightStage& stage,
                                       const std::vector<ReturnSweep>& sweeps) {
    const double lasts = longest_seconds(model_, sweeps);
    longest = std::max(longest, lasts);
    for (const ReturnSweep& one : sweeps) {
      if (const auto out = out_of_bounds(one)) return out;
      if (const auto met = box_met(one, stage.from, stage.until + lasts)) return met;
      if (const auto left = fence_left(one, stage.part)) return left;
    }
    return std::nullopt;
  }

  std::optional<Obstruction> out_of_bounds(const ReturnSweep& one) const {
    const Aabb box = box_of(one.region);
    Obstruction out{one.phase, Reason::bounds, box.max};
    if (!free_) return out;
    if ((box.max.array() > free_->max.array()).any()) return out;
    Vec3 low = box.min;
    if (one.stands_on) low.z() = free_->min.z();
    if ((low.array() >= free_->min.array()).all()) return std::nullopt;
    out.place = box.min;
    return out;
  }

  std::optional<Obstruction> box_met(const ReturnSweep& one, double from, double until) const {
    Aabb near = box_of(one.region);
    near.min -= extra_;
    near.max += extra_;
    for (const std::size_t i : scene_.boxes_meeting(near)) {
      const Aabb obstacle = scene_.map().box(i);
      if (one.stands_on && obstacle.max.z() <= *one.stands_on) continue;
      const Aabb grown = geom::grow(obstacle, half_);
      if (!meets(one.region, grown) || !is_there(i, from, until)) continue;
      const auto place = geom::hull_meets(corners(one.region), grown);
      return Obstruction{one.phase, Reason::collision, place.value_or(0.5 * (near.min + near.max)),
                         i};
    }
    return std::nullopt;
  }

  // Of a box with a time, between two times of the flight.
  bool is_there(std::size_t box, double from, double until) const {
    if (!task_.start || scene_.map().timed().empty()) return true;
    const geom::TimeSpan span = scene_.map().time(box);
    return span.until >= *task_.start + from && span.from <= *task_.start + until;
  }

  std::optional<Obstruction> fence_left(const ReturnSweep& one, const FlightPart& part) const {
    for (std::size_t i = 0; i < task_.fences.size(); ++i) {
      CheckResult result;
      const Sweep sweep = sweep_of(one, part);
      check_fences(scene_, {&sweep, 1}, {&task_.fences[i], 1}, extra_, result);
      if (result.reason == Reason::none) continue;
      return Obstruction{one.phase, Reason::fence, result.place, {}, i};
    }
    return std::nullopt;
  }

  // What returns from both ends of the stage meet, if that is the same. Then those between most
  // often do too, and it is not worth while to divide the stage.
  std::optional<Obstruction> met_all_along(const FlightStage& stage) {
    const auto ends = ends_of(stage);
    if (!ends) return std::nullopt;
    const auto early = obstruction(ends->first);
    if (!early) return std::nullopt;
    const auto late = obstruction(ends->second);
    return late && early->is_same(*late) ? early : std::nullopt;
  }

  const geom::CollisionScene& scene_;
  const ReturnModel& model_;
  const ReturnTask& task_;
  bool first_gap_only_;
  Vec3 astray_;  // what it may be off its way, and wrong about its place
  Vec3 extra_;   // of that, what is beyond the half sizes of the scene
  Vec3 half_;
  std::optional<Aabb> free_;
  std::vector<ReturnPlace> places_;  // home last
  std::vector<bool> grounds_;        // of these, whether it may land there
};

bool is_alike(const ReturnGap& a, const ReturnGap& b) {
  return a.phase == b.phase && a.reason == b.reason;
}

// Ascending and apart. Those that touch and are alike become one, which keeps what the first met.
std::vector<ReturnGap> joined(std::vector<ReturnGap> gaps) {
  std::stable_sort(gaps.begin(), gaps.end(),
                   [](const ReturnGap& a, const ReturnGap& b) { return a.from < b.from; });
  std::vector<ReturnGap> out;
  for (ReturnGap& gap : gaps) {
    if (!out.empty() && gap.from <= out.back().until) {
      if (is_alike(out.back(), gap)) out.back().until = std::max(out.back().until, gap.until);
      if (gap.until <= out.back().until) continue;
      gap.from = out.back().until;
    }
    out.push_back(std::move(gap));
  }
  return out;
}

void require_task(std::span<const std::vector<FlightStage>> stages, const ReturnTask& task) {
  if (task.models.empty()) throw geom::UsageError("a return needs an autopilot");
  if (stages.size() == task.models.size()) return;
  throw geom::UsageError("a return needs the stages of the flight for each autopilot");
}

ReturnReport prove(const geom::CollisionScene& scene,
                   std::span<const std::vector<FlightStage>> stages, const ReturnTask& task,
                   bool first_gap_only) {
  require_task(stages, task);
  ReturnReport proof{.action = std::string(name(task.action)), .home = task.home};
  proof.height = task.models.front().height;
  std::vector<ReturnGap> gaps;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    Prover prover(scene, task.models[i], task, first_gap_only);
    for (const FlightStage& stage : stages[i]) {
      proof.duration = std::max(proof.duration, stage.until);
      prover.prove(stage);
    }
    proof.autopilot += (i > 0 ? ", " : "") + task.models[i].autopilot;
    proof.height = std::min(proof.height, task.models[i].height);
    proof.longest = std::max(proof.longest, prover.longest);
    gaps.insert(gaps.end(), prover.gaps.begin(), prover.gaps.end());
    if (first_gap_only && !gaps.empty()) break;
  }
  proof.gaps = joined(std::move(gaps));
  return proof;
}

}  // namespace

ReturnReport prove_return(const geom::CollisionScene& scene,
                          std::span<const std::vector<FlightStage>> stages,
                          const ReturnTask& task) {
  return prove(scene, stages, task, false);
}

Vec3 return_half(const geom::CollisionScene& scene, const ReturnModel& model,
                 const ReturnTask& task) {
  const Vec3 margin = scene.half() - scene.vehicle().half;
  return scene.half() + sure((model.around + task.room - margin).cwiseMax(0));
}

std::vector<ProvedStage> proved_stages(const geom::CollisionScene& scene,
                                       std::span<const std::vector<FlightStage>> stages,
                                       const ReturnTask& task) {
  require_task(stages, task);
  std::vector<ProvedStage> out;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    Prover prover(scene, task.models[i], task, true);
    prover.keeps = true;
    for (const FlightStage& stage : stages[i]) prover.prove(stage);
    if (!prover.gaps.empty()) return {};
    for (ProvedStage& one : prover.proved) {
      one.model = i;
      out.push_back(std::move(one));
    }
  }
  return out;
}

std::optional<double> least_return_height(const geom::CollisionScene& scene,
                                          std::span<const std::vector<FlightStage>> stages,
                                          ReturnTask task, double step) {
  const auto proved_at = [&](double height) {
    for (ReturnModel& model : task.models) model.height = height;
    return prove(scene, stages, task, true).gaps.empty();
  };
  if (!scene.free_bounds() || task.action != ReturnAction::rtl) return std::nullopt;
  double above = 0.01;  // m below the bounds' top that a vehicle needs, and its rally points
  for (const ReturnModel& model : task.models) {
    above = std::max(above, 0.01 + model.around.z() + task.room.z());
  }
  double highest = 0;
  for (const Vec3& rally : task.rally) highest = std::max(highest, rally.z() - task.home.z());
  const double room = scene.free_bounds()->max.z() - task.home.z() - above - highest;
  double high = std::floor(room / step);
  if (high < 0 || !proved_at(high * step)) return std::nullopt;
  double low = -1;  // not proved there, or not asked
  while (high - low > 1) {
    const double middle = std::floor(0.5 * (low + high));
    (proved_at(middle * step) ? high : low) = middle;
  }
  return high * step;
}

}  // namespace traj
