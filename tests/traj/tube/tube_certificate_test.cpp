#include "traj/tube/tube_certificate.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "traj/flight/vehicle_profile.h"
#include "traj/flights.h"

namespace traj {
namespace {

FlightOptions quad(ControlLaw law = ControlLaw::geometric) {
  const auto profile = vehicle_named("quad2kg");
  FlightOptions options{.quadrotor = *quadrotor_of(profile->airframe)};
  options.gains = *profile->airframe.gains;
  options.law = law;
  options.hover = 0.2;
  options.settle = 0.1;
  return options;
}

const Disturbances kBreeze{
    .wind = {1, 0, 0}, .wind_spread = 0.1, .gust_most = 0.2, .mass_error = 0.002};

TEST(TubeCertificate, SaysForWhatATubeWasProved) {
  const ReferenceTrack track(testing::line({0.5, 0.2, 0}, 1.5));
  const FlightOptions options = quad();
  const ProvedTube tube = with_room(prove_tube(track, options, kBreeze, {}, {.by_spans = true}));
  ASSERT_FALSE(tube.trouble);
  Disturbances said = kBreeze;  // of ranges that are all different
  said.drag_error = 0.03, said.motor_lag_error = 0.04, said.inertia_error = 0.05;
  said.gain_error = 0.055;
  said.place_noise = 0.06, said.velocity_noise = 0.07;
  said.attitude_noise = 0.08, said.rate_noise = 0.09;
  const std::string line = tube_certificate_line("a", geom::Axes::neu, {options, said}, tube);
  EXPECT_EQ(line.back(), '\n');
  const nlohmann::json out = nlohmann::json::parse(line);
  EXPECT_EQ(out["id"], "a");
  EXPECT_EQ(out["frame"], "neu");
  EXPECT_EQ(out["vehicle"]["mass"], options.quadrotor.mass);
  EXPECT_EQ(out["gains"]["rates"][1], options.gains.geometric.rates.y());
  EXPECT_EQ(out["mass_error"], 0.002);
  EXPECT_EQ(out["drag_error"], 0.03);
  EXPECT_EQ(out["motor_lag_error"], 0.04);
  EXPECT_EQ(out["inertia_error"], 0.05);
  EXPECT_EQ(out["gain_error"], 0.055);
  EXPECT_EQ(out["place_noise"], 0.06);
  EXPECT_EQ(out["velocity_noise"], 0.07);
  EXPECT_EQ(out["attitude_noise"], 0.08);
  EXPECT_EQ(out["rate_noise"], 0.09);
  EXPECT_EQ(out["radius"].get<std::vector<double>>(), tube.radius);
  ASSERT_EQ(out["cells"].size(), tube.cells);
  const nlohmann::json& cell = out["cells"][0];
  ASSERT_EQ(cell["bounds"].size(), cell["periods"].size());
  int periods = 0;
  for (const auto& span : cell["periods"]) periods += span.get<int>();
  // 0.2 s + 1.5 s + 0.1 s in periods of 4 ms, and one for the last step.
  EXPECT_EQ(periods, 1800 / 4 + 1);
  for (const auto& span : cell["bounds"]) {
    ASSERT_EQ(span.size(), 25u);
    for (const double bound : span) EXPECT_GT(bound, 0);
  }
}

TEST(TubeCertificate, SaysWhichLimitsACascadeKeeps) {
  const ReferenceTrack track(testing::line({0.5, 0.2, 0}, 1.5));
  FlightOptions options = quad(ControlLaw::cascade);
  options.gains.velocity.clip = 8;
  const ProvedTube tube = with_room(prove_tube(track, options, kBreeze, {}, {.by_spans = true}));
  ASSERT_FALSE(tube.trouble);
  const nlohmann::json out =
      nlohmann::json::parse(tube_certificate_line("a", geom::Axes::enu, {options, kBreeze}, tube));
  EXPECT_EQ(out["controller"], "cascade");
  EXPECT_EQ(out["position_period_ms"], options.periods.position);
  EXPECT_EQ(out["vehicle"]["body_rate_max"][2], options.quadrotor.body_rate_max.z());
  const nlohmann::json& gains = out["gains"];
  EXPECT_EQ(gains["position"]["p"][0], options.gains.position.p.x());
  EXPECT_EQ(gains["velocity"]["clip"], 8);
  EXPECT_FALSE(gains["rates"].contains("clip")) << "it is never clipped";
  EXPECT_EQ(gains["tilt_max"], options.gains.tilt_max);
  int periods = 0;
  for (const auto& span : out["cells"][0]["periods"]) periods += span.get<int>();
  EXPECT_EQ(periods, 1800 / 4 + 1);
  for (const auto& span : out["cells"][0]["bounds"]) EXPECT_EQ(span.size(), 34u);
}

void expect_room_for_a_checker(const Disturbances& d) {
  const ReferenceTrack track(testing::line({0.5, 0.2, 0}, 1.5));
  for (const ControlLaw law : {ControlLaw::geometric, ControlLaw::cascade}) {
    const ProvedTube plain = prove_tube(track, quad(law), d, {});
    const ProvedTube spans = prove_tube(track, quad(law), d, {}, {.by_spans = true});
    ASSERT_FALSE(spans.trouble);
    const ProvedTube roomy = with_room(spans);
    ASSERT_EQ(roomy.radius.size(), plain.radius.size());
    for (std::size_t k = 0; k < plain.radius.size(); ++k) {
      EXPECT_GE(spans.radius[k], plain.radius[k])
          << "bounds of spans are not below those of periods";
      EXPECT_GE(roomy.radius[k], 1.015 * spans.radius[k]);
      EXPECT_LE(roomy.radius[k], 1.03 * plain.radius[k]);
    }
    EXPECT_EQ(roomy.largest, *std::max_element(roomy.radius.begin(), roomy.radius.end()));
    EXPECT_GT(roomy.tilt, spans.tilt);
  }
}

TEST(TubeCertificate, HasRoomForACheckerThatSumsOtherwise) { expect_room_for_a_checker(kBreeze); }

TEST(TubeCertificate, HasRoomWithNoiseToo) {
  Disturbances noisy = kBreeze;
  noisy.place_noise = 5e-5, noisy.velocity_noise = 2e-4;
  noisy.attitude_noise = 5e-5, noisy.rate_noise = 3e-4;
  expect_room_for_a_checker(noisy);
}

// How far above its hovering command a motor's limit must be for a proof.
double least_motor_room(ControlLaw law, bool by_spans) {
  FlightOptions options = quad(law);
  const ReferenceTrack hover(testing::line({0, 0, 0}, 0.1));
  const double each = options.quadrotor.mass * 9.80665 / 4;
  double less = 0;
  double enough = 0.02;  // N
  for (int k = 0; k < 11; ++k) {
    const double room = (less + enough) / 2;
    options.quadrotor.motor_most = each + room;
    const bool proved =
        !prove_tube(hover, options, {.gust_most = 0.2}, {}, {.most_cells = 1, .by_spans = by_spans})
             .trouble;
    (proved ? enough : less) = room;
  }
  return enough;
}

TEST(TubeCertificate, LeavesACheckerRoomAtLimits) {
  for (const ControlLaw law : {ControlLaw::geometric, ControlLaw::cascade}) {
    const double plain = least_motor_room(law, false);
    const double spans = least_motor_room(law, true);
    EXPECT_GT(spans, 1.045 * plain);
    EXPECT_LT(spans, 1.2 * plain);
  }
}

// Bounds are settled span by span, so the time for them grows like the flight: what comes later
// changes nothing.
TEST(TubeCertificate, HasBoundsThatWhatComesLaterDoesNotChange) {
  const ReferenceTrack track(testing::line({0.5, 0.2, 0}, 1.5));
  for (const ControlLaw law : {ControlLaw::geometric, ControlLaw::cascade}) {
    FlightOptions options = quad(law);
    const auto spans = [&](double settle) {
      options.settle = settle;
      return prove_tube(track, options, kBreeze, {}, {.by_spans = true}).proofs.at(0).spans;
    };
    const std::vector<SpanBounds> shorter = spans(0.1);
    const std::vector<SpanBounds> longer = spans(0.6);
    ASSERT_GT(longer.size(), shorter.size());
    for (std::size_t k = 0; k + 1 < shorter.size(); ++k) {  // the end cuts the last one
      EXPECT_EQ(shorter[k].periods, longer[k].periods);
      EXPECT_EQ(shorter[k].bounds, longer[k].bounds);
    }
  }
}

// Cells that fill what is asked for: a certificate without one of them would be refused.
TEST(TubeCertificate, NamesThePartsOfWindsAndMasses) {
  const ReferenceTrack track(testing::line({0, 0, 0}, 0.1));
  FlightOptions options = quad();
  options.hover = 0.1;
  options.settle = 0;
  const Disturbances wide{.wind_spread = 2.5, .gust_most = 0.05};
  const ProvedTube tube = prove_tube(track, options, wide, {}, {.by_spans = true});
  ASSERT_FALSE(tube.trouble);
  ASSERT_GT(tube.cells, 1u);
  double eighths = 0;
  for (const ProvedCell& cell : tube.proofs) {
    for (const int k : cell.part) EXPECT_LT(k, 8) << "the mass is not halved";
    eighths += std::pow(0.125, static_cast<double>(cell.part.size()));
  }
  EXPECT_LE(eighths, 1);
}

}  // namespace
}  // namespace traj
