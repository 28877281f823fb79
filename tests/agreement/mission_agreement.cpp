// mission_agreement N [SEED]: N missions, each with one obstacle or fence put into the way of one
// of its legs, corners, curves or returns, 1e-6 to 1 m deep. Where the way is, is worked out here
// from the autopilots' documents and another projection (GeographicLib's exact one). None may pass.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "in_the_way.h"
#include "traj/mission/formats/wpl.h"

namespace {

using geom::Vec3;
using in_the_way::Attack;
using in_the_way::projected;
using support::Random;

constexpr double kHome = 10;          // m, z
constexpr double kReturnHeight = 70;  // m above home
constexpr double kSpeed = 15;         // m/s
constexpr double kBraking = 3;        // m/s2
const traj::MissionFrame kFrame{{47, 8, 400}, 0};

double rounded(double degrees) { return std::round(degrees * 1e7) / 1e7; }

// A mission as text, and the places of its items as this program works them out.
struct Written {
  std::string text = "QGC WPL 110\n";
  int lines = 0;

  Vec3 add(int command, Vec3 at, std::array<double, 4> p = {}) {
    const double latitude = rounded(47 + at.y() / 111171);
    const double longitude = rounded(8 + at.x() / 76057);
    const double height = std::round(at.z() * 1e3) / 1e3;
    const bool home = lines == 0;
    text += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{:.7f}\t{:.7f}\t{:.3f}\t1\n", lines,
                        home ? 1 : 0, home ? 0 : 3, command, p[0], p[1], p[2], p[3], latitude,
                        longitude, home ? height + 400 : height - kHome);
    ++lines;
    return projected(latitude, longitude, height);
  }

  void just(int command, std::array<double, 4> p) {
    text += fmt::format("{}\t0\t2\t{}\t{}\t{}\t{}\t{}\t0\t0\t0\t1\n", lines++, command, p[0], p[1],
                        p[2], p[3]);
  }
};

class Case {
 public:
  explicit Case(Random& random) : random_(random) {
    home_ = written_.add(traj::kWaypoint, Vec3(0, 0, kHome));
    top_ = written_.add(traj::kTakeoff, Vec3(0, 0, random_.uniform(25, 60)));
    way_ = {top_};
  }

  // Appends what is attacked, and ends the mission in one of the ways that missions end.
  Attack make(int kind) {
    switch (kind) {
      case 0:
        return leg();
      case 1:
        return {"ascent", between(home_ + Vec3(0, 0, 0.3), top_)};
      case 2:
        return corner();
      case 3:
        return braking();
      case 4:
        return spline();
      case 5:
        return circle();
      case 6:
        return disc();
      case 7:
        return climb();
      case 8:
        return return_home(false);
      case 9:
        return return_home(true);
      case 10:
        return jump();
      case 11:
      case 12: {
        Attack attack = leg();
        return {kind == 11 ? "exclusion" : "inclusion", attack.point, kind - 10};
      }
      case 13:
        return landing();
      case 15:
        return crowd();
      default:
        return delay();
    }
  }

  const std::string& text() const { return written_.text; }

 private:
  Vec3 between(const Vec3& a, const Vec3& b) { return a + random_.uniform(0, 1) * (b - a); }

  Vec3 somewhere() {
    const Vec3& last = way_.back();
    const double angle = random_.uniform(0, 2 * std::numbers::pi);
    const double far = random_.uniform(30, 90);
    return {last.x() + far * std::cos(angle), last.y() + far * std::sin(angle),
            random_.uniform(25, 60)};
  }

  // A waypoint with a hold (s) and a radius (m; 0: none said).
  Vec3 go(double hold = 1, double radius = 0.2, int command = traj::kWaypoint) {
    way_.push_back(written_.add(command, somewhere(), {hold, radius, 0, 0}));
    return way_.back();
  }

  Attack leg() {
    for (int i = 1 + random_.below(3); i > 0; --i) go();
    const std::size_t i =
        1 + static_cast<std::size_t>(random_.below(static_cast<int>(way_.size()) - 1));
    return {"leg", between(way_[i - 1], way_[i])};
  }

  // Random weights of three points.
  Vec3 within(const Vec3& a, const Vec3& b, const Vec3& c) {
    double s = random_.uniform(0, 1);
    double t = random_.uniform(0, 1);
    if (s + t > 1) {
      s = 1 - s;
      t = 1 - t;
    }
    return a + s * (b - a) + t * (c - a);
  }

  static Vec3 towards(const Vec3& from, const Vec3& to, double far) {
    const double length = (to - from).norm();
    return from + (to - from) * std::min(1.0, far / length);
  }

  Attack corner() {
    const double radius = random_.below(2) ? random_.uniform(0.5, 40) : 0;
    go();
    const Vec3 w = go(0, radius);
    go();
    const double r = radius > 0 ? radius : 10;
    const std::size_t n = way_.size();
    return {"corner", within(w, towards(w, way_[n - 3], r), towards(w, way_[n - 1], r))};
  }

  Attack braking() {
    written_.just(traj::kSpeed, {1, kSpeed, -1, 0});
    const double radius = random_.uniform(0.5, 30);
    const auto go_high = [&](double hold, double within) {  // beyond the leg is no ground
      Vec3 p = somewhere();
      p.z() = random_.uniform(50, 60);
      way_.push_back(written_.add(traj::kWaypoint, p, {hold, within, 0, 0}));
      return way_.back();
    };
    go_high(1, 0.2);
    const Vec3 w = go_high(0, radius);
    const Vec3 along = (w - way_[way_.size() - 2]).normalized();
    go();
    const double beyond = kSpeed * kSpeed / (2 * kBraking) - radius;
    return {"braking", w + random_.uniform(0, 1) * beyond * along};
  }

  // As ArduPilot makes it: a straight leg, a spline, and a straight or curved one.
  Attack spline() {
    const double hold = random_.below(2);
    const Vec3 before = way_.back();
    const Vec3 a = go(hold);
    const Vec3 b = go(0, 0, traj::kSplineWaypoint);
    const bool curved = random_.below(2);
    const Vec3 after = go(1, 0, curved ? traj::kSplineWaypoint : traj::kWaypoint);
    Vec3 v = hold > 0 ? Vec3(Vec3::Zero()) : Vec3(a - before);
    Vec3 w = after - (curved ? a : b);
    const double sum = v.norm() + w.norm();
    const double most = 4 * (b - a).norm();
    if (sum > most) {
      v *= most / sum;
      w *= most / sum;
    }
    const double t = random_.uniform(0, 1);
    const double u = 1 - t;
    return {"spline",
            u * u * (1 + 2 * t) * a + t * t * (3 - 2 * t) * b + u * u * t * v - u * t * t * w};
  }

  Attack circle() {
    const double radius = std::round(random_.uniform(5, 25));
    const Vec3 last = go();
    const Vec3 centre = written_.add(traj::kLoiterTurns, somewhere(),
                                     {2, 0, random_.below(2) ? radius : -radius, 0});
    const Vec3 out = Vec3(last.x() - centre.x(), last.y() - centre.y(), 0).normalized();
    const Vec3 entry = centre + radius * out;
    way_.push_back(entry);
    const Vec3 next = go();
    const double angle = random_.uniform(0, 2 * std::numbers::pi);
    const Vec3 around = centre + radius * Vec3(std::cos(angle), std::sin(angle), 0);
    const int which = random_.below(4);
    return {"circle", which == 0   ? between(last, entry)
                      : which == 1 ? between(entry, next)
                                   : around};
  }

  Attack disc() {
    const double radius = random_.uniform(2, 25);
    const Vec3 last = go();
    const Vec3 centre = written_.add(traj::kLoiterTime, somewhere(), {5, 0, radius, 0});
    way_.push_back(centre);
    const Vec3 next = go();
    const double angle = random_.uniform(0, 2 * std::numbers::pi);
    const Vec3 at =
        centre + random_.uniform(0, 1) * radius * Vec3(std::cos(angle), std::sin(angle), 0);
    const int which = random_.below(3);
    return {"disc", which == 0 ? at : between(at, which == 1 ? last : next)};
  }

  Attack climb() {
    const Vec3 last = go();
    const Vec3 end = go(0, 0, traj::kLoiterToHeight);
    const Vec3 level(end.x(), end.y(), last.z());
    const int which = random_.below(3);
    if (which == 0) return {"climb", between(last, level)};
    return {"climb", which == 1 ? between(level, end) : between(last, end)};
  }

  Attack return_home(bool rally) {
    const bool rests = random_.below(2);
    const double radius = random_.uniform(1, 20);
    const Vec3 last = go(rests ? 1 : 0, radius);
    Vec3 from = last;
    if (!rests) from = between(last, towards(last, way_[way_.size() - 2], radius));
    written_.just(traj::kReturn, {0, 0, 0, 0});
    const double z = std::max(last.z(), kHome + kReturnHeight);
    const Vec3 high(from.x(), from.y(), z);
    Vec3 target(home_.x(), home_.y(), z);
    if (rally) {
      const Vec3 place = written_.add(5100, somewhere());
      target = {place.x(), place.y(), z};
      return {"rally", random_.below(2) ? between(high, target) : between(target, place)};
    }
    const int which = random_.below(3);
    if (which == 0) return {"return", between(from, high)};
    if (which == 1) return {"return", between(high, target)};
    return {"return", between(target, home_ + Vec3(0, 0, 0.3))};
  }

  Attack jump() {
    const int target = written_.lines;
    const Vec3 first = go();
    go();
    const Vec3 last = go();
    written_.just(traj::kJump, {static_cast<double>(target), 1.0 + random_.below(3), 0, 0});
    return {"jump", between(last, first)};
  }

  Attack landing() {
    const Vec3 last = go();
    Vec3 ground = somewhere();
    ground.z() = kHome;
    const Vec3 place = written_.add(traj::kLand, ground);
    const Vec3 above(place.x(), place.y(), last.z());
    const bool down = random_.below(2);
    return {"landing", down ? between(above, place + Vec3(0, 0, 0.3)) : between(last, above)};
  }

  // Several waypoints within reach of each other: straight from before them to the one after.
  Attack crowd() {
    constexpr double kRadius = 20;
    go();
    const Vec3 first = go(0, kRadius);
    Vec3 place = first;
    for (int i = 1 + random_.below(3); i > 0; --i) {
      place += Vec3(random_.uniform(-4, 4), random_.uniform(-4, 4), random_.uniform(-1, 1));
      way_.push_back(written_.add(traj::kWaypoint, place, {0, kRadius, 0, 0}));
    }
    const Vec3 from = between(first, towards(first, way_[1], 7));
    return {"crowd", between(from, go())};
  }

  Attack delay() {
    const double radius = random_.uniform(1, 20);
    go();
    const Vec3 w = go(0, radius);
    written_.just(traj::kDelay, {3, 0, 0, 0});
    const Vec3 next = go();
    const Vec3 from = between(w, towards(w, way_[way_.size() - 3], radius));
    return {"delay", between(from, next)};
  }

  Random& random_;
  Written written_;
  Vec3 home_;
  Vec3 top_;
  std::vector<Vec3> way_;
};

traj::FlownMission flown(const std::string& text) {
  std::istringstream in(text);
  const traj::Mission mission = traj::read_wpl(in, "mission");
  traj::MissionRules rules;
  rules.braking = kBraking;
  rules.return_height = kReturnHeight;
  traj::FlownMission made = traj::flown_mission(mission, kFrame, rules, "mission");
  made.drift.clear();  // what the file says, not where autopilots may be
  return made;
}

}  // namespace

int main(int argc, char** argv) {
  return in_the_way::run(argc, argv, kHome, [](Random& random, int i) {
    Case made(random);
    const Attack attack = made.make(i % 16);
    return in_the_way::Trial{made.text(), attack, flown(made.text())};
  });
}
