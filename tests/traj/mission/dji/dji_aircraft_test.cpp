#include "traj/mission/dji/dji_aircraft.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "traj/flight/vehicle_profile.h"

namespace traj {
namespace {

TEST(DjiAircraft, IsAVehicleThatIsKnownByNameIfItsAirframeIs) {
  for (const DjiAirframe& airframe : kDjiAirframes) {
    const auto profile = vehicle_named(airframe.vehicle);
    ASSERT_TRUE(profile) << airframe.vehicle;
    EXPECT_EQ(airframe_of({airframe.type, 9}), &airframe);
    EXPECT_EQ(vehicle_of({airframe.type, 9}), airframe.vehicle) << "of a kind without a name";
    // Or a check would refuse every mission that is faster than the aircraft climbs.
    const double most = *profile->vehicle.limits[geom::Limit::vertical_speed];
    EXPECT_GE(most, std::max(airframe.climb, airframe.descent)) << airframe.vehicle;
  }
  for (const NamedDjiAircraft& known : kDjiAircraft) {
    EXPECT_EQ(vehicle_of(known.aircraft), known.name);
    ASSERT_TRUE(vehicle_named(known.name)) << known.name;
    ASSERT_TRUE(airframe_of(known.aircraft)) << known.name;
    EXPECT_EQ(vehicle_named(known.name)->vehicle.half,
              vehicle_named(airframe_of(known.aircraft)->vehicle)->vehicle.half)
        << known.name;
  }
  EXPECT_EQ(vehicle_of({60, 0}), "");
  EXPECT_FALSE(airframe_of({60, 0}));
}

}  // namespace
}  // namespace traj
