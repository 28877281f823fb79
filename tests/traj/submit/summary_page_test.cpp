#include "traj/submit/summary_page.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

bool says(const Submission& submission, const std::string& kind, const char* text) {
  const FlightClaims claims{.id = "q1", .kind = kind};
  return summary_page({}, submission, {&claims, 1}).find(text) != std::string::npos;
}

Submission compared(std::size_t pairs, std::size_t refused) {
  Submission out{.made_by = "skyway 1", .flights = 3};
  out.method.together = TogetherRule{.spacing = {.zone = cylinder(32, 7.5)}};
  out.pairs = FlightPairs{pairs, refused, {}};
  if (refused > 0) out.pairs->named = {{"a<1>", "b"}};
  return out;
}

constexpr const char* kNotCompared = "not compared with each other";

TEST(SummaryPage, SaysWhetherFlightsWereCompared) {
  EXPECT_TRUE(says({}, "trajectory", kNotCompared));
  EXPECT_FALSE(says(compared(3, 0), "trajectory", kNotCompared));
  EXPECT_TRUE(
      says(compared(3, 0), "trajectory", "keep apart from each other (3 pairs compared): 32 m"));
  EXPECT_TRUE(says(compared(3, 0), "mission", "Missions have no times, so they were not compared"));
}

TEST(SummaryPage, NamesFlightsThatComeTooNear) {
  EXPECT_TRUE(says(compared(3, 1), "trajectory", "1 of 3 pairs of trajectories come too near"));
  EXPECT_TRUE(says(compared(3, 1), "trajectory", "a&lt;1&gt; and b"));
  EXPECT_FALSE(says(compared(3, 1), "trajectory", "pairs.jsonl has all"));
  EXPECT_TRUE(says(compared(3, 2), "trajectory", "pairs.jsonl has all"));
  EXPECT_FALSE(says(compared(3, 1), "trajectory", "At every instant the trajectories keep apart"));
}

TEST(SummaryPage, SaysWhichSpacingWasAskedFor) {
  Submission touching = compared(1, 0);
  touching.method.together->spacing.zone.reset();
  EXPECT_TRUE(says(touching, "trajectory", "with their margins, never touch"));
  Submission downwash = compared(1, 0);
  downwash.method.together->spacing.downwash = cylinder(2, 9);
  downwash.method.together->parked = Parked::gone;
  EXPECT_TRUE(says(downwash, "trajectory", "within 2 m across and 9 m below another"));
  EXPECT_TRUE(says(downwash, "trajectory", "before and after its flight none is there"));
}

TEST(SummaryPage, ProvesOfNoMissionThatItsBatteryLasts) {
  Submission out;
  EXPECT_FALSE(says(out, "trajectory", "before the battery is down"));
  EXPECT_TRUE(says(out, "mission", "durations are estimates."));
  out.method.energy = Energy{1000, 100, 0.2, 0};
  EXPECT_TRUE(says(out, "trajectory", "Each trajectory ends before the battery is down"));
  EXPECT_FALSE(says(out, "mission", "before the battery is down"));
  EXPECT_TRUE(says(out, "mission", "estimates, by which the battery lasts to its reserve."));
}

TEST(SummaryPage, SaysWhereTheFlightGeographyIsSmallerThanTheGuidelineAsksFor) {
  const FlightClaims narrow{.id = "q1", .half = Vec3(0.5, 0.6, 0.4), .margin = 0.25};
  Submission out;
  out.method.risk.dimension = 0.5;
  const auto page = [&] { return summary_page({}, out, {&narrow, 1}); };
  EXPECT_NE(page().find("1.5 m wide and 1.3 m high. LBA's guideline asks for 3 CD (1.5 m), and "
                        "<strong>this is less</strong>"),
            std::string::npos);
  out.method.buffer = 0.1;
  EXPECT_NE(page().find("1.7 m wide and 1.5 m high. LBA's guideline asks for 3 CD (1.5 m)."),
            std::string::npos);
  out.method.tubes = SourceFile{};  // then the tube takes the place of the margin
  EXPECT_NE(page().find("1.2 m wide and 1 m high"), std::string::npos);
}

// A tube may be proved with noise.
TEST(SummaryPage, SaysOfReadingsWhatTheTubesWereProvedFor) {
  FlightClaims one{.id = "q1", .kind = "trajectory"};
  one.tube = TubeClaim{.kind = TubeKind::proved, .disturbances = Disturbances{}};
  Submission out;
  out.method.tubes = SourceFile{};
  const auto page = [&] { return summary_page({}, out, {&one, 1}); };
  EXPECT_NE(page().find("exact readings of the sensors"), std::string::npos);
  EXPECT_NE(page().find("gains and loop periods that skyway-fly was given"), std::string::npos);
  one.tube->disturbances->place_noise = 0.01;
  EXPECT_EQ(page().find("exact readings"), std::string::npos);
  EXPECT_NE(page().find("readings of the sensors within 0.01 m"), std::string::npos);
}

// A clearance is known to 1 mm. 0.4 people are not 0, and 99.999 % of the time is not all of it.
TEST(SummaryPage, RoundsToTheSafeSide) {
  FlightClaims one{.id = "q1", .kind = "trajectory"};
  one.clearance = 1.1705;
  one.top = 41.01;
  one.people = 0.4;
  one.returns = 0.999999;
  Submission out;
  out.population = SourceFile{};
  out.method.risk.contingency = ContingencyRule::ways_home;
  const std::string page = summary_page({}, out, {&one, 1});
  for (const char* cell : {">1.16<", ">41.1<", ">1<", ">99.99<", "99.99 % of the time has"}) {
    EXPECT_NE(page.find(cell), std::string::npos) << cell;
  }
}

}  // namespace
}  // namespace traj
