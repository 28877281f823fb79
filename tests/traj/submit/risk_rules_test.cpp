#include "traj/submit/risk_rules.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

constexpr double kG = 9.80665;

TEST(RiskRules, TheStopIsTheFormula) {
  const traj::RiskRules rules{.dimension = 0.7};
  for (const double v : {0.0, 3.0, 12.0, 25.0}) {
    const traj::ContingencySize size = traj::contingency_size(rules, v);
    const double across = 7 + v + v * v / (2 * kG * std::tan(rules.tilt));
    const double vertical = 4 + v * std::sqrt(0.5) + v * v / (2 * kG);
    EXPECT_GE(size.across, across * (1 - 1e-15));
    EXPECT_NEAR(size.across, across, 1e-9 * across);
    EXPECT_GE(size.vertical, vertical);
    EXPECT_NEAR(size.vertical, vertical, 1e-4 * v + 1e-9);
  }
}

TEST(RiskRules, WaysHomeTakeNothingBeyondTheirVolumes) {
  const traj::RiskRules rules{.contingency = traj::ContingencyRule::ways_home};
  EXPECT_EQ(traj::contingency_size(rules, 12).across, 0);
}

TEST(RiskRules, TheBufferIsAsWideAsHighOrAsFarAsItFalls) {
  traj::RiskRules rules{.dimension = 1};
  EXPECT_EQ(traj::ground_buffer(rules, 12, 60), 60.5);
  rules.buffer = traj::BufferRule::ballistic;
  const double falls = 12 * std::sqrt(2 * 60 / kG) + 0.5;
  EXPECT_GE(traj::ground_buffer(rules, 12, 60), falls);
  EXPECT_NEAR(traj::ground_buffer(rules, 12, 60), falls, 1e-9);
  EXPECT_EQ(traj::ground_buffer(rules, 12, 0), 0.5 * (1 + 1e-12));
}

double decimetres_up(double metres) { return std::ceil(metres * 10 - 1e-9) / 10; }

// BBK and LBA, standard scenarios STS-BOS 1.0 (June 2025), notes, tables 1 and 2: multirotors of at
// most 1.5 m, m from the flight geography to the edges of contingency volume and of what is
// around it, for heights of flight of 30, 50, 70, 100 and 120 m.
TEST(RiskRules, GiveTheDistancesThatAnAuthorityPublished) {
  const traj::RiskRules rules{.buffer = traj::BufferRule::ballistic,
                              .dimension = 1.5,
                              .altitude_error = 1,
                              .tilt = 0.5235987755982988};
  constexpr double kHeights[] = {30, 50, 70, 100, 120};
  constexpr struct {
    double speed, contingency, buffers[5];
  } kPublished[] = {{12, 31.8, {37.9, 45.1, 51.3, 59.4, 64.2}},
                    {4, 12.5, {11.4, 14.2, 16.4, 19.3, 21.0}}};
  for (const auto& row : kPublished) {
    const traj::ContingencySize size = traj::contingency_size(rules, row.speed);
    EXPECT_DOUBLE_EQ(decimetres_up(size.across), row.contingency);
    for (int i = 0; i < 5; ++i) {
      EXPECT_DOUBLE_EQ(
          decimetres_up(traj::ground_buffer(rules, row.speed, kHeights[i] + size.vertical)),
          row.buffers[i])
          << row.speed << " m/s, " << kHeights[i] << " m";
    }
  }
}

TEST(RiskRules, NameTheFormulasThatTheyUse) {
  traj::RiskRules rules;
  EXPECT_EQ(traj::formulas(rules).size(), 4u);
  rules.contingency = traj::ContingencyRule::ways_home;
  EXPECT_EQ(traj::formulas(rules).size(), 3u);
  for (const traj::RiskFormula& one : traj::formulas(rules)) EXPECT_FALSE(one.source.empty());
}

}  // namespace
