#include "traj/tube/prove_tube.h"

#include <gtest/gtest.h>

#include "step_case.h"
#include "traj/flights.h"

namespace traj {
namespace {

FlightOptions flight_of(std::string_view vehicle, ControlLaw law = ControlLaw::geometric) {
  FlightOptions options = testing::flight_of(vehicle, law);
  options.hover = 0.6;
  options.settle = 0.4;
  return options;
}

// The worst share of the radius that flights come to.
double worst_share(const Trajectory& trajectory, const FlightOptions& options,
                   const Disturbances& d) {
  const ReferenceTrack track(trajectory);
  const ProvedTube tube = prove_tube(track, options, d, {});
  EXPECT_FALSE(tube.trouble);
  if (tube.trouble) return NAN;
  support::Random random(3);
  testing::Fates fates(options, d, track.duration());
  double worst = 0;
  for (int k = 0; k < 24; ++k) {
    const auto fate = fates.drawn(random, k % 3);
    const auto flight = testing::fly(track, options, d, fate);
    EXPECT_FALSE(flight.saturated);
    EXPECT_LE(flight.tilt, tube.tilt);
    EXPECT_GT(flight.tilt, tube.tilt - 0.15) << "a bound that is far too wide";
    worst = std::max(worst, testing::worst_share(tube, flight));
  }
  return worst;
}

void expect_inside(std::string_view vehicle, const Trajectory& trajectory, const Disturbances& d,
                   ControlLaw law = ControlLaw::geometric) {
  const double worst = worst_share(trajectory, flight_of(vehicle, law), d);
  EXPECT_LE(worst, 1) << vehicle;
  EXPECT_GT(worst, 0.5) << vehicle << ": a tube that is far too wide";
}

TEST(ProveTube, HoldsFlightsThatArePushedAsFarAsTheyCan) {
  expect_inside("quad2kg", testing::line({6, 3, 2}, 4),
                {.wind = {1, -1, 0}, .wind_spread = 0.2, .gust_most = 0.7, .mass_error = 0.01});
  expect_inside("crazyflie", testing::line({1, 1, 0.5}, 4),
                {.wind_spread = 0.05, .gust_most = 0.3, .gust_lag = 0.5, .mass_error = 0.005});
  expect_inside("tello", testing::line({1, 1, 0.5}, 4), {.mass_error = 1e-4});
}

// Flights whose vehicle is not as the controller believes, and each range by itself: the tube
// grows, and holds them.
TEST(ProveTube, HoldsVehiclesThatDifferFromWhatIsBelieved) {
  const Disturbances all{.wind = {2, 0, 0},
                         .gust_most = 0.2,
                         .mass_error = 0.003,
                         .drag_error = 0.03,
                         .motor_lag_error = 0.02,
                         .inertia_error = 0.02};
  expect_inside("quad2kg", testing::line({6, 3, 2}, 4), all);
  const ReferenceTrack track(testing::line({6, 3, 2}, 4));
  const double none = prove_tube(track, flight_of("quad2kg"), {.wind = {2, 0, 0}}, {}).largest;
  for (const auto one : {&Disturbances::mass_error, &Disturbances::drag_error,
                         &Disturbances::motor_lag_error, &Disturbances::inertia_error}) {
    Disturbances d{.wind = {2, 0, 0}};
    d.*one = 0.02;
    const ProvedTube tube = prove_tube(track, flight_of("quad2kg"), d, {});
    ASSERT_FALSE(tube.trouble);
    EXPECT_GT(tube.largest, none * (1 + 1e-6));
    expect_inside("quad2kg", testing::line({6, 3, 2}, 4), d);
  }
}

// Noise of all sensors, and of each by itself: the tube grows.
void expect_noise(const Disturbances& all, ControlLaw law) {
  expect_inside("quad2kg", testing::line({0.2, 0.1, 0.1}, 1.5), all, law);
  FlightOptions options = flight_of("quad2kg", law);
  options.hover = options.settle = 0.2;
  const ReferenceTrack track(testing::line({0.01, 0, 0}, 0.5));
  const double none = prove_tube(track, options, {}, {}).largest;
  for (const auto one : {&Disturbances::place_noise, &Disturbances::velocity_noise,
                         &Disturbances::attitude_noise, &Disturbances::rate_noise}) {
    Disturbances d;
    d.*one = all.*one;
    const ProvedTube tube = prove_tube(track, options, d, {});
    ASSERT_FALSE(tube.trouble);
    EXPECT_GT(tube.largest, none * (1 + 1e-6));
  }
}

TEST(ProveTube, HoldsFlightsThatMisreadTheirSensors) {
  expect_noise({.gust_most = 0.1,  // with more, motors saturate
                .place_noise = 5e-5,
                .velocity_noise = 2e-4,
                .attitude_noise = 1e-4,
                .rate_noise = 1e-3},
               ControlLaw::geometric);
  expect_noise({.gust_most = 0.1,
                .place_noise = 1e-3,
                .velocity_noise = 1e-3,
                .attitude_noise = 1e-3,
                .rate_noise = 2e-3},
               ControlLaw::cascade);
}

// With noise such a tube is far too wide, because the readings of several runs have no symbols.
TEST(ProveTube, HoldsFlightsWhosePositionLoopIsTheFaster) {
  FlightOptions options = flight_of("quad2kg", ControlLaw::cascade);
  options.periods = {3, 4};
  const Trajectory hop = testing::line({0.2, 0.1, 0.1}, 1.5);
  const double exact = worst_share(hop, options, {.gust_most = 0.05});
  EXPECT_LE(exact, 1);
  EXPECT_GT(exact, 0.5);
  EXPECT_LE(worst_share(hop, options,
                        {.gust_most = 0.05,
                         .place_noise = 1e-5,
                         .velocity_noise = 5e-6,
                         .attitude_noise = 1e-5,
                         .rate_noise = 2e-5}),
            1);
}

// Gains that are not what the profile says: the tube grows, and holds the flights.
TEST(ProveTube, HoldsControllersWhoseGainsAreOff) {
  const Trajectory line = testing::line({2, 1, 1}, 3);
  for (const ControlLaw law : {ControlLaw::geometric, ControlLaw::cascade}) {
    const FlightOptions options = flight_of("quad2kg", law);
    const Disturbances d{.wind = {0.5, 0, 0}, .gust_most = 0.1};
    Disturbances off = d;
    off.gain_error = 0.01;
    EXPECT_LE(worst_share(line, options, off), 1);
    const ReferenceTrack track(line);
    EXPECT_GT(prove_tube(track, options, off, {}).largest,
              prove_tube(track, options, d, {}).largest * (1 + 1e-6));
  }
}

// Nothing is fed forward, so the vehicle stays behind by its speed over the position's gain.
TEST(ProveTube, HoldsAWeakPositionLoopThatStaysBehind) {
  FlightOptions options = flight_of("quad2kg", ControlLaw::cascade);
  options.gains.feed_forward = {0, 0, 0};
  State rest, fast, far;
  fast.position = {1.5, 0, 0};
  fast.velocity = far.velocity = {1, 0, 0};
  far.position = {17.5, 0, 0};
  const ReferenceTrack track({{hermite(rest, fast, 3), hermite(fast, far, 16)}});
  const Disturbances d{.gain_error = 0.01};
  const ProvedTube tube = prove_tube(track, options, d, {});
  ASSERT_FALSE(tube.trouble);
  testing::Fate weak;
  weak.gains = options.gains;
  weak.gains->position.p *= 0.99;
  const auto flight = testing::fly(track, options, d, weak);
  EXPECT_LE(testing::worst_share(tube, flight), 1);
  EXPECT_GT(testing::share_of(tube, 18000, flight.error[18000]), 0.97);
}

// A start that is off counts where hardly any hovering comes before, and is forgotten after much.
void expect_start(double off, ControlLaw law) {
  const Disturbances d{.gust_most = 0.2, .start_error = off, .start_speed = off};
  expect_inside("quad2kg", testing::line({2, 1, 0}, 2), d, law);
  FlightOptions options = flight_of("quad2kg", law);
  const ReferenceTrack track(testing::line({2, 1, 0}, 2));
  const auto at_first = [&](double hover, const Disturbances& disturbances) {
    options.hover = hover;
    const ProvedTube tube = prove_tube(track, options, disturbances, {});
    EXPECT_FALSE(tube.trouble);
    return tube.trouble ? NAN : tube.radius[0];
  };
  EXPECT_GE(at_first(0.004, d), off);
  EXPECT_LT(at_first(0.004, d), at_first(0.004, {.gust_most = 0.2}) + 1.5 * off);
  EXPECT_LT(at_first(4, d), at_first(4, {.gust_most = 0.2}) + 0.3 * off);
}

TEST(ProveTube, HoldsFlightsThatBeginOff) {
  expect_start(0.001, ControlLaw::geometric);  // with more, motors saturate
  expect_start(0.05, ControlLaw::cascade);
  FlightOptions options = flight_of("quad2kg");
  const ReferenceTrack track(testing::line({2, 1, 0}, 2));
  testing::Fate fate;
  fate.place = {0.01, 0, 0};
  EXPECT_TRUE(testing::fly(track, options, {}, fate).saturated);
  EXPECT_TRUE(prove_tube(track, options, {.start_error = 0.01}, {}).trouble);
}

TEST(ProveTube, HoldsFlightsUnderTheCascade) {
  expect_inside("quad2kg", testing::line({6, 3, 2}, 6),
                {.wind = {1, -1, 0}, .wind_spread = 0.2, .gust_most = 0.5, .mass_error = 0.005},
                ControlLaw::cascade);
  expect_inside("crazyflie", testing::line({1, 1, 0.5}, 4),
                {.wind_spread = 0.02, .gust_most = 0.1, .gust_lag = 0.5, .mass_error = 0.002},
                ControlLaw::cascade);
  expect_inside("tello", testing::line({1, 1, 0.5}, 4), {.gust_most = 0.05, .mass_error = 1e-4},
                ControlLaw::cascade);
}

// The reference jumps to a speed when the trajectory begins.
TEST(ProveTube, HoldsATrajectoryThatBeginsMoving) {
  State a, b;
  a.velocity = {0.004, 0, 0};
  b.position = {2, 1, 0};
  expect_inside("quad2kg", {{hermite(a, b, 4)}}, {.gust_most = 0.3});
  expect_inside("quad2kg", {{hermite(a, b, 4)}}, {.gust_most = 0.3}, ControlLaw::cascade);
}

// The equations leave the simulator's where its steps are coarse: there is no radius then.
TEST(ProveTube, IsHeldAgainstTheSimulator) {
  const ReferenceTrack track(testing::line({4, 1, 0}, 4));
  for (const double lag : {0.01, 0.005, 0.002, 0.001}) {
    FlightOptions options = flight_of("quad2kg");
    options.quadrotor.motor_time_constant = lag;
    options.gains = nominal_gains(options.quadrotor, 0.6);
    const ProvedTube tube = prove_tube(track, options, {.gust_most = 0.02}, {});
    EXPECT_EQ(tube.trouble.has_value(), lag < 0.004) << lag;
    if (tube.trouble) continue;
    const Flight flight = simulate(track, options, {});
    EXPECT_EQ(flight.saturated, 0);
    for (std::size_t k = 0; k < flight.error.size(); ++k) {
      EXPECT_LE(flight.error[k], tube.radius[std::min(k / 10, tube.radius.size() - 1)]);
    }
  }
}

// Nothing pushes the vehicle, so the radius is what the slack of each period adds up to; the slack
// of angular accelerations is a tenth of that and more, but for quad2kg's stiff geometric gains.
TEST(ProveTube, HasRoomForWhatTheSimulatorDiffersBy) {
  const State there;
  const ReferenceTrack track({{hermite(there, there, 1)}});
  const auto radius = [&](std::string_view vehicle, ControlLaw law) {
    FlightOptions options = flight_of(vehicle, law);
    options.hover = 2;
    options.settle = 0.5;
    const ProvedTube tube = prove_tube(track, options, {}, {1});
    return tube.trouble ? NAN : tube.radius.back();
  };
  EXPECT_GT(radius("quad2kg", ControlLaw::geometric), 1.5e-8);
  EXPECT_GT(radius("crazyflie", ControlLaw::geometric), 1.62e-6);
  EXPECT_GT(radius("quad2kg", ControlLaw::cascade), 3.4e-6);
  EXPECT_GT(radius("crazyflie", ControlLaw::cascade), 6e-6);
}

// Whatever is asked for, a number is never a wrong one.
TEST(ProveTube, GivesNoRadiusForExtremes) {
  const ReferenceTrack track(testing::line({2, 1, 0}, 2));
  for (const ControlLaw law : {ControlLaw::geometric, ControlLaw::cascade}) {
    FlightOptions options = flight_of("quad2kg", law);
    options.hover = 0.05;
    for (const double gust : {1e1, 1e3, 1e100, 1e300}) {
      EXPECT_TRUE(prove_tube(track, options, {.gust_most = gust}, {}, {1}).trouble) << gust;
      EXPECT_TRUE(prove_tube(track, options, {.wind_spread = gust}, {}, {1}).trouble) << gust;
      EXPECT_TRUE(prove_tube(track, options, {.wind = {gust * 10, 0, 0}}, {}, {1}).trouble) << gust;
    }
    EXPECT_TRUE(prove_tube(track, options, {.mass_error = 0.5}, {}, {1}).trouble);
  }
}

// A limit that is lowered until something is clipped: where the proof finds room, no flight is
// clipped, and where there is none, it names the limit.
void expect_clip(TubeTrouble::Kind kind, const std::function<void(FlightOptions&, double)>& limit,
                 std::vector<double> values) {
  const ReferenceTrack track(testing::line({4, 2, 1}, 3));
  const Disturbances d{.wind_spread = 0.05, .gust_most = 0.1};
  support::Random random(9);
  int proved = 0;
  int named = 0;
  for (const double value : values) {
    FlightOptions options = flight_of("quad2kg", ControlLaw::cascade);
    limit(options, value);
    const ProvedTube tube = prove_tube(track, options, d, {}, {1});
    if (tube.trouble) {
      EXPECT_EQ(tube.trouble->kind, kind) << value;
      EXPECT_LE(tube.trouble->room, 0);
      EXPECT_GT(tube.trouble->time, -0.6);
      EXPECT_LT(tube.trouble->time, 3.4);
      ++named;
      continue;
    }
    ++proved;
    testing::Fates fates(options, d, track.duration());
    for (int k = 0; k < 6; ++k) {
      const auto fate = fates.drawn(random, k % 3);
      EXPECT_FALSE(testing::fly(track, options, d, fate).saturated) << value;
    }
  }
  EXPECT_GT(proved, 0) << "the limit is never far enough";
  EXPECT_GT(named, 0) << "the limit never bites";
}

TEST(ProveTube, SaysWhatTheCascadeMayClip) {
  using Kind = TubeTrouble::Kind;
  expect_clip(Kind::velocity, [](auto& o, double v) { o.gains.position.clip = v; }, {4, 2});
  expect_clip(Kind::acceleration, [](auto& o, double v) { o.gains.velocity.clip = v; }, {8, 2});
  expect_clip(Kind::lean, [](auto& o, double v) { o.gains.tilt_max = v; }, {0.7, 0.2});
  expect_clip(Kind::rates, [](auto& o, double v) { o.quadrotor.body_rate_max.setConstant(v); },
              {5, 0.5});
  expect_clip(Kind::turn, [](auto& o, double v) { o.gains.rates.clip = v; }, {60, 5});
  expect_clip(Kind::motor, [](auto& o, double v) { o.quadrotor.motor_most = v; }, {8, 5.8});
}

TEST(ProveTube, SaysWhenTheCascadeMayFallFreely) {
  const FlightOptions options = flight_of("quad2kg", ControlLaw::cascade);
  const ProvedTube tube =
      prove_tube(ReferenceTrack(testing::line({0, 0, -18}, 3)), options, {}, {}, {1});
  ASSERT_TRUE(tube.trouble);
  EXPECT_EQ(tube.trouble->kind, TubeTrouble::Kind::lift);
}

// Hovers with a heading of 0, then with another one.
Trajectory with_a_jump(double yaw) {
  Trajectory out{{hermite({}, {}, 0.5), hermite({}, {}, 0.5)}};
  for (Segment& s : out.segments) {
    s.yaw.emplace();
    s.yaw->fill(&s == &out.segments.back() ? yaw : 0);
  }
  return out;
}

// The sine of an angle is that of another one, too: a loop that turns too weakly for its motors to
// saturate has no proof for a jump by more than a right angle.
TEST(ProveTube, IsNotMisledByAHeadingThatJumps) {
  for (const ControlLaw law : {ControlLaw::geometric, ControlLaw::cascade}) {
    FlightOptions options = flight_of("quad2kg", law);
    Gains& gains = options.gains;
    gains.geometric.attitude.z() *= 0.01;
    gains.geometric.rates.z() *= 0.1;
    gains.attitude.z() *= 0.1;
    const ProvedTube less = prove_tube(ReferenceTrack(with_a_jump(1.4)), options, {}, {}, {1});
    EXPECT_FALSE(less.trouble);
    const ProvedTube more = prove_tube(ReferenceTrack(with_a_jump(1.7)), options, {}, {}, {1});
    ASSERT_TRUE(more.trouble);
    EXPECT_EQ(more.trouble->kind, TubeTrouble::Kind::tilt);
  }
}

// Without disturbances it is the nominal flight's own error.
TEST(ProveTube, IsTightWhereNothingIsUnknown) {
  for (const ControlLaw law : {ControlLaw::geometric, ControlLaw::cascade}) {
    const FlightOptions options = flight_of("quad2kg", law);
    const ReferenceTrack track(testing::line({6, 3, 2}, 4));
    const ProvedTube tube = prove_tube(track, options, {}, {});
    ASSERT_FALSE(tube.trouble);
    const Flight flight = simulate(track, options, {});
    EXPECT_NEAR(tube.largest, *std::max_element(flight.error.begin(), flight.error.end()), 3e-4);
    EXPECT_EQ(tube.cells, 1u);
  }
}

// The velocity loop's integral takes a constant wind away.
TEST(ProveTube, KnowsThatTheCascadeTurnsAgainstAConstantWind) {
  FlightOptions options = flight_of("quad2kg", ControlLaw::cascade);
  options.hover = 0.01;
  options.settle = 1;
  const ReferenceTrack track(testing::line({0.1, 0, 0}, 11));
  const ProvedTube tube = prove_tube(track, options, {.wind_spread = 0.5}, {});
  ASSERT_FALSE(tube.trouble);
  EXPECT_GT(tube.largest, 0.02);
  EXPECT_LT(tube.radius.back(), 0.5 * tube.largest);
}

TEST(ProveTube, SaysWhyThereIsNone) {
  const ReferenceTrack track(testing::line({6, 3, 2}, 4));
  const ProvedTube gusty = prove_tube(track, flight_of("quad2kg"), {.gust_most = 8}, {});
  ASSERT_TRUE(gusty.trouble);
  EXPECT_TRUE(gusty.radius.empty());
  const ProvedTube lively = prove_tube(track, flight_of("tello"), {.gust_most = 0.3}, {});
  ASSERT_TRUE(lively.trouble);
  EXPECT_LT(lively.damping, 0.1) << "Tello's tuned gains hardly damp";
  FlightOptions wild = flight_of("quad2kg");
  wild.gains.geometric.rates *= -1;
  wild.gains.attitude *= -1;
  for (const ControlLaw law : {ControlLaw::geometric, ControlLaw::cascade}) {
    wild.law = law;
    const ProvedTube unstable = prove_tube(track, wild, {.gust_most = 0.1}, {});
    ASSERT_TRUE(unstable.trouble);
    EXPECT_EQ(unstable.trouble->kind, TubeTrouble::Kind::unstable);
  }
  FlightOptions weak = flight_of("quad2kg");
  weak.quadrotor.motor_most = 5;
  const ProvedTube saturated =
      prove_tube(ReferenceTrack(testing::line({0, 0, 9}, 2)), weak, {}, {});
  ASSERT_TRUE(saturated.trouble);
  EXPECT_EQ(saturated.trouble->kind, TubeTrouble::Kind::motor);
  EXPECT_LE(saturated.trouble->room, 0);
}

// At rest the motors would hold the true weight. The simulator clips what they cannot.
TEST(ProveTube, KnowsThatMotorsMustHoldTheWeightAtRest) {
  FlightOptions options = flight_of("quad2kg");
  options.hover = 0.001;
  options.settle = 0;
  const double weight = options.quadrotor.mass * geom::kGravity / 4;
  options.quadrotor.motor_most = 1.05 * weight;
  const ReferenceTrack track(testing::line({0, 0, 0}, 0.002));
  EXPECT_FALSE(prove_tube(track, options, {.mass_error = 0.001}, {}, {1}).trouble);
  const ProvedTube heavy = prove_tube(track, options, {.mass_error = 0.06}, {}, {1});
  ASSERT_TRUE(heavy.trouble);
  EXPECT_EQ(heavy.trouble->kind, TubeTrouble::Kind::motor);
  EXPECT_NEAR(heavy.trouble->room, -0.01 * weight, 1e-9);
}

// The first period of the attitude loop may begin before the trajectory and end in it.
TEST(ProveTube, HoldsTheFirstStepsWhereAPeriodBeginsBeforeThem) {
  State a, b;
  a.velocity = b.velocity = {0.004, 0, 0};
  b.position = {8e-6, 0, 0};
  const ReferenceTrack track({{hermite(a, b, 0.002)}});
  FlightOptions options = flight_of("quad2kg");
  options.hover = 0.001;
  options.settle = 0;
  const ProvedTube tube = prove_tube(track, options, {}, {});
  ASSERT_FALSE(tube.trouble);
  const Flight flight = simulate(track, options, {.path = true});
  EXPECT_EQ(flight.path.size(), 3u);
  std::size_t cursor = 0;
  for (std::size_t n = 0; n < flight.path.size(); ++n) {
    const Vec3 wanted = track.at(static_cast<double>(n) * kStep, cursor).position;
    EXPECT_LE((flight.path[n] - wanted).norm(), tube.radius[0]) << n;
  }
}

TEST(ProveTube, ProvesCellsOneByOneAndTheSameOnAnyThreads) {
  FlightOptions options = flight_of("quad2kg");
  options.hover = options.settle = 0.1;
  const ReferenceTrack track(testing::line({0.5, 0.2, 0}, 1.5));
  const Disturbances d{.wind = {-3, -1, 0}, .wind_spread = 2.5, .gust_most = 0.05};
  const ProvedTube one = prove_tube(track, options, d, {.threads = 1});
  const ProvedTube three = prove_tube(track, options, d, {.threads = 3});
  ASSERT_FALSE(one.trouble);
  EXPECT_GT(one.cells, 1u);
  EXPECT_EQ(one.radius, three.radius);
  support::Random random(6);
  testing::Fates fates(options, d, track.duration());
  double worst = 0;
  for (int k = 0; k < 30; ++k) {
    const auto fate = fates.drawn(random, k % 3);
    worst = std::max(worst, testing::worst_share(one, testing::fly(track, options, d, fate)));
  }
  EXPECT_LE(worst, 1);
  const ProvedTube none = prove_tube(track, options, d, {}, {.most_cells = 1});
  EXPECT_TRUE(none.trouble);
}

}  // namespace
}  // namespace traj
