#include "traj/home/flight_contingencies.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "traj/home/home_case.h"

namespace traj {
namespace {

// A flight past a block, and the stream of its ways home.
struct Case : testing::FlightPastABlock {
  HomeFlight flight{.id = "q1", .stages = stages, .checked_hash = "aa"};
  std::string lines;

  Case() {
    const auto ways = ways_home(scene, flight.stages, task);
    for (const auto& record : contingency_records("q1", ways, task, {}, "aa")) {
      lines += to_json_line(record);
    }
  }
  FlightContingencies read() const {
    std::istringstream in(lines);
    return {in, "ways.jsonl", {.models = task.models}};
  }
};

TEST(FlightContingencies, AreProvedForTheirFlight) {
  const Case c;
  const CheckedContingencies checked = c.read().check(c.scene, c.flight, {});
  EXPECT_TRUE(checked.report.result.ok);
  EXPECT_FALSE(checked.report.exact) << "nobody asked";
  EXPECT_EQ(checked.certificate, "");
}

TEST(FlightContingencies, HaveACertificateWhereTheyHoldExactly) {
  const Case c;
  const CheckedContingencies checked = c.read().check(c.scene, c.flight, {.certificate = true});
  ASSERT_TRUE(checked.report.exact && checked.report.exact->ok);
  EXPECT_TRUE(checked.certificate.starts_with('{') && checked.certificate.ends_with('\n'));
}

TEST(FlightContingencies, OfAnotherFlightWithThisIdAreRefused) {
  Case c;
  EXPECT_NO_THROW(c.read().room_of(c.flight));
  c.flight.checked_hash = "bb";
  EXPECT_THROW(c.read().room_of(c.flight), geom::InputError);
}

TEST(FlightContingencies, OfAnotherFlightAreNoneOfThisOne) {
  Case c;
  c.flight.id = "q2";
  const CheckedContingencies checked = c.read().check(c.scene, c.flight, {.certificate = true});
  EXPECT_EQ(checked.report.result.reason, Reason::return_home);
  EXPECT_EQ(checked.certificate, "");
}

TEST(FlightContingencies, MustAllBeUsed) {
  const Case c;
  EXPECT_NO_THROW(c.read().require_used({"q1", "q2"}));
  EXPECT_THROW(c.read().require_used({"q2"}), geom::InputError);
}

TEST(FlightContingencies, NeedTheLargestMargin) {
  const Case c;
  HomeFlight flight = c.flight;
  flight.provenance.margin = 7;
  EXPECT_EQ(c.read().room_of(flight).margin, 7);
  flight.provenance.margin = 0;
  EXPECT_GE(*c.read().room_of(flight).margin, least_margin(c.task.models));
}

}  // namespace
}  // namespace traj
