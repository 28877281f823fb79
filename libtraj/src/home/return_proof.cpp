#include "traj/home/return_proof.h"

#include <algorithm>
#include <cmath>

#include "geom/base/usage_error.h"
#include "geom/shape/hull.h"
#include "traj/curve/vertical_ends.h"
#include "traj/mission/judge/regions.h"

namespace traj {
namespace {

using geom::Aabb;

constexpr double kLevel = 1;      // m: ground that is as high as home's
constexpr double kAbovePad = 3;   // m in which it counts as low above its pad,
constexpr double kBesidePad = 2;  // and so far beside
constexpr double kHair = 1e-6;    // m, far above rounding
constexpr double kStart = 1e-3;   // m above the ground from which a column is looked at

Vec3 sure(const Vec3& by) { return by * (1 + 1e-12) + Vec3::Constant(1e-9); }

Aabb box_of(const Prism& prism) { return PrismMeeting(prism).bounds(); }

// Why a return from a stage is not clear; equal where the same thing is in the way.
struct Obstruction {
  ReturnPhase phase = ReturnPhase::braking;
  Reason reason = Reason::none;
  Vec3 place = Vec3::Zero();
  std::optional<std::size_t> box = {};
  std::optional<std::size_t> fence = {};
  Prism region = {};  // of what meets the box

  bool is_same(const Obstruction& other) const {
    return phase == other.phase && reason == other.reason && box == other.box &&
           fence == other.fence;
  }
};

// What returns from the first and from the last place of a stage meet, where it was looked at.
struct Ends {
  std::optional<std::optional<Obstruction>> early = {};
  std::optional<std::optional<Obstruction>> late = {};
};

// The boxes near each sweep of a stage. A part of the stage has sweeps within those of the stage,
// so no others can be in its way. Nothing for sweeps that were not looked at.
struct NearBox {
  std::size_t box = 0;
  Aabb grown;  // by what the vehicle is
};
using NearBoxes = std::vector<std::optional<std::vector<NearBox>>>;

bool is_alike(const ReturnGap& a, const ReturnGap& b) {
  return a.phase == b.phase && a.reason == b.reason;
}

// Whether `next` begins within the time of `gap` or at its end.
bool touches(const ReturnGap& gap, const ReturnGap& next) {
  return next.from >= gap.from && next.from <= gap.until;
}

// One model over one map.
class Prover {
 public:
  Prover(const geom::CollisionScene& scene, const ReturnModel& model, const ReturnTask& task,
         bool first_gap_only)
      : scene_(scene), model_(model), task_(task), first_gap_only_(first_gap_only) {
    model_.around += task.room;
    if (!task.fences.empty() && model.rally_limit > 0) model_.fence_excludes = true;
    astray_ = sure(model_.around);
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

  void prove(FlightStage stage, const NearBoxes& of_whole = {}, Ends known = {}) {
    if (done()) return;
    if (!stage.stands_on) stage.stands_on = pad_below(stage);
    NearBoxes near;
    const auto found = obstruction(stage, of_whole, near);
    if (!found) return keep(stage);
    const auto parts = extent(stage) > task_.finest ? halves(stage) : std::nullopt;
    if (!parts) return add_gap(stage, *found);
    if (const auto all_along = met_all_along(stage, near, known)) {
      return add_gap(stage, *all_along);
    }
    const bool in_order = stage.curve.has_value();  // the ends of a hull's half may lie elsewhere
    prove(parts->first, near, in_order ? Ends{known.early, {}} : Ends{});
    prove(parts->second, near, in_order ? Ends{{}, known.late} : Ends{});
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
    for (const std::size_t i : likely_places(model_, stage, places_)) {
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
    ReturnGap gap{stage.from,   stage.until, part_of(stage), model_.autopilot, name(found.phase),
                  found.reason, found.place, found.box,      found.fence};
    if (!gaps.empty() && is_alike(gaps.back(), gap) && touches(gaps.back(), gap)) {
      gaps.back().until = std::max(gaps.back().until, gap.until);
      return;
    }
    if (found.box) gap.place = place_met(found);
    gaps.push_back(std::move(gap));
  }

  // --- places -------------------------------------------------------------------------------

  // The ground of the pad that the stage is low above: it stands there, or it may.
  std::optional<double> pad_below(const FlightStage& stage) const {
    const Aabb box = *geom::bounds(stage.where);
    for (const Vec3& pad : task_.pads) {
      if (box.min.z() < pad.z()) continue;  // beside what the pad is on
      const Vec3 low = (box.min - pad).cwiseAbs().cwiseMax((box.max - pad).cwiseAbs());
      if (low.x() <= kBesidePad && low.y() <= kBesidePad && low.z() <= kAbovePad) return pad.z();
    }
    return std::nullopt;
  }

  bool lands_level(const ReturnPlace& place) const {
    const double height = place.above_ground + model_.height;
    const Vec3 above(place.ground.x(), place.ground.y(),
                     place.ground.z() + std::max(height, scene_.half().z() + kStart));
    const Vec3 beside = astray_ + Vec3(model_.overshoot, model_.overshoot, 0) +
                        Vec3(model_.overshoot_time, model_.overshoot_time, 0) * model_.speed;
    const LandingGround ground = landing_ground(scene_, above, beside, kLevel);
    return ground.whole && std::abs(ground.height - place.ground.z()) <= kLevel;
  }

  // --- one stage ----------------------------------------------------------------------------

  // The first thing that some return from the stage meets, fences last: what is left to them is
  // clear of the map. `of_whole`: the boxes near what the stage is a part of; `near` gets those
  // near the stage.
  std::optional<Obstruction> obstruction(const FlightStage& stage, const NearBoxes& of_whole,
                                         NearBoxes& near) {
    if (const auto met = met_on_map(stage, of_whole, near)) return met;
    if (task_.fences.empty()) return std::nullopt;
    for (const std::vector<ReturnSweep>& sweeps : all_sweeps(stage)) {
      for (const ReturnSweep& one : sweeps) {
        if (const auto left = fence_left(one, stage.part)) return left;
      }
    }
    return std::nullopt;
  }

  std::optional<Obstruction> met_on_map(const FlightStage& stage, const NearBoxes& of_whole,
                                        NearBoxes& near) {
    near.assign(kMostSweeps * places_.size(), std::nullopt);
    const auto met_by = [&](const std::vector<ReturnSweep>& sweeps, std::size_t place) {
      return first_met(stage, sweeps, {of_whole, near, kMostSweeps * place});
    };
    if (!model_.known) return Obstruction{ReturnPhase::landing, Reason::return_home, task_.home};
    if (task_.action == ReturnAction::hold) return met_by(holding_sweeps(model_, stage), 0);
    if (task_.action == ReturnAction::land) {
      const auto sweeps = sweeps_below(stage);
      if (const auto met = met_by(sweeps, 0)) return met;
      return uneven_below(sweeps.front().region);
    }
    for (const std::size_t i : likely_places(model_, stage, places_)) {
      if (const auto met = met_by(return_sweeps(model_, stage, places_[i]), i)) return met;
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

  static constexpr std::size_t kMostSweeps = 8;  // of a return to one place

  struct Lists {
    const NearBoxes& of_whole;
    NearBoxes& near;
    std::size_t first;  // in these
  };

  std::optional<Obstruction> first_met(const FlightStage& stage,
                                       const std::vector<ReturnSweep>& sweeps, const Lists& lists) {
    const double lasts = longest_seconds(model_, sweeps);
    longest = std::max(longest, lasts);
    for (std::size_t i = 0; i < sweeps.size(); ++i) {
      const ReturnSweep& one = sweeps[i];
      const PrismMeeting region(one.region);
      if (const auto out = out_of_bounds(one, region.bounds())) return out;
      const std::size_t list = lists.first + i;
      const bool known = list < lists.of_whole.size() && lists.of_whole[list];
      const bool sinks = one.phase == ReturnPhase::descent;
      const Aabb stands = sinks ? box_of(sweeps.back().region) : *geom::bounds(stage.where);
      lists.near[list] = near_of(one, region, stands,
                                 known ? *lists.of_whole[list] : boxes_near(one.region, region));
      if (const auto met = box_met(one, region, *lists.near[list], stage.from, stage.until + lasts))
        return met;
    }
    return std::nullopt;
  }

  std::optional<Obstruction> out_of_bounds(const ReturnSweep& one, const Aabb& box) const {
    Obstruction out{one.phase, Reason::bounds, box.max};
    if (!free_) return out;
    if ((box.max.array() > free_->max.array()).any()) return out;
    Vec3 low = box.min;
    if (one.stands_on) low.z() = free_->min.z();
    if ((low.array() >= free_->min.array()).all()) return std::nullopt;
    out.place = box.min;
    return out;
  }

  // Those that the region may meet, and a hair more.
  std::vector<NearBox> boxes_near(const Prism& prism, const PrismMeeting& region) const {
    constexpr double kPart = 60;  // m
    const Vec3 size = region.bounds().max - region.bounds().min;
    const double parts = std::ceil(size.head<2>().maxCoeff() / kPart);
    std::vector<std::size_t> found;
    for (const Aabb& part : boxes_around(prism, static_cast<int>(std::clamp(parts, 1.0, 16.0)))) {
      const Vec3 more = extra_ + Vec3::Constant(kHair);
      const auto there = scene_.boxes_meeting({part.min - more, part.max + more});
      found.insert(found.end(), there.begin(), there.end());
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    const Vec3 more = half_ + Vec3::Constant(2 * kHair);
    std::vector<NearBox> out;
    for (const std::size_t i : found) {
      const Aabb box = scene_.map().box(i);
      if (region.with({box.min - more, box.max + more})) out.push_back({i, geom::grow(box, half_)});
    }
    return out;
  }

  // Whether the vehicle stands on the obstacle: it is no higher than the ground and lies below the
  // places `stands`, where the flight is, or where it lands. Other obstacles as low are in the way.
  bool is_stood_on(const ReturnSweep& one, const Aabb& stands, const Aabb& obstacle) const {
    if (!one.stands_on || obstacle.max.z() > *one.stands_on) return false;
    const Vec3 apart = (stands.min - obstacle.max).cwiseMax(obstacle.min - stands.max);
    return apart.x() <= half_.x() + kBesidePad && apart.y() <= half_.y() + kBesidePad;
  }

  // Those that the sweep may meet, and a hair more: its parts may be further out by rounding.
  std::vector<NearBox> near_of(const ReturnSweep& one, const PrismMeeting& region,
                               const Aabb& stands, const std::vector<NearBox>& boxes) const {
    const Vec3 hair = Vec3::Constant(kHair);
    std::vector<NearBox> out;
    for (const NearBox& near : boxes) {
      if (!region.with({near.grown.min - hair, near.grown.max + hair})) continue;
      if (!is_stood_on(one, stands, scene_.map().box(near.box))) out.push_back(near);
    }
    return out;
  }

  std::optional<Obstruction> box_met(const ReturnSweep& one, const PrismMeeting& region,
                                     const std::vector<NearBox>& boxes, double from,
                                     double until) const {
    for (const NearBox& near : boxes) {
      if (!region.with(near.grown) || !is_there(near.box, from, until)) continue;
      return Obstruction{one.phase, Reason::collision, Vec3::Zero(), near.box, {}, one.region};
    }
    return std::nullopt;
  }

  Vec3 place_met(const Obstruction& found) const {
    const Aabb grown = geom::grow(scene_.map().box(*found.box), half_);
    const auto place = geom::hull_meets(corners(found.region), grown);
    return place.value_or(0.5 * (grown.min + grown.max));
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
  // often do too, and it is not worth while to divide the stage. `known` gets what was found.
  std::optional<Obstruction> met_all_along(const FlightStage& stage, const NearBoxes& near,
                                           Ends& known) {
    const auto ends = ends_of(stage);
    if (!ends) return std::nullopt;
    NearBoxes unused;
    if (!known.early) known.early = obstruction(ends->first, near, unused);
    const std::optional<Obstruction>& early = *known.early;
    if (!early) return std::nullopt;
    if (!known.late) known.late = obstruction(ends->second, near, unused);
    return *known.late && early->is_same(**known.late) ? early : std::nullopt;
  }

  const geom::CollisionScene& scene_;
  ReturnModel model_;  // with the room of the task
  const ReturnTask& task_;
  bool first_gap_only_;
  Vec3 astray_;  // what it may be off its way, and wrong about its place
  Vec3 extra_;   // of that, what is beyond the half sizes of the scene
  Vec3 half_;
  std::optional<Aabb> free_;
  std::vector<ReturnPlace> places_;  // home last
  std::vector<bool> grounds_;        // of these, whether it may land there
};

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
  for (const std::vector<FlightStage>& one : stages) {
    if (one.empty())
      throw geom::UsageError("a return needs the stages of a flight: there are none");
  }
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

// The greatest return height that the bounds allow, m above home; below 0: none.
double room_above(const geom::CollisionScene& scene, const ReturnTask& task) {
  if (!scene.free_bounds()) return -1;
  double above = 0.01;  // m below the top that a vehicle needs, and its rally points
  for (const ReturnModel& model : task.models) {
    above = std::max(above, 0.01 + model.around.z() + task.room.z());
  }
  double highest = 0;
  for (const Vec3& rally : task.rally) highest = std::max(highest, rally.z() - task.home.z());
  return scene.free_bounds()->max.z() - task.home.z() - above - highest;
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
    Prover prover(scene, task.models[i], task, false);
    prover.keeps = true;
    for (const FlightStage& stage : stages[i]) prover.prove(stage);
    for (ProvedStage& one : prover.proved) {
      one.model = i;
      out.push_back(std::move(one));
    }
  }
  return out;
}

std::vector<ProvedReturn> proved_returns(const geom::CollisionScene& scene,
                                         std::span<const std::vector<FlightStage>> stages,
                                         const ReturnTask& task) {
  std::vector<ProvedReturn> out;
  for (const ProvedStage& one : proved_stages(scene, stages, task)) {
    const Vec3 beside = return_half(scene, task.models[one.model], task) - scene.half();
    for (const ReturnSweep& sweep : one.sweeps) out.push_back({sweep, one.stage.part, beside});
  }
  return out;
}

std::optional<ReturnHeight> best_return_height(const geom::CollisionScene& scene,
                                               std::span<const std::vector<FlightStage>> stages,
                                               ReturnTask task, double step) {
  if (task.action != ReturnAction::rtl) return std::nullopt;
  constexpr double kNotAll = 1 - 1e-9;  // with a gap of one instant
  const double room = room_above(scene, task);
  const auto share_at = [&](double height, double wanted) {
    for (ReturnModel& model : task.models) model.height = height;
    const ReturnReport proof = prove(scene, stages, task, wanted == 1);
    if (proof.ok()) return 1.0;
    return wanted == 1 ? 0 : std::min(proof.share(), kNotAll);
  };
  double proved = std::floor(room / step);
  if (!(proved >= 0)) return std::nullopt;
  const double wanted = share_at(proved * step, 0);
  double refused = -1;  // not proved there, or not asked
  double share = wanted;
  while (proved - refused > 1) {
    const double middle = std::floor(0.5 * (refused + proved));
    const double there = share_at(middle * step, wanted);
    if (there >= wanted) share = there;
    (there >= wanted ? proved : refused) = middle;
  }
  return ReturnHeight{proved * step, share};
}

}  // namespace traj
