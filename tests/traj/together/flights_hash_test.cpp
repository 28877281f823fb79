#include "traj/together/flights_hash.h"

#include <gtest/gtest.h>

#include <cmath>

namespace traj {
namespace {

Trajectory flight(double length) {
  const State from;
  State to;
  to.position = {length, 0, 30};
  return {{hermite(from, to, 8), hermite(to, from, 8)}};
}

class FlightsHash : public testing::Test {
 protected:
  std::string hash() const { return flights_hash(ids, flights, epoch); }

  Trajectory a = flight(10);
  Trajectory b = flight(20);
  std::vector<std::string> ids = {"a", "b"};
  std::vector<TimedFlight> flights = {{&a, 5, {1, 1, 1}}, {&b, 6, {1, 1, 1}}};
  std::optional<std::string> epoch = "2026-05-04T06:30:00Z";
  const std::string first = hash();
};

TEST_F(FlightsHash, DoesNotHangOnTheOrderOfTheStream) {
  std::swap(ids[0], ids[1]);
  EXPECT_NE(hash(), first);  // each flies what the other did
  std::swap(flights[0], flights[1]);
  EXPECT_EQ(hash(), first);
}

TEST_F(FlightsHash, ChangesWithAnythingThatIsFlown) {
  flights[1].start = std::nextafter(6, 7);
  EXPECT_NE(hash(), first);
  flights[1].start = 6;
  ids[1] = "c";
  EXPECT_NE(hash(), first);
  ids[1] = "b";
  epoch.reset();
  EXPECT_NE(hash(), first);
  epoch = "2026-05-04T06:30:00Z";
  b.segments[1].duration = 8.5;
  EXPECT_NE(hash(), first);
  b.segments[1].duration = 8;
  b.segments[0].point[3].y() = 1e-300;
  EXPECT_NE(hash(), first);
  b.segments[0].point[3].y() = 0;
  EXPECT_EQ(hash(), first);
}

TEST_F(FlightsHash, ChangesWhereASegmentGoesToTheNextFlight) {
  b.segments.push_back(a.segments.back());
  a.segments.pop_back();
  EXPECT_NE(hash(), first);
}

}  // namespace
}  // namespace traj
