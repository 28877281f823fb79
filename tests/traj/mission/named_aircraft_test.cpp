#include "traj/mission/named_aircraft.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "traj/flight/vehicle_profile.h"
#include "traj/mission/file_records.h"

namespace traj {
namespace {

geom::Vehicle box(const Vec3& half) { return {"box", half, {}}; }

const Vec3 kMavic = vehicle_named("m3t")->vehicle.half;

FileFlight file_for(std::string_view aircraft) {
  FlownLegs legs;
  legs.path = {{0, 0, 5}, {9, 0, 5}};
  return {"f1", mission_format_named("dji-wpml"), {legs}, {}, aircraft};
}

TEST(NamedAircraft, HasNoRoomInASmallerBoxOnAnySide) {
  EXPECT_EQ(why_too_small(box(kMavic), "m3t"), "");
  EXPECT_EQ(why_too_small(box({2, 2, 2}), "m3t"), "");
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 half(2, 2, 2);
    half[axis] = 0.99 * kMavic[axis];
    EXPECT_NE(why_too_small(box(half), "m3t"), "") << axis;
  }
  EXPECT_NE(why_too_small(vehicle_named("mini2")->vehicle, "m3e"), "");
}

TEST(NamedAircraft, IsNoneWhereNoneIsKnown) {
  EXPECT_EQ(why_too_small(box({0.1, 0.1, 0.1}), ""), "");
  EXPECT_FALSE(made_for(file_for(""), {}).vehicle);
}

TEST(NamedAircraft, IsWhatRecordsOfItsFileAreMadeFor) {
  const auto record = path_record(file_for("m3t"), {});
  ASSERT_TRUE(record->provenance.vehicle);
  EXPECT_EQ(record->provenance.vehicle->half, kMavic);
  const geom::Provenance larger{.vehicle = box({2, 2, 2})};
  EXPECT_EQ(path_record(file_for("m3t"), larger)->provenance.vehicle->half, Vec3(2, 2, 2));
  const geom::Provenance smaller{.vehicle = box({2, 2, 0.1})};
  EXPECT_THROW(path_record(file_for("m3t"), smaller), geom::InputError);
}

}  // namespace
}  // namespace traj
