// return_sampling [COUNT] [SEED]: COUNT random flights over random boxes. Returns of many instants
// are followed point by point (thin_return.h) and held against boxes, bounds and fences. Exit 1
// when one meets something at an instant that is in no gap. Also says in how many instants of the
// gaps a return was found that meets something: how tight the gaps are.

#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

#include "geom/base/parallel.h"
#include "support/thin_return.h"
#include "traj/mission/formats/wpl.h"
#include "traj/mission/mavlink/mission_flight.h"

namespace {

using geom::Aabb;
using geom::Vec2;
using geom::Vec3;
using support::Random;

constexpr double kStep = 0.1;     // m between points of a return
constexpr double kSide = 150;     // m from the middle to the map's bounds
constexpr double kHigh = 160;     // m of the bounds
constexpr double kInside = 1e-6;  // m that a point must be inside of an obstacle, for rounding

struct Instant {
  double time = 0;
  Vec3 at = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
  bool on_ground = false;  // on its way up from the ground, or down to it
};

struct Case {
  geom::CollisionScene scene;
  std::vector<std::vector<traj::FlightStage>> stages = {};
  traj::ReturnTask task = {};
  traj::Trajectory trajectory = {};
  std::vector<traj::Drift> drift = {};
};

geom::CollisionScene random_scene(Random& random) {
  std::vector<Aabb> boxes;
  for (int i = 5 + random.below(30); i > 0; --i) {
    const Vec3 low(random.uniform(-kSide, kSide), random.uniform(-kSide, kSide),
                   random.below(6) ? 0 : random.uniform(20, 60));
    boxes.push_back(
        {low, low + Vec3(random.uniform(0.1, 20), random.uniform(0.1, 20), random.uniform(5, 60))});
  }
  geom::BoxTable table = support::table_of(boxes);
  if (random.below(4) == 0) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const double from = random.uniform(0, 200);
      if (random.below(2)) table.set_time(i, {from, from + random.uniform(0, 100)});
    }
  }
  geom::BoxMapSpec spec;
  spec.epoch = "2026-05-04T06:30:00Z";
  spec.bounds = {Vec3(-kSide - 60, -kSide - 60, 0), Vec3(kSide + 60, kSide + 60, kHigh)};
  spec.bounds_from = "option";
  const Vec3 half(random.uniform(0.05, 0.8), random.uniform(0.05, 0.8), random.uniform(0.05, 0.5));
  return {geom::BoxMap(spec, table), geom::Vehicle{"box", half}, random.below(2) * 0.5};
}

Vec3 somewhere(Random& random) {
  return {random.uniform(-80, 80), random.uniform(-80, 80), random.uniform(20, 70)};
}

void fly_curve(Random& random, Case& c) {
  traj::State state{somewhere(random)};
  state.position.z() = random.uniform(35, 55);
  for (int i = 2 + random.below(3); i > 0; --i) {
    traj::State next{somewhere(random)};
    next.position.z() = std::clamp(state.position.z() + random.uniform(-6, 6), 30.0, 60.0);
    if (i > 1) {
      next.velocity = Vec3(random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-1, 1));
    }
    const double lasts = (next.position - state.position).norm() / random.uniform(4, 10) + 2;
    c.trajectory.segments.push_back(traj::hermite(state, next, lasts));
    state = next;
  }
  c.stages.assign(c.task.models.size(), traj::stages_of(c.trajectory));
}

void fly_mission(Random& random, Case& c) {
  std::string text = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t400\t1\n";
  text += fmt::format("1\t0\t3\t22\t0\t0\t0\t0\t47\t8\t{:.3f}\t1\n", random.uniform(20, 60));
  int lines = 2;
  for (int i = 2 + random.below(3); i > 0; --i) {
    const Vec3 p = somewhere(random);
    text += fmt::format("{}\t0\t3\t16\t{}\t{:.2f}\t0\t0\t{:.7f}\t{:.7f}\t{:.3f}\t1\n", lines++,
                        random.below(2) * 2, random.below(2) ? random.uniform(0.5, 20) : 0,
                        47 + p.y() / 111171, 8 + p.x() / 76057, p.z());
  }
  if (random.below(2)) text += fmt::format("{}\t0\t3\t20\t0\t0\t0\t0\t0\t0\t0\t1\n", lines++);
  std::istringstream in(text);
  traj::MissionRules rules;
  rules.return_height = random.uniform(30, 80);
  const traj::FlownMission mission = traj::flown_mission(
      traj::read_wpl(in, "mission"), traj::MissionFrame{{47, 8, 400}, 0}, rules, "mission");
  c.task.models.clear();
  for (const traj::Drift& drift : mission.drift) {
    const bool px4 = drift.autopilot.starts_with("px4");
    traj::ReturnModel model = traj::return_model(px4 ? traj::px4() : traj::ardupilot());
    model.height = *rules.return_height;
    model.around += mission.path_stray;
    c.task.models.push_back(model);
    c.stages.push_back(traj::stages_of(drift));
  }
  c.drift = mission.drift;
  c.task.home = *mission.home;
}

Case random_case(Random& random) {
  Case c{random_scene(random)};
  c.task.models = {support::any_return_model(random)};
  c.task.home = somewhere(random);
  c.task.home.z() = 0;
  if (random.below(2)) {
    fly_curve(random, c);
  } else {
    fly_mission(random, c);
  }
  const int action = random.below(8);
  if (action == 0) c.task.action = traj::ReturnAction::land;
  if (action == 1) c.task.action = traj::ReturnAction::hold;
  for (int i = random.below(3); i > 0; --i) c.task.rally.push_back(somewhere(random));
  if (random.below(3) == 0) c.task.room = Vec3(0.5, 0.5, 1);
  if (random.below(2)) c.task.start = random.uniform(0, 100);
  if (random.below(4) == 0) {
    const Vec3 at = somewhere(random);
    const double size = random.uniform(2, 20);
    c.task.fences.push_back(
        {false, {{at.x(), at.y()}, {at.x() + size, at.y()}, {at.x(), at.y() + size}}, 0});
  }
  return c;
}

// --- instants -----------------------------------------------------------------------------------

Instant curve_instant(Random& random, const Case& c) {
  const double time = random.uniform(0, traj::duration(c.trajectory));
  const traj::State state = traj::evaluate(c.trajectory, time);
  return {time, state.position, state.velocity};
}

// On a leg, no faster than it may be between two rests; or at rest beside it, in a region.
Instant mission_instant(Random& random, const traj::Drift& drift, double deceleration) {
  if (random.below(2)) {
    const auto i = static_cast<std::size_t>(random.below(static_cast<int>(drift.legs.size())));
    const traj::TimedLeg& leg = drift.legs[i];
    if (leg.part.manoeuvre == traj::Manoeuvre::return_home) {
      return mission_instant(random, drift, deceleration);
    }
    if (leg.until <= leg.from) return {leg.from, leg.b, Vec3::Zero(), true};
    const double share = random.uniform(0, 1);
    const Vec3 way = leg.b - leg.a;
    const double nearer = std::min(share, 1 - share) * way.norm();
    const double fast =
        std::min(way.norm() / (leg.until - leg.from), std::sqrt(deceleration * nearer));
    const Vec3 v = way.norm() > 0 ? Vec3(fast * way.normalized()) : Vec3(Vec3::Zero());
    const bool vertical = support::across(leg.a, leg.b) == 0;
    return {leg.from + share * (leg.until - leg.from), leg.a + share * way, v, vertical};
  }
  const auto i = static_cast<std::size_t>(random.below(static_cast<int>(drift.sweeps.size())));
  const traj::Sweep& sweep = drift.sweeps[i];
  if (sweep.part.manoeuvre == traj::Manoeuvre::return_home || !sweep.motion) {
    return mission_instant(random, drift, deceleration);
  }
  Vec3 at = Vec3::Zero();
  double sum = 0;
  for (const Vec3& p : sweep.hull) {
    const double weight = -std::log(random.uniform(1e-9, 1));
    at += weight * p;
    sum += weight;
  }
  at /= sum;
  // The instant of the point of its legs that is nearest.
  double least = std::numeric_limits<double>::infinity();
  double time = 0;
  for (std::size_t k = sweep.motion->first_leg; k <= sweep.motion->last_leg; ++k) {
    if (k >= drift.legs.size()) break;
    const traj::TimedLeg& leg = drift.legs[k];
    const Vec3 way = leg.b - leg.a;
    const double length = way.squaredNorm();
    const double share = length > 0 ? std::clamp((at - leg.a).dot(way) / length, 0.0, 1.0) : 0;
    const double away = (leg.a + share * way - at).norm();
    if (away >= least) continue;
    least = away;
    time = leg.from + share * (leg.until - leg.from);
  }
  return {time, at, Vec3::Zero(), sweep.stands_on.has_value()};
}

// --- what a return meets ------------------------------------------------------------------------

bool contains(const std::vector<Vec2>& ring, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0, k = ring.size() - 1; i < ring.size(); k = i++) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[k];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      inside = !inside;
    }
  }
  return inside;
}

bool is_inside(const Vec3& p, const Aabb& box, const Vec3& reach) {
  return ((p - box.min + reach).array() > kInside).all() &&
         ((box.max + reach - p).array() > kInside).all();
}

// Tops no higher than `ground` are stood on.
bool meets(const Case& c, const Vec3& reach, const Vec3& p, std::optional<double> ground,
           double from, double until) {
  const geom::BoxMap& map = c.scene.map();
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Aabb box = map.box(i);
    if (ground && box.max.z() <= *ground) continue;
    if (!is_inside(p, box, reach)) continue;
    if (!c.task.start || map.timed().empty()) return true;
    const geom::TimeSpan span = map.time(i);
    if (span.until >= *c.task.start + from && span.from <= *c.task.start + until) return true;
  }
  const Aabb& bounds = map.spec().bounds;
  if (((p + reach - bounds.max).array() > kInside).any()) return true;
  if (((bounds.min - p + reach).head<2>().array() > kInside).any()) return true;
  if (!ground && bounds.min.z() - p.z() + reach.z() > kInside) return true;
  for (const traj::Fence& fence : c.task.fences) {
    for (int corner = 0; corner < 4; ++corner) {
      const Vec2 by((corner & 1 ? 1 : -1) * (reach.x() - kInside),
                    (corner & 2 ? 1 : -1) * (reach.y() - kInside));
      if (contains(fence.ring, p.head<2>() + by) != fence.inclusion) return true;
    }
  }
  return false;
}

// Whether one return from the instant meets something. Boxes with a time count as met if they are
// there at the time at which the vehicle comes by.
bool meets_something(Random& random, const Case& c, const traj::ReturnModel& model,
                     const Instant& now) {
  const support::Choice choice = support::any_choice(random);
  const auto places = support::nearest(model, c.task, now.at);
  const Vec3 place =
      places[static_cast<std::size_t>(random.below(static_cast<int>(places.size())))];
  const auto way = support::way_of(model, c.task, now.at, now.velocity, place, choice);
  const Vec3 reach = support::reach(c.scene, model, c.task);
  double time = now.time;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const Vec3 step = way[i + 1] - way[i];
    const int count = 1 + static_cast<int>(step.norm() / kStep);
    const bool sinks = i + 2 == way.size() && c.task.action != traj::ReturnAction::hold;
    std::optional<double> ground;
    if (sinks || now.on_ground || (i > 2 && step.z() < 0)) ground = c.task.home.z();
    const double fast = step.z() > 0 ? model.climb : sinks ? model.descent : model.speed;
    for (int k = 0; k <= count; ++k) {
      const Vec3 p = way[i] + step * k / count;
      const double then = time + step.norm() / fast * k / count;
      if (meets(c, reach, p, ground, then, then)) return true;
    }
    time += step.norm() / fast;
  }
  return false;
}

// The gap that holds the instant, or null.
const traj::ReturnGap* gap_at(const traj::ReturnReport& report, double time) {
  for (const traj::ReturnGap& gap : report.gaps) {
    if (gap.from <= time + 1e-9 && gap.until >= time - 1e-9) return &gap;
  }
  return nullptr;
}

struct Counts {
  std::size_t flights = 0;
  std::size_t ok = 0;
  std::size_t instants = 0;
  std::size_t met = 0;
  std::size_t wrong = 0;  // met, and in no gap
  // By the kind of flight and the reason of its gap: instants in gaps, and those of them where a
  // return was found that meets something.
  struct Confirmed {
    std::size_t in_gaps = 0;
    std::size_t found = 0;
  };
  std::map<std::string, Confirmed> confirmed = {};
  double share = 0;

  void operator+=(const Counts& other) {
    flights += other.flights;
    ok += other.ok;
    instants += other.instants;
    met += other.met;
    wrong += other.wrong;
    for (const auto& [why, one] : other.confirmed) {
      confirmed[why].in_gaps += one.in_gaps;
      confirmed[why].found += one.found;
    }
    share += other.share;
  }
};

Counts judge(std::size_t i, unsigned seed) {
  constexpr int kInstants = 60;
  constexpr int kWays = 12;  // from each
  Random random(7919 * seed + i);
  const Case c = random_case(random);
  const traj::ReturnReport report = traj::prove_return(c.scene, c.stages, c.task);
  Counts out{1, report.ok()};
  out.share = report.share();
  for (int k = 0; k < kInstants; ++k) {
    const auto m = static_cast<std::size_t>(random.below(static_cast<int>(c.task.models.size())));
    const traj::ReturnModel& model = c.task.models[m];
    const Instant now = c.drift.empty() ? curve_instant(random, c)
                                        : mission_instant(random, c.drift[m], model.deceleration);
    bool met = false;
    for (int way = 0; way < kWays && !met; ++way) met = meets_something(random, c, model, now);
    const traj::ReturnGap* gap = gap_at(report, now.time);
    ++out.instants;
    out.met += met;
    if (gap) {
      Counts::Confirmed& one = out.confirmed[fmt::format(
          "{}: {}, {}", c.drift.empty() ? "curve" : "mission", gap->phase, name(gap->reason))];
      ++one.in_gaps;
      one.found += met;
    }
    if (!met || gap) continue;
    if (++out.wrong == 1) {
      fmt::print("flight {}: at {} s in [{}, {}, {}] {} meets something\n", i, now.time, now.at.x(),
                 now.at.y(), now.at.z(), model.autopilot);
    }
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const auto count = static_cast<std::size_t>(argc > 1 ? std::stod(argv[1]) : 100);
  const auto seed = static_cast<unsigned>(argc > 2 ? std::atoi(argv[2]) : 1);
  std::vector<Counts> each(count);
  geom::parallel_for(count, {2, {}}, [&](std::size_t i) { each[i] = judge(i, seed); });
  Counts all;
  for (const Counts& one : each) all += one;
  fmt::print("{} flights, {} of them with a return from every instant; {:.1f} % of the time\n",
             all.flights, all.ok, 100 * all.share / static_cast<double>(all.flights));
  fmt::print("{} instants: {} with a return that meets something, {} of them in no gap\n",
             all.instants, all.met, all.wrong);
  for (const auto& [why, one] : all.confirmed) {
    fmt::print("{:28} {:6} instants in gaps, {:6} confirmed ({:.0f} %)\n", why, one.in_gaps,
               one.found,
               100.0 * static_cast<double>(one.found) / static_cast<double>(one.in_gaps));
  }
  return all.wrong != 0;
}
