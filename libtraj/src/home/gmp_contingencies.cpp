#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "geom/record/flight_time.h"
#include "gmp_solid.h"
#include "traj/home/contingency_proof.h"
#include "traj/proof/domain.h"

namespace traj {
namespace {

using exact::RoughSolid;
using exact::Solid;
using exact::Whole;
using exact::WholeBox;
using Rational = mpq_class;
using Place = std::array<Rational, 3>;

constexpr double kHair = 5e-10;        // m: rounding may put a place so far beside its region
constexpr double kSameInstant = 1e-9;  // s
constexpr double kRounding = 1e-6;     // m, and its square of coordinates: more than these round

Place rational(const Vec3& p) { return {Rational(p.x()), Rational(p.y()), Rational(p.z())}; }

// --- the flight in its regions --------------------------------------------------------------

Place between(const Place& a, const Place& b, const Rational& share) {
  Place out;
  for (std::size_t i = 0; i < 3; ++i) out[i] = a[i] + share * (b[i] - a[i]);
  return out;
}

// The control points of the part of a curve up to a share of it, or from there on.
std::vector<Place> cut(std::vector<Place> points, const Rational& share, bool before) {
  std::vector<Place> out;
  while (!points.empty()) {
    out.push_back(before ? points.front() : points.back());
    for (std::size_t i = 1; i < points.size(); ++i) {
      points[i - 1] = between(points[i - 1], points[i], share);
    }
    points.pop_back();
  }
  if (!before) std::reverse(out.begin(), out.end());
  return out;
}

// Control points of a stage between two times of the flight that it shares.
std::vector<Place> part_of(const FlightStage& stage, double from, double until) {
  std::vector<Place> points;
  if (!stage.curve) {
    for (const Vec3& p : stage.where) points.push_back(rational(p));
    return points;
  }
  for (const Vec3& p : stage.curve->point) points.push_back(rational(p));
  const Rational lasts(stage.curve->duration);
  const Rational begin = (Rational(from) - Rational(stage.from)) / lasts;
  Rational end = (Rational(until) - Rational(stage.from)) / lasts;
  if (end > 1) end = 1;
  points = cut(std::move(points), end, true);
  return begin > 0 && end > 0 ? cut(std::move(points), begin / end, false) : points;
}

bool holds(const Prism& prism, const Place& place) {
  const Rational hair(kHair);
  if (place[2] + hair < prism.low || place[2] - hair > prism.high) return false;
  const auto within = [&](const Rational& x, const Rational& y) {
    const Rational at = x * place[0] + y * place[1];
    const Rational reach = hair * (abs(x) + abs(y));
    Rational least;
    Rational most;
    for (std::size_t i = 0; i < prism.plan.size(); ++i) {
      const Rational corner = x * Rational(prism.plan[i].x()) + y * Rational(prism.plan[i].y());
      if (i == 0 || corner < least) least = corner;
      if (i == 0 || corner > most) most = corner;
    }
    return at + reach >= least && at - reach <= most;
  };
  if (!within(1, 0) || !within(0, 1)) return false;
  for (std::size_t i = 0; i < prism.plan.size(); ++i) {
    const Vec2& a = prism.plan[i];
    const Vec2& b = prism.plan[(i + 1) % prism.plan.size()];
    if (!within(Rational(b.y()) - Rational(a.y()), Rational(a.x()) - Rational(b.x()))) return false;
  }
  return true;
}

// --- what is in the way ---------------------------------------------------------------------

struct Obstacle {
  std::size_t index = 0;
  geom::Aabb rough;  // holds it, as it is grown
  double top = 0;
};

// A prism, or its convex hull with a point.
struct Region {
  const Prism& prism;
  std::optional<Vec3> to = {};
};

struct Refusal {
  Reason reason = Reason::none;
  double time = 0;
  Vec3 place = Vec3::Zero();
  std::optional<std::size_t> box = {};
};
using Refused = std::optional<Refusal>;

class Ways {
 public:
  Ways(const ExactTask& task, std::span<const FlightStage> stages, std::span<const ProvedWay> ways)
      : task_(task), stages_(stages) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Whole half = exact::whole(task.vehicle.half[static_cast<int>(i)]);
      half_[i] = half + exact::whole(task.margin);
    }
    const geom::Aabb& bounds = task.map.spec().bounds;
    free_ = {exact::whole(bounds.min), exact::whole(bounds.max)};
    for (std::size_t i = 0; i < 3; ++i) {
      free_.low[i] += half_[i];
      free_.high[i] -= half_[i];
    }
    gather(ways);
  }

  Refused refusal(const ProvedWay& way) const {
    const geom::Polyline& points = way.record.points;
    const double from = way.record.from;
    if (points.size() < 2 || way.beyond.size() + 2 != points.size()) {
      return Refusal{Reason::return_home, from};
    }
    for (std::size_t i = 0; i + 2 < points.size(); ++i) {
      const Prism end = prism_around(std::span(&points[i], 1));
      if (auto met = meets({end, points[i + 1]}, from, points[i])) return met;
      if (auto met = meets({way.beyond[i]}, from, points[i + 1])) return met;
    }
    if (auto met = landing(way)) return met;
    for (const ProvedJoin& join : way.joins) {
      if (auto met = join_refused(join, points.front())) return met;
    }
    return std::nullopt;
  }

 private:
  // Boxes that may be near to any of the ways.
  void gather(std::span<const ProvedWay> ways) {
    std::vector<Vec3> places;
    for (const ProvedWay& way : ways) {
      places.insert(places.end(), way.record.points.begin(), way.record.points.end());
      const auto add = [&](const Prism& one) {
        for (const Vec3& corner : corners(one)) places.push_back(corner);
      };
      std::for_each(way.beyond.begin(), way.beyond.end(), add);
      for (const ProvedJoin& join : way.joins) {
        add(join.braking);
        add(join.beyond);
      }
    }
    const auto all = geom::bounds(places);
    if (!all) return;
    for (std::size_t i = 0; i < task_.map.size(); ++i) {
      const geom::Aabb box = task_.map.box(i);
      const Vec3 room = rough_room(box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()));
      const geom::Aabb rough{box.min - room, box.max + room};
      if (geom::overlap(rough, *all)) near_.push_back({i, rough, box.max.z()});
    }
  }

  WholeBox grown(const Obstacle& one) const {
    const geom::Aabb box = task_.map.box(one.index);
    WholeBox out{exact::whole(box.min), exact::whole(box.max)};
    for (std::size_t k = 0; k < 3; ++k) {
      out.low[k] -= half_[k];
      out.high[k] += half_[k];
    }
    return out;
  }

  Refused meets(const Region& region, double time, const Vec3& place,
                const std::optional<double>& stands_on = {}) const {
    const RoughSolid rough(region.prism, region.to);
    std::optional<Solid> solid;
    const auto exactly = [&]() -> const Solid& {
      return solid ? *solid : solid.emplace(region.prism, region.to);
    };
    WholeBox room = free_;
    if (stands_on) room.low[2] = exact::whole(-geom::kFarthest);
    if (!surely_inside(rough.around()) && !exactly().within(room)) {
      return Refusal{Reason::bounds, time, place};
    }
    for (const Obstacle& one : near_) {
      if (stands_on && one.top <= *stands_on) continue;
      if (rough.surely_apart(one.rough)) continue;
      if (!exactly().apart(grown(one))) return Refusal{Reason::collision, time, place, one.index};
    }
    return std::nullopt;
  }

  bool surely_inside(const geom::Aabb& box) const {
    const geom::Aabb& bounds = task_.map.spec().bounds;
    const Vec3 far = bounds.min.cwiseAbs().cwiseMax(bounds.max.cwiseAbs());
    const Vec3 room = rough_room(far);
    return ((box.min - bounds.min - room).array() > 0).all() &&
           ((bounds.max - box.max - room).array() > 0).all();
  }

  // The vehicle with its margin, and more than what it is rounded by at coordinates up to `far`.
  Vec3 rough_room(const Vec3& far) const {
    return task_.vehicle.half + Vec3::Constant(task_.margin + kRounding) +
           kRounding * kRounding * far;
  }

  // Straight down, past everything higher than the ground, and something or the floor is there.
  Refused landing(const ProvedWay& way) const {
    const Vec3& above = way.record.points[way.record.points.size() - 2];
    const Vec3& ground = way.record.points.back();
    const Refusal none{Reason::landing, way.record.from, ground};
    if (above.head<2>() != ground.head<2>() || !(above.z() > ground.z())) return none;
    const Prism column{{ground.head<2>()}, ground.z(), above.z()};
    if (auto met = meets({column}, way.record.from, ground, ground.z())) {
      return Refusal{Reason::landing, way.record.from, ground, met->box};
    }
    if (ground.z() == task_.map.spec().bounds.min.z()) return std::nullopt;
    const Solid foot(Prism{{ground.head<2>()}, ground.z(), ground.z()});
    const bool stands = std::any_of(near_.begin(), near_.end(), [&](const Obstacle& one) {
      return one.top == ground.z() && !foot.apart(grown(one));
    });
    return stands ? std::nullopt : Refused(none);
  }

  Refused join_refused(const ProvedJoin& join, const Vec3& first) const {
    const Vec3 place = join.where.empty() ? first : join.where.front();
    if (auto met = meets({join.braking}, join.from, place)) return met;
    if (auto met = meets({join.braking, first}, join.from, place)) return met;
    if (!holds(join.beyond, rational(first))) return Refusal{Reason::return_home, join.from, first};
    if (auto met = meets({join.beyond}, join.from, first)) return met;
    for (const FlightStage& stage : stages_) {
      const double from = std::max(stage.from, join.from);
      const double until = std::min(stage.until, join.until);
      const bool touches = from == until && stage.from < stage.until && join.from < join.until;
      if (from > until || touches) continue;
      for (const Place& p : part_of(stage, from, until)) {
        if (!holds(join.braking, p)) return Refusal{Reason::return_home, from, place};
      }
    }
    return std::nullopt;
  }

  const ExactTask& task_;
  std::span<const FlightStage> stages_;
  std::array<Whole, 3> half_;
  WholeBox free_;
  std::vector<Obstacle> near_;
};

// The first time of the flight that no way home covers.
Refused left_out(std::span<const FlightStage> stages, std::span<const ProvedWay> ways) {
  std::vector<std::pair<double, double>> times;
  for (const ProvedWay& way : ways) {
    for (const ProvedJoin& join : way.joins) times.emplace_back(join.from, join.until);
  }
  std::sort(times.begin(), times.end());
  double reached = stages.front().from;
  for (const auto& [from, until] : times) {
    if (from > reached) break;
    reached = std::max(reached, until);
  }
  if (!times.empty() && reached >= stages.back().until - kSameInstant) return std::nullopt;
  return Refusal{Reason::return_home, reached, stages.front().where.front()};
}

void require_prism(const Prism& prism) {
  for (const Vec3& corner : corners(prism)) geom::require_point("a region", corner);
}

void require_times(const char* what, double from, double until) {
  if (from <= until && std::abs(from) <= geom::kLargestTime &&
      std::abs(until) <= geom::kLargestTime) {
    return;
  }
  throw geom::InputError(
      what, {.expected = fmt::format("times that grow, within {:g} s", geom::kLargestTime),
             .found = fmt::format("{} to {}", from, until)});
}

void require_numbers(const FlightStage& stage) {
  require_times("a stage", stage.from, stage.until);
  for (const Vec3& p : stage.where) geom::require_point("a stage", p);
  if (!stage.curve) return;
  if (const auto outside = outside_domain(Trajectory{{*stage.curve}}, {})) {
    throw geom::InputError("a stage", {.key = std::string(name(outside->reason)),
                                       .expected = "a number that a check can judge",
                                       .found = fmt::to_string(outside->value)});
  }
}

void require_numbers(const ProvedWay& way) {
  for (const Vec3& p : way.record.points) geom::require_point("a way home", p);
  for (const Prism& prism : way.beyond) require_prism(prism);
  for (const ProvedJoin& join : way.joins) {
    require_times("a join of a way home", join.from, join.until);
    for (const Vec3& p : join.where) geom::require_point("a join of a way home", p);
    require_prism(join.braking);
    require_prism(join.beyond);
  }
}

// A comparison with what is not a number would keep ways clear, and their times covered.
void require_numbers(const ExactTask& task, std::span<const FlightStage> stages,
                     std::span<const ProvedWay> ways) {
  for (const double half : task.vehicle.half) {
    geom::require_length("half of the vehicle", half, geom::kLargestCoordinate);
  }
  geom::require_length("margin", task.margin, geom::kLargestCoordinate);
  for (const FlightStage& stage : stages) require_numbers(stage);
  for (const ProvedWay& way : ways) require_numbers(way);
}

}  // namespace

ExactResult check_exactly(const ExactTask& task, std::span<const FlightStage> stages,
                          std::span<const ProvedWay> ways) {
  ExactResult out;
  Refused refused;
  if (stages.empty()) {
    out.reason = Reason::no_path;
    return out;
  }
  require_numbers(task, stages, ways);
  const Ways exact(task, stages, ways);
  for (const ProvedWay& way : ways) {
    if (!refused) refused = exact.refusal(way);
  }
  if (!refused) refused = left_out(stages, ways);
  out.ok = !refused;
  if (out.ok) return out;
  out.reason = refused->reason;
  out.time = refused->time;
  out.place = refused->place;
  out.box = refused->box;
  return out;
}

}  // namespace traj
