#include "proof/box_times.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "support/random_city.h"
#include "support/reading.h"
#include "traj/proof/check.h"
#include "traj/proof/exact/exact_check.h"

namespace traj {
namespace {

using geom::CollisionScene;
using geom::TimeSpan;
using Q = mpq_class;

constexpr double kForever = std::numeric_limits<double>::infinity();
const geom::Vehicle kVehicle{"box", {0.5, 0.5, 0.5}};
const Vec3 kGate(1, 0.5, 0.5);  // half sizes of the obstacle at (0, 0, 0)

const geom::BoxMapSpec kSpec{.bounds = {{-100, -50, -50}, {100, 50, 50}},
                             .epoch = "2026-05-04T06:30:00Z"};

CollisionScene gate(const TimeSpan& time) {
  geom::BoxTable table = support::table_of({{-kGate, kGate}});
  if (!time.always()) table.set_time(0, time);
  return {geom::BoxMap(kSpec, table), kVehicle, 0};
}

// Along x by these coefficients, each a segment of 8.
Trajectory along_x(const std::vector<std::array<double, 8>>& xs, const std::vector<double>& times) {
  Trajectory out;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    Segment s;
    s.duration = times[i];
    for (std::size_t k = 0; k < 8; ++k) s.point[k] = {xs[i][k], 0, 0};
    out.segments.push_back(s);
  }
  return out;
}

// All but the joints, which these flights need not keep.
bool clear(const CollisionScene& scene, const Trajectory& t, std::optional<double> start,
           bool stands = false) {
  CheckOptions options;
  options.start = start;
  options.stands = stands;
  options.velocity_gap = options.acceleration_gap = 1e9;
  options.clearance = Clearance::left_out;
  const CheckResult result = check(scene, t, options);
  EXPECT_TRUE(result.ok || result.reason == Reason::collision) << name(result.reason);
  return result.ok;
}

bool exactly_clear(const CollisionScene& scene, const Trajectory& t, std::optional<double> start,
                   bool stands = false) {
  return check_exactly({scene.map(), scene.vehicle(), scene.margin(), {}, start, stands}, t).ok;
}

// A crossing at constant speed, of which all is known in rationals.
struct Crossing {
  double start;
  double duration;
  double from_x;  // -from_x at the end
  // When it is in the grown gate, closed, after the epoch.
  Q enters() const { return at(Q(-1.5)); }
  Q leaves() const { return at(Q(1.5)); }
  Q at(const Q& x) const {
    return Q(start) + Q(duration) * (x - Q(from_x)) / (Q(-from_x) - Q(from_x));
  }
  Trajectory flight() const {  // coefficients at sevenths: exact, as from_x is a multiple of 7
    std::array<double, 8> x{};
    for (int k = 0; k < 8; ++k) x[static_cast<std::size_t>(k)] = from_x - from_x / 7 * (2 * k);
    return along_x({x}, {duration});
  }
};

Crossing any_crossing(support::Random& random) {
  const double x = -7.0 * (1 + random.below(4));
  const double duration = random.below(2) ? 1 + random.below(60) : random.uniform(0.5, 200);
  const double start = random.below(2) ? random.below(7200) - 3600 : random.uniform(-1e5, 1e5);
  return {start, duration, x};
}

// A time near an instant: at it, to the nearest doubles on both sides, or by up to a millisecond.
double near(const Q& instant, support::Random& random) {
  const double t = instant.get_d();
  switch (random.below(6)) {
    case 0:
      return t;
    case 1:
      return std::nextafter(t, kForever);
    case 2:
      return std::nextafter(t, -kForever);
    case 3:
      return t + random.uniform(-2e-6, 2e-6);
    case 4:
      return t + random.uniform(-1e-9, 1e-9);
    default:
      return t + random.uniform(-1e-3, 1e-3);
  }
}

TimeSpan touching(const Q& enters, const Q& leaves, support::Random& random) {
  const int kind = random.below(4);
  if (kind == 0) return {near(leaves, random), kForever};
  if (kind == 1) return {-kForever, near(enters, random)};
  double a = near(random.below(2) ? enters : leaves, random);
  double b = random.below(3) ? a + random.uniform(0, 20) : a;
  if (kind == 3) std::tie(a, b) = std::pair(a - (b - a), a);
  return {a, b};
}

bool meet(const TimeSpan& box, const Q& enters, const Q& leaves, const Q& more = 0) {
  return !(box.from != -kForever && Q(box.from) > leaves + more) &&
         !(box.until != kForever && Q(box.until) < enters - more);
}

TEST(BoxTimesProperty, NeverSaysClearOfABoxThatIsThereAndAlwaysAMicrosecondBeyond) {
  support::Random random(71);
  int hits = 0;
  int close = 0;
  for (int i = 0; i < 110000; ++i) {
    const Crossing crossing = any_crossing(random);
    const TimeSpan time = touching(crossing.enters(), crossing.leaves(), random);
    const bool hit = meet(time, crossing.enters(), crossing.leaves());
    const bool beyond = !meet(time, crossing.enters(), crossing.leaves(), Q(1e-6));
    hits += hit;
    close += !hit && !beyond;
    if (!hit && !beyond) continue;  // either answer is right
    const CollisionScene scene = gate(time);
    ASSERT_EQ(clear(scene, crossing.flight(), crossing.start), !hit)
        << i << ": " << time.from << ' ' << time.until;
    if (i % 50 == 0) {
      ASSERT_EQ(exactly_clear(scene, crossing.flight(), crossing.start), !hit) << i;
    }
  }
  EXPECT_GT(hits, 20000);
  EXPECT_GT(close, 5000);
}

// What the exact check says within the microsecond: it must be right to the last bit but for what
// 60 halvings do not part.
TEST(BoxTimesProperty, TheExactCheckIsNeverWrongAndAcceptsWhatTheFastOneDoes) {
  support::Random random(72);
  int accepted = 0;
  for (int i = 0; i < 2000; ++i) {
    const Crossing crossing = any_crossing(random);
    const TimeSpan time = touching(crossing.enters(), crossing.leaves(), random);
    const CollisionScene scene = gate(time);
    const bool fast = clear(scene, crossing.flight(), crossing.start);
    const bool exact = exactly_clear(scene, crossing.flight(), crossing.start);
    ASSERT_FALSE(exact && meet(time, crossing.enters(), crossing.leaves())) << i;
    ASSERT_FALSE(fast && !exact) << i;
    accepted += exact;
  }
  EXPECT_GT(accepted, 300);
}

Q value(const std::array<double, 8>& x, const Q& u) {
  std::vector<Q> q(x.begin(), x.end());
  for (; q.size() > 1; q.pop_back()) {
    for (std::size_t i = 0; i + 1 < q.size(); ++i) q[i] += u * (q[i + 1] - q[i]);
  }
  return q[0];
}

// Where a rising curve is at x, within 2^-50 of its time from below.
Q reaches(const std::array<double, 8>& curve, const Q& x) {
  Q low = 0;
  Q high = 1;
  for (int i = 0; i < 50; ++i) {
    const Q middle = (low + high) / 2;
    (value(curve, middle) < x ? low : high) = middle;
  }
  return low;
}

// Curves that start and stop, of several segments, whose joints are no round numbers.
TEST(BoxTimesProperty, HoldsForCurvesOfSeveralSegments) {
  support::Random random(73);
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const double rest = random.uniform(0.1, 30);
    const double duration = random.uniform(1, 40);
    const double start = random.uniform(0, 1e5);
    const double a = random.uniform(-30, -2);
    const double b = random.uniform(2, 30);
    const std::array<double, 8> still{a, a, a, a, a, a, a, a};
    const std::array<double, 8> over{a, a, a, a, b, b, b, b};
    const Trajectory there = along_x({still, over}, {rest, duration});
    const Q begin = Q(start) + Q(rest);
    const Q enters = begin + Q(duration) * reaches(over, Q(-1.5));
    const Q leaves = begin + Q(duration) * (reaches(over, Q(1.5)) + Q(0x1p-50));
    const TimeSpan time = touching(enters, leaves, random);
    if (!meet(time, enters, leaves, Q(-1e-9)) && meet(time, enters, leaves, Q(1e-6))) continue;
    const bool hit = meet(time, enters, leaves);
    hits += hit;
    ASSERT_EQ(clear(gate(time), there, start), !hit) << i;
    if (i % 30 == 0) {
      ASSERT_EQ(exactly_clear(gate(time), there, start), !hit) << i;
    }
  }
  EXPECT_GT(hits, 500);
}

TEST(BoxTimes, AFlightWithoutAStartMeetsEveryBox) {
  const Trajectory flight = Crossing{0, 10, -7}.flight();
  EXPECT_TRUE(clear(gate({1000, 2000}), flight, 0));
  EXPECT_FALSE(clear(gate({1000, 2000}), flight, std::nullopt));
  EXPECT_FALSE(clear(gate({}), flight, 0));
  EXPECT_FALSE(exactly_clear(gate({1000, 2000}), flight, std::nullopt));
}

TEST(BoxTimes, ABoxMayOpenAndCloseWhileTheFlightIsInside) {
  const Trajectory rest = along_x({{0, 0, 0, 0, 0, 0, 0, 0}}, {100});
  const double third = 100 / 3.0;
  for (const TimeSpan& inside : {TimeSpan{third, third}, TimeSpan{99.5, 200}, TimeSpan{-5, 0},
                                 TimeSpan{100, 101}, TimeSpan{20, 30}}) {
    EXPECT_FALSE(clear(gate(inside), rest, 0)) << inside.from;
    EXPECT_FALSE(exactly_clear(gate(inside), rest, 0)) << inside.from;
  }
  for (const TimeSpan& outside : {TimeSpan{100 + 1e-9, 200}, TimeSpan{-kForever, -1e-9}}) {
    EXPECT_TRUE(clear(gate(outside), rest, 0)) << outside.from;
    EXPECT_TRUE(exactly_clear(gate(outside), rest, 0)) << outside.from;
  }
}

TEST(BoxTimes, StandingAtTheEndsCountsWhereItIsAsked) {
  const Trajectory in = along_x({{-9, -9, -9, -9, 0, 0, 0, 0}}, {10});
  const Trajectory out = along_x({{0, 0, 0, 0, 9, 9, 9, 9}}, {10});
  const auto both = [](const TimeSpan& time, const Trajectory& t, bool stands) {
    const bool fast = clear(gate(time), t, 50, stands);
    EXPECT_EQ(exactly_clear(gate(time), t, 50, stands), fast);
    return fast;
  };
  EXPECT_TRUE(both({61, 70}, in, false));
  EXPECT_FALSE(both({61, 70}, in, true));
  EXPECT_FALSE(both({1e8, 1e8}, in, true));
  EXPECT_TRUE(both({-kForever, 49}, in, true));
  EXPECT_FALSE(both({-1e9, -1e9}, out, true));
  EXPECT_TRUE(both({-1e9, -1e9}, out, false));
  EXPECT_TRUE(both({61, kForever}, out, true));
  EXPECT_FALSE(both({-kForever, 49}, out, true));
}

TEST(BoxTimes, ReportsTheBoxThatIsThereAndWhen) {
  geom::BoxTable table = support::table_of({{-kGate, kGate}, {{9, -5, -5}, {12, 5, 5}}});
  table.set_time(0, {0, 100});
  table.set_time(1, {1000, 2000});
  const CollisionScene scene(geom::BoxMap(kSpec, table), kVehicle, 0);
  CheckOptions options;
  options.start = 995;
  const CheckResult result = check(scene, Crossing{995, 14, -14}.flight(), options);
  EXPECT_EQ(result.reason, Reason::collision);
  EXPECT_EQ(result.box, 1u);
  EXPECT_NEAR(result.time, 12.25, 1.6);
  ASSERT_TRUE(result.clearance);
  EXPECT_EQ(result.clearance->value, 0);
  options.start = 500;
  const CheckResult between = check(scene, Crossing{500, 14, -14}.flight(), options);
  EXPECT_TRUE(between.ok);
  EXPECT_FALSE(between.clearance);  // no obstacle is there
  options.start = 101;
  const CheckResult before = check(scene, Crossing{101, 14, -14}.flight(), options);
  EXPECT_TRUE(before.ok);
}

TEST(BoxTimes, RefusesAStartThatIsNone) {
  CheckOptions options;
  for (const double start : {std::nan(""), 1.1e9, -kForever}) {
    options.start = start;
    EXPECT_TRUE(support::says(support::refusal_of([&] {
                                check(gate({0, 1}), Crossing{0, 10, -7}.flight(), options);
                              }),
                              "start: expected seconds"));
  }
}

// Many boxes at other times around a flight that stands among them.
TEST(BoxTimes, AHundredBoxesAtOtherTimesAreNoReasonToRefuse) {
  geom::BoxTable table = support::table_of(std::vector<geom::Aabb>(100, {-kGate, kGate}));
  for (std::size_t i = 0; i < 100; ++i) table.set_time(i, {1000.0 + static_cast<double>(i), 2000});
  const CollisionScene scene(geom::BoxMap(kSpec, table), kVehicle, 0);
  const Trajectory rest = along_x({{0, 0, 0, 0, 0, 0, 0, 0}}, {100});
  EXPECT_TRUE(clear(scene, rest, 0));
  EXPECT_TRUE(exactly_clear(scene, rest, 0));
  EXPECT_FALSE(clear(scene, rest, 1000));
}

}  // namespace
}  // namespace traj
