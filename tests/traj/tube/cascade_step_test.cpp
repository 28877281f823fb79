#include "tube/cascade_step.h"

#include <gtest/gtest.h>

#include "step_case.h"

namespace traj {
namespace {

using testing::vector;

constexpr double kGravity = 9.80665;
using Model = CascadeRows::Model;

FlightOptions flight_of(std::string_view vehicle) {
  return testing::flight_of(vehicle, ControlLaw::cascade);
}

CascadeLoop loop_of(const FlightOptions& options) {
  return {options.quadrotor, options.gains, options.periods, {1, 0}};
}

// The references of the period that begins at step n, the controller's first run being at -before.
CascadeReferences references_of(const ReferenceTrack& track, const FlightOptions& options, long n,
                                long before) {
  std::size_t cursor = 0;
  CascadeReferences out;
  out.step = n + before;
  for (int j = 0; j <= options.periods.attitude; ++j) {
    out.at.push_back(track.at(static_cast<double>(n + j) * kStep, cursor));
  }
  const long last = (out.step + options.periods.position - 1) / options.periods.position - 1;
  if (last >= 0) {
    cursor = 0;
    out.last_asked =
        track.at(static_cast<double>(last * options.periods.position - before) * kStep, cursor)
            .acceleration;
  }
  return out;
}

// kp (p_r - p) + f v_r - v.
Vec3 velocity_error(const CascadeLoop& loop, const CascadeState<double>& s) {
  const LiftGains k(loop);
  const Vec3 drift = (vector(s.due) - k.of_missed.cwiseProduct(vector(s.missed)) +
                      k.of_slope.cwiseProduct(vector(s.slope)))
                         .cwiseQuotient(k.of_drift);
  return vector(s.missed) + drift;
}

GainErrors<Model> exactly(const GainErrors<double>& errors) {
  GainErrors<Model> out;
  out.none = errors.none;
  std::vector<double> shares;
  GainErrors<double> all = errors;
  testing::for_each(all, [&](double share) { shares.push_back(share); });
  std::size_t at = 0;
  testing::for_each(out, [&](Model& m) { m = shares[at++]; });
  return out;
}

// The largest difference from the simulator's flight, at any step of the attitude loop.
double disagreement(const FlightOptions& options, double yaw, double error, std::uint64_t seed) {
  const ReferenceTrack track(testing::bend(yaw));
  const CascadeLoop loop = loop_of(options);
  const testing::OddFlight flight(track, options, error, seed);
  const int period = options.periods.attitude;
  const long before = std::lround(options.hover / kStep);
  CascadeState<double> s = testing::numbers<CascadeRows>(
      cascade_starting(loop, 1 / (1 + error), references_of(track, options, -before, before).at[0],
                       flight.off<Model>(), exactly(flight.gains)));
  flight.set(s);
  double worst = 0;
  const long steps = std::lround((track.duration() + options.settle) / kStep);
  for (long n = -before; n <= steps; n += period) {
    const CascadeReferences references = references_of(track, options, n, before);
    const Reference& now = references.at[0];
    if (n >= 0) {
      const Vec3 velocity = vector(s.velocity);
      const Vec3 missed = velocity_error(loop, s);
      const Vec3 off = -(missed + velocity - options.gains.feed_forward.velocity * now.velocity)
                            .cwiseQuotient(flight.fate.gains->position.p);
      worst = std::max(worst, flight.off(n, off, velocity, vector(s.rates), vector(s.spin)));
    }
    const int every = options.periods.position;
    const int run = (every - static_cast<int>(references.step % every)) % every;
    s = cascade_step(loop, s, references, flight.readings(n + before, run), flight.gains).state;
    s.gust = s.gust + flight.gust(n + before, period);
  }
  return worst;
}

TEST(CascadeStep, IsWhatTheSimulatorDoes) {
  for (const std::string_view vehicle : {"quad2kg", "crazyflie", "tello"}) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      FlightOptions options = flight_of(vehicle);
      if (seed == 1) options.periods = {4, 4};
      if (seed == 2) options.periods = {7, 3};
      if (seed == 3) options.gains.feed_forward = {0.9, 0.5, 0};
      const double yaw = static_cast<double>(seed) * 1.4 - 2;
      EXPECT_LT(disagreement(options, yaw, 0.02 * static_cast<double>(seed), seed), 1e-9)
          << vehicle << " " << seed;
    }
  }
}

// Every state within the radii is mapped to what the models say.
TEST(CascadeStep, BoundsEveryStep) {
  support::Random random(5);
  const FlightOptions options = flight_of("tello");  // drag and inertia differ by axis
  const CascadeLoop loop = loop_of(options);
  const ReferenceTrack track(testing::bend(0.4));
  const double sizes[CascadeRows::kStates] = {
      0.3,  0.3, 0.3, 0.1, 0.1, 0.1, 0.02, 0.02, 0.2, 0.02, 0.2,  0.2,  0.2, 2,    2,
      1,    2,   2,   1,   1,   1,   0.5,  0.2,  0.2, 0.2,  0.2,  0.2,  0.2, 0.02, 0.02,
      0.02, 0.5, 0.5, 0.5, 0.3, 0.3, 0.3,  0.02, 0.1, 0.05, 0.04, 0.05, 0.06};
  const auto look = [](const auto& after, const auto& there, const auto& holds) {
    const auto all_hold = [&](const Triple<Model>& m, const Triple<double>& value) {
      holds(m.x, value.x), holds(m.y, value.y), holds(m.z, value.z);
    };
    all_hold(after.rates, there.rates);
    for (std::size_t n = 0; n < there.runs.size(); ++n) {
      all_hold(after.runs[n].velocity, there.runs[n].velocity);
      all_hold(after.runs[n].before, there.runs[n].before);
      all_hold(after.runs[n].acceleration, there.runs[n].acceleration);
      all_hold(after.runs[n].lift, there.runs[n].lift);
    }
    for (std::size_t j = 0; j < there.turns.size(); ++j) {
      all_hold(after.turns[j].before, there.turns[j].before);
      all_hold(after.turns[j].spin, there.turns[j].spin);
    }
  };
  testing::Held held;
  for (int k = 0; k < 200; ++k) {
    const CascadeReferences references = references_of(
        track, options, 4 * static_cast<long>(random.below(2400)), 4 * random.below(9));
    const Vec3 lift = references.at[0].acceleration + kGravity * Vec3::UnitZ();
    const testing::AnyReadings read(random, k % 2 == 0, k % 4 < 2);
    const auto step_of = [&](const auto& state) {
      return cascade_step(loop, state, references, read.of(state.velocity.x),
                          read.gains(state.velocity.x));
    };
    testing::hold_steps<CascadeRows>(random, sizes, lift, step_of, look, held);
  }
  EXPECT_EQ(held.outside, 0);
  EXPECT_GT(held.bounded, 200000) << "a bound that is infinite says nothing";
}

// The controller clips the output, and looks at what it would be with the integral of before.
TEST(CascadeStep, RunsTheRateLoopWithTheIntegralBeforeAndAfter) {
  const CascadeLoop loop = loop_of(flight_of("tello"));
  CascadeState<double> state = testing::numbers<CascadeRows>(cascade_at_rest(1));
  state.rates = triple(Vec3(0.3, -0.2, 0.1));
  state.integral = triple(Vec3(1, 2, -3));
  state.filtered = triple(Vec3(-0.5, 0.4, 0.2));
  const auto step = cascade_step(loop, state, {.at = std::vector<Reference>(5)});
  const PidGains& k = loop.gains.rates;
  const Vec3 error = vector(step.rates) - vector(state.rates);
  const Vec3 before =
      k.p.cwiseProduct(error) + vector(state.integral) - k.d.cwiseProduct(vector(state.filtered));
  ASSERT_EQ(step.turns.size(), 4u);
  ASSERT_GT(k.i.minCoeff(), 0);
  EXPECT_LT((vector(step.turns[0].before) - before).norm(), 1e-12);
  EXPECT_LT((vector(step.turns[0].spin) - before - 1e-3 * k.i.cwiseProduct(error)).norm(), 1e-12);
}

// What may be clipped is what gains that are off ask for.
TEST(CascadeStep, AsksForTheLiftOfItsOwnGains) {
  CascadeLoop loop = loop_of(flight_of("tello"));
  const PidGains& k = loop.gains.velocity;
  const LiftGains of(loop);
  CascadeState<double> state = testing::numbers<CascadeRows>(cascade_at_rest(1));
  const Vec3 missed(0.3, -0.2, 0.1);
  const Vec3 slope(0.2, 0.1, -0.4);
  const Vec3 sum(0.5, -0.4, 0.3);  // the integral, with exact gains
  state.lift =
      triple(kGravity * Vec3::UnitZ() + k.p.cwiseProduct(missed) + sum + k.d.cwiseProduct(slope));
  state.missed = triple(missed);
  state.slope = triple(slope);
  // The error has not changed since.
  state.due = triple(of.of_missed.cwiseProduct(missed) - of.of_slope.cwiseProduct(slope));
  GainErrors<double> off;
  off.none = false;
  off.velocity = {0.1, -0.1, 0.1};
  off.velocity_i = {0.2, 0.2, -0.2};
  off.velocity_d = {-0.3, 0.3, 0.3};
  const auto step = cascade_step(loop, state, {.at = std::vector<Reference>(5)}, {}, off);
  const auto scaled_by = [](const Triple<double>& share, const Vec3& v) -> Vec3 {
    return v + vector(share).cwiseProduct(v);
  };
  const Vec3 grown = of.of_missed.cwiseProduct(missed);
  const Vec3 asked = scaled_by(off.velocity, k.p.cwiseProduct(missed)) +
                     scaled_by(off.velocity_d, k.d.cwiseProduct((1 - of.share) * slope));
  ASSERT_EQ(step.runs.size(), 1u);
  ASSERT_GT(k.i.minCoeff(), 0);
  ASSERT_GT(k.d.minCoeff(), 0);
  EXPECT_LT(
      (vector(step.runs[0].acceleration) - asked - scaled_by(off.velocity_i, sum + grown)).norm(),
      1e-12);
  EXPECT_LT((vector(step.runs[0].before) - asked - scaled_by(off.velocity_i, sum)).norm(), 1e-12);
  EXPECT_LT(
      (vector(step.runs[0].lift) - vector(step.runs[0].acceleration) - kGravity * Vec3::UnitZ())
          .norm(),
      1e-12);
}

TEST(CascadeStep, HasNoBoundForAThrustThatMayPointDown) {
  const FlightOptions options = flight_of("quad2kg");
  CascadeState<Model> state = cascade_at_rest(1);
  state.lift.z = Model::symbol(kGravity, 2, 10);
  const auto step = cascade_step(loop_of(options), state, {.at = std::vector<Reference>(5)});
  EXPECT_FALSE(std::isfinite(step.state.velocity.x.radius()));
}

}  // namespace
}  // namespace traj
