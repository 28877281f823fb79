// return_agreement [COUNT] [SEED]: COUNT flights whose returns are clear, each once more with one
// box that touches the return of one instant: where it brakes, climbs, goes across, arrives above
// home, sinks, or lands; by nothing, by 1e-9 m, or by more. Where a return goes is worked out in
// thin_return.h. Exit 1 when the instant is in no gap then, or in one before.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

#include "geom/base/parallel.h"
#include "support/small_map.h"
#include "support/thin_return.h"
#include "traj/curve/control_points.h"
#include "traj/mission/formats/wpl.h"
#include "traj/mission/mavlink/mission_flight.h"

namespace {

using geom::Aabb;
using geom::Vec3;
using support::Choice;
using support::Random;

// Where the vehicle is at an instant, and how fast; and a moment later, on the same piece.
struct Instant {
  double time = 0;
  Vec3 at = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
  Vec3 at_later = Vec3::Zero();
  Vec3 velocity_later = Vec3::Zero();
};

struct Case {
  Vec3 half = Vec3::Zero();
  double margin = 0;
  std::vector<Aabb> boxes;
  std::vector<std::vector<traj::FlightStage>> stages;  // of each model
  traj::ReturnTask task;
  std::size_t model = 0;  // of these, which is attacked
  Instant instant;
  std::string flight;

  geom::CollisionScene scene(const std::vector<Aabb>& more = {}) const {
    std::vector<Aabb> all = boxes;
    all.insert(all.end(), more.begin(), more.end());
    return {support::map_of({{-4000, -4000, 0}, {4000, 4000, 4000}}, all), {"box", half}, margin};
  }
  const traj::ReturnModel& attacked() const { return task.models[model]; }
};

traj::ReturnReport prove(const Case& c, const std::vector<Aabb>& more = {}) {
  return traj::prove_return(c.scene(more), c.stages, c.task);
}

bool has_gap(const traj::ReturnReport& report, double time) {
  constexpr double kRounding = 1e-9;  // s
  for (const traj::ReturnGap& gap : report.gaps) {
    if (gap.from <= time + kRounding && gap.until >= time - kRounding) return true;
  }
  return false;
}

// --- flights ------------------------------------------------------------------------------------

Vec3 somewhere(Random& random) {
  return {random.stepped(-100, 100, 0.25), random.stepped(-100, 100, 0.25),
          random.stepped(60, 100, 0.25)};
}

// A curve of one to three pieces; the instant is an eighth of one, or a joint.
void fly_curve(Random& random, Case& c) {
  c.flight = "curve";
  traj::Trajectory trajectory;
  Vec3 begin = somewhere(random);
  for (int i = 1 + random.below(3); i > 0; --i) {
    traj::Segment segment;
    segment.duration = random.stepped(4, 20, 0.5);
    const bool straight = random.below(3) == 0;
    const Vec3 along(random.stepped(-4, 4, 0.25), random.stepped(-4, 4, 0.25),
                     random.stepped(-1, 1, 0.25));
    for (std::size_t k = 0; k < segment.point.size(); ++k) {
      segment.point[k] = begin + static_cast<double>(k) * along;
      if (straight || k == 0) continue;
      segment.point[k] += Vec3(random.stepped(-4, 4, 0.25), random.stepped(-4, 4, 0.25),
                               random.stepped(-2, 2, 0.25));
    }
    begin = segment.point.back();
    trajectory.segments.push_back(segment);
  }
  const auto which =
      static_cast<std::size_t>(random.below(static_cast<int>(trajectory.segments.size())));
  double before = 0;
  for (std::size_t i = 0; i < which; ++i) before += trajectory.segments[i].duration;
  const traj::Segment& piece = trajectory.segments[which];
  const double t = piece.duration * random.below(9) / 8;
  const traj::State now = traj::evaluate(piece, t);
  const double step = t > 0 ? -1e-4 : 1e-4;
  const traj::State later = traj::evaluate(piece, t + step);
  c.instant = {before + t, now.position, now.velocity, later.position, later.velocity};
  c.stages.assign(c.task.models.size(), traj::stages_of(trajectory));
}

// Legs with a rest at their points, and perhaps a hold.
void fly_legs(Random& random, Case& c) {
  c.flight = "legs";
  traj::FlownMission mission;
  const double speed = random.stepped(1, 15, 0.5);
  for (int i = 2 + random.below(4); i > 0; --i) mission.path.push_back(somewhere(random));
  for (std::size_t i = 0; i < mission.path.size(); ++i) {
    mission.hold.push_back(random.below(2) * 3);
  }
  if (random.below(2)) mission.climb = 3;
  if (random.below(2)) mission.descent = 1.5;
  const auto lasts = [&](const Vec3& a, const Vec3& b) {
    const double rise = b.z() - a.z();
    const double vertical = rise > 0 ? mission.climb : mission.descent;
    const double along = (b - a).norm() / speed;
    return vertical > 0 ? std::max(along, std::abs(rise) / vertical) : along;
  };
  const auto which =
      1 + static_cast<std::size_t>(random.below(static_cast<int>(mission.path.size()) - 1));
  double before = mission.hold[0];
  for (std::size_t i = 1; i < which; ++i) {
    before += lasts(mission.path[i - 1], mission.path[i]) + mission.hold[i];
  }
  const Vec3& a = mission.path[which - 1];
  const Vec3& b = mission.path[which];
  const double seconds = lasts(a, b);
  if (!(seconds > 0)) return fly_legs(random, c);
  const double share = random.stepped(0, 1, 0.125);
  const Vec3 v = (b - a) / seconds;
  const double step = share > 0 ? -1e-4 : 1e-4;
  c.instant = {before + share * seconds, a + share * (b - a), v, a + (share + step) * (b - a), v};
  c.stages.assign(c.task.models.size(), traj::stages_of(mission, speed));
}

// A mission file, as PX4 and ArduPilot fly it: no faster than braking to rest at either end of a
// leg allows.
void fly_mission(Random& random, Case& c) {
  c.flight = "mission";
  std::string text = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t400\t1\n";
  int lines = 1;
  const auto add = [&](int command, double hold, double radius) {
    const Vec3 p = somewhere(random);
    text += fmt::format("{}\t0\t3\t{}\t{}\t{:.2f}\t0\t0\t{:.7f}\t{:.7f}\t{:.3f}\t1\n", lines++,
                        command, hold, radius, 47 + p.y() / 111171, 8 + p.x() / 76057, p.z());
  };
  text +=
      fmt::format("{}\t0\t3\t22\t0\t0\t0\t0\t47\t8\t{:.3f}\t1\n", lines++, random.uniform(60, 90));
  for (int i = 2 + random.below(3); i > 0; --i) {
    add(traj::kWaypoint, random.below(2) * 2, random.below(2) ? random.uniform(0.5, 20) : 0);
  }
  std::istringstream in(text);
  const traj::MissionFrame frame{{47, 8, 400}, 0};
  traj::FlownMission mission =
      traj::flown_mission(traj::read_wpl(in, "mission"), frame, {}, "mission");
  c.task.models.clear();
  c.stages.clear();
  for (const traj::Drift& drift : mission.drift) {
    const bool px4 = drift.autopilot.starts_with("px4");
    traj::ReturnModel model = traj::return_model(px4 ? traj::px4() : traj::ardupilot());
    model.around += mission.path_stray;
    c.task.models.push_back(model);
    c.stages.push_back(traj::stages_of(drift));
  }
  c.model = static_cast<std::size_t>(random.below(static_cast<int>(c.task.models.size())));
  c.task.home = *mission.home;
  const traj::Drift& drift = mission.drift[c.model];
  const auto which =
      1 + static_cast<std::size_t>(random.below(static_cast<int>(drift.legs.size()) - 1));
  const traj::TimedLeg& leg = drift.legs[which];
  const double share = random.below(3) ? random.uniform(0, 1) : random.below(2);
  const double nearer = std::min(share, 1 - share) * (leg.b - leg.a).norm();
  const double fast = std::min((leg.b - leg.a).norm() / (leg.until - leg.from),
                               std::sqrt(c.attacked().deceleration * nearer));
  const Vec3 v = fast * (leg.b - leg.a).normalized();
  const double step = share > 0 ? -1e-4 : 1e-4;
  c.instant = {leg.from + share * (leg.until - leg.from), leg.a + share * (leg.b - leg.a), v,
               leg.a + (share + step) * (leg.b - leg.a), v};
}

// --- tasks --------------------------------------------------------------------------------------

Case any_case(Random& random, bool lands_on_roof) {
  Case c;
  const bool point = random.below(4) == 0;
  for (double& size : c.half) size = point ? 0 : random.stepped(0, 1, 0.0625);
  c.margin = point ? 0 : random.stepped(0, 1, 0.125);
  for (int i = 1 + random.below(2); i > 0; --i) {
    c.task.models.push_back(support::any_return_model(random));
  }
  c.model = static_cast<std::size_t>(random.below(static_cast<int>(c.task.models.size())));
  if (random.below(3) == 0) {
    for (double& by : c.task.room) by = random.stepped(0, 2, 0.125);
  }
  const Vec3 home = somewhere(random);
  c.task.home = {home.x(), home.y(), 0};
  const int kind = lands_on_roof ? 0 : random.below(3);
  if (kind == 0) fly_curve(random, c);
  if (kind == 1) fly_legs(random, c);
  if (kind == 2) fly_mission(random, c);
  if (lands_on_roof) return c;
  const int action = random.below(6);
  if (action == 0) c.task.action = traj::ReturnAction::land;
  if (action == 1) c.task.action = traj::ReturnAction::hold;
  for (int i = random.below(3); i > 0; --i) c.task.rally.push_back(somewhere(random));
  return c;
}

// Some obstacles that are in no return's way, if any of a few are.
void add_others(Random& random, Case& c) {
  std::vector<Aabb> boxes;
  for (int i = random.below(4); i > 0; --i) {
    const Vec3 low(random.stepped(-300, 300, 1), random.stepped(-300, 300, 1), 0);
    boxes.push_back({low, low + Vec3(random.stepped(1, 20, 1), random.stepped(1, 20, 1),
                                     random.stepped(1, 50, 1))});
  }
  if (prove(c, boxes).ok()) c.boxes.insert(c.boxes.end(), boxes.begin(), boxes.end());
}

// --- attacks ------------------------------------------------------------------------------------

struct Attack {
  std::string what;
  std::vector<Aabb> boxes;
};

double any_depth(Random& random) {
  switch (random.below(3)) {
    case 0:
      return 0;
    case 1:
      return 1e-9;
    default:
      return std::pow(10, random.uniform(-9, -2));
  }
}

// A box on the side of `normal`, whose form grown by `reach` has the place `depth` inside of its
// faces there.
Aabb box_beside(Random& random, const Vec3& place, const Vec3& normal, const Vec3& reach,
                double depth) {
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    const double size = std::pow(10, random.uniform(-3, 1));
    const double in = std::min(depth, size);  // a thinner box would not hold the place
    if (normal[i] == 0) {
      const double below = random.uniform(0.01, 0.99) * (size + 2 * reach[i]);
      box.min[i] = place[i] + reach[i] - below;
      box.max[i] = box.min[i] + size;
    } else if (normal[i] > 0) {
      box.min[i] = place[i] - in + reach[i];
      box.max[i] = box.min[i] + size;
    } else {
      box.max[i] = place[i] + in - reach[i];
      box.min[i] = box.max[i] - size;
    }
  }
  return box;
}

// The side of the surface that returns of neighbouring instants make.
Vec3 normal_of(Random& random, const Vec3& way, const Vec3& moves) {
  const Vec3 normal = way.cross(moves);
  const double size = normal.norm();
  if (size < 1e-12 || size < 1e-6 * way.norm() * moves.norm()) {
    Vec3 out(random.below(3) - 1, random.below(3) - 1, random.below(3) - 1);
    return out.isZero(0) ? Vec3(Vec3::UnitX()) : out;
  }
  Vec3 out = normal / size * (random.below(2) ? 1 : -1);
  for (double& one : out) {
    if (std::abs(one) < 1e-9) one = 0;
  }
  return out;
}

std::string phase_of(const Case& c, std::size_t part, double share) {
  if (c.task.action != traj::ReturnAction::rtl) {
    return fmt::format("{}: {}", traj::name(c.task.action), part == 0 ? "braking" : "descent");
  }
  constexpr std::array kNames{"braking", "climb", "way", "arrival", "descent"};
  return part == 2 && share == 1 ? "corner above home" : kNames[part];
}

Attack touch(Random& random, const Case& c) {
  const traj::ReturnModel& model = c.attacked();
  const Instant& now = c.instant;
  const Choice choice = support::any_choice(random);
  const auto places = support::nearest(model, c.task, now.at);
  const Vec3 place =
      places[static_cast<std::size_t>(random.below(static_cast<int>(places.size())))];
  const auto way = support::way_of(model, c.task, now.at, now.velocity, place, choice);
  const auto later =
      support::way_of(model, c.task, now.at_later, now.velocity_later, place, choice);
  const auto part = static_cast<std::size_t>(random.below(static_cast<int>(way.size()) - 1));
  const double share = random.below(3) ? random.uniform(0, 1) : random.below(2);
  const auto at = [&](const std::vector<Vec3>& points) {
    return Vec3(points[part] + share * (points[part + 1] - points[part]));
  };
  const Vec3 touched = at(way);
  const Vec3 normal = normal_of(random, way[part + 1] - way[part], at(later) - touched);
  const Vec3 reach = support::reach(c.scene(), model, c.task);
  const Aabb box = box_beside(random, touched, normal, reach, any_depth(random));
  if (box.max.z() <= c.task.home.z()) return touch(random, c);  // the vehicle stands on it
  return {phase_of(c, part, share), {box}};
}

// A roof under home. What lands there, off its way by all that it may, stands with an edge of it
// beyond an edge of the roof.
Attack off_roof(Random& random, Case& c) {
  c.task.home.z() = random.stepped(2, 20, 0.25);
  const Vec3 wide = c.half + c.attacked().around + c.task.room;
  const Vec3 high(0, 0, c.task.home.z());
  const Vec3 ground = c.task.home - high;
  const Vec3 spare(60, 60, 0);
  c.boxes = {{ground - spare, c.task.home + spare}};
  Aabb roof = c.boxes.front();
  const int axis = random.below(2);
  const double depth = std::pow(10, random.uniform(-9, 0));
  if (random.below(2)) {
    roof.max[axis] = c.task.home[axis] + wide[axis] - depth;
  } else {
    roof.min[axis] = c.task.home[axis] - wide[axis] + depth;
  }
  return {"landing on an edge", {roof}};
}

struct Counts {
  std::size_t cases = 0;
  std::size_t free = 0;
  std::size_t safe = 0;
};

void judge(std::size_t i, unsigned seed, std::map<std::string, Counts>& counts, std::string& said) {
  Random random(1000003 * seed + i);
  const bool roof = i % 16 == 0;
  Case c = any_case(random, roof);
  Attack attack;
  if (roof) {
    attack = off_roof(random, c);
  } else {
    add_others(random, c);
    attack = touch(random, c);
  }
  Counts& count = counts[attack.what];
  ++count.cases;
  const bool free = prove(c).ok();
  count.free += free;
  Case hit = c;
  if (roof) hit.boxes.clear();
  const bool safe = !has_gap(prove(hit, attack.boxes), c.instant.time);
  count.safe += safe;
  if (free && !safe) return;
  said += fmt::format("case {}, {} by {}, {}: {} before, {} with the box\n", i, c.flight,
                      c.attacked().autopilot, attack.what, free ? "free" : "not free",
                      safe ? "called safe" : "refused");
}

}  // namespace

int main(int argc, char** argv) {
  const auto count = static_cast<std::size_t>(argc > 1 ? std::stod(argv[1]) : 2000);
  const auto seed = static_cast<unsigned>(argc > 2 ? std::atoi(argv[2]) : 1);
  constexpr std::size_t kBlock = 100;
  struct Block {
    std::map<std::string, Counts> counts;
    std::string said;
  };
  std::vector<Block> blocks((count + kBlock - 1) / kBlock);
  geom::parallel_for(blocks.size(), {2, {}}, [&](std::size_t b) {
    for (std::size_t i = b * kBlock; i < std::min(count, (b + 1) * kBlock); ++i) {
      judge(i, seed, blocks[b].counts, blocks[b].said);
    }
  });
  std::map<std::string, Counts> all;
  std::string said;
  for (const Block& block : blocks) {
    if (said.size() < 2000) said += block.said;
    for (const auto& [what, one] : block.counts) {
      all[what].cases += one.cases;
      all[what].free += one.free;
      all[what].safe += one.safe;
    }
  }
  fmt::print("{}", said);
  Counts sum;
  for (const auto& [what, one] : all) {
    fmt::print("{:20} {:7} flights, {:7} free, {:3} called safe with the box\n", what, one.cases,
               one.free, one.safe);
    sum.cases += one.cases;
    sum.free += one.free;
    sum.safe += one.safe;
  }
  fmt::print("{:20} {:7} flights, {:7} free, {:3} called safe with the box\n", "all", sum.cases,
             sum.free, sum.safe);
  return sum.safe != 0 || sum.free != sum.cases;
}
