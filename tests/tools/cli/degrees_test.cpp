#include "cli/option/degrees.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"

namespace cli {
namespace {

using geom::Vec3;

geom::Frame city() {
  geom::Frame frame;
  frame.origin = geom::GeodeticOrigin{37.7925, -122.3974, 0};
  return frame;
}

TEST(MetresOption, RefusesAFlightLogInDegrees) {
  traj::FlightLog flight;
  flight.samples.resize(2);
  flight.samples[0].position = {37.793, -122.397, 5};
  flight.samples[1].position = {37.794, -122.396, 5};
  EXPECT_THROW(MetresOption().check_input(city(), flight, "log.csv", 0), geom::InputError);
  flight.samples[1].position = {12, -122.396, 5};
  EXPECT_NO_THROW(MetresOption().check_input(city(), flight, "log.csv", 0));
}

TEST(EndsInMetres, LeavesOutThoseThatWereGivenInDegrees) {
  geom::PlanQuery query;
  query.from = {1, 2, 3};
  query.to = {4, 5, 6};
  EXPECT_EQ(ends_in_metres(query).size(), 2u);
  query.from_on_earth = true;
  ASSERT_EQ(ends_in_metres(query).size(), 1u);
  EXPECT_EQ(ends_in_metres(query).front(), Vec3(4, 5, 6));
}

}  // namespace
}  // namespace cli
