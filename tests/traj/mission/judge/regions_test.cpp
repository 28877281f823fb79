#include "traj/mission/judge/regions.h"

#include <gtest/gtest.h>

#include "traj/scenes.h"

namespace traj {
namespace {

using testing::scene_of;

geom::CollisionScene block() {
  const geom::Vehicle vehicle{"box", Vec3(0.5, 0.5, 0.3)};
  return {scene_of({{{10, 10, 0}, {20, 20, 50}}}).map(), vehicle, 0};
}

Sweep sweep(std::vector<Vec3> hull) { return {std::move(hull), {7, Manoeuvre::corner}}; }

CheckResult checked(const std::vector<Sweep>& sweeps, const Vec3& stray = Vec3::Zero()) {
  CheckResult result;
  result.ok = true;
  check_sweeps(block(), sweeps, stray, result);
  return result;
}

TEST(CheckSweeps, FindsWhatLiesInsideATriangle) {
  const double half = block().half().x();
  EXPECT_TRUE(checked({sweep({{-30, 0, 20}, {0, 0, 20}, {0, 60, 20}})}).ok);
  const std::vector<Vec3> around = {{-40, -40, 20}, {100, -40, 20}, {-40, 100, 20}};
  const CheckResult result = checked({sweep(around)});
  EXPECT_EQ(result.reason, Reason::collision) << "no edge meets the block, but its middle does";
  EXPECT_EQ(result.part, (FlightPart{7, Manoeuvre::corner}));
  EXPECT_EQ(result.box, 0u);
  EXPECT_NEAR(result.worst, 5 + half, 1e-6);
  EXPECT_NEAR(result.place.z(), 20, 1e-9);
}

TEST(CheckSweeps, KeepsClearOfAllThatIsBesideThem) {
  const double half = block().half().x();
  const std::vector<Vec3> beside = {{9 - half, 0, 20}, {9 - half, 40, 20}, {-30, 0, 20}};
  EXPECT_TRUE(checked({sweep(beside)}).ok);
  EXPECT_TRUE(checked({sweep(beside)}, Vec3(0.999, 0, 0)).ok);
  EXPECT_EQ(checked({sweep(beside)}, Vec3(1, 0, 0)).reason, Reason::collision);
}

TEST(CheckSweeps, StayInsideTheBounds) {
  const geom::CollisionScene scene = block();
  const Vec3 corner = scene.free_bounds()->max;
  const CheckResult result =
      checked({sweep({{0, 0, 20}}), sweep({corner + Vec3(2, 0, 0), {0, 0, 20}})});
  EXPECT_EQ(result.reason, Reason::bounds);
  EXPECT_NEAR(result.worst, 2, 1e-9);
  EXPECT_EQ(checked({sweep({corner})}, Vec3(0.1, 0.1, 0.1)).reason, Reason::bounds);
}

CheckResult fenced(const std::vector<Vec3>& hull, const Fence& fence) {
  CheckResult result;
  result.ok = true;
  check_fences(block(), std::vector<Sweep>{sweep(hull)}, std::vector<Fence>{fence}, Vec3::Zero(),
               result);
  return result;
}

// An L.
const std::vector<geom::Vec2> kRing = {{-60, -60}, {-20, -60}, {-20, -30},
                                       {0, -30},   {0, 0},     {-60, 0}};

TEST(CheckFences, KeepTheWholeVehicleOnItsSide) {
  const double half = block().half().x();
  const Fence in{true, kRing, 0};
  const Fence out{false, kRing, 0};
  EXPECT_TRUE(fenced({{-50, -50, 9}, {-50, -10, 9}, {-30, -10, 9}}, in).ok);
  EXPECT_FALSE(fenced({{-50, -50, 9}, {-50, -10, 9}, {-30, -10, 9}}, out).ok);
  EXPECT_FALSE(fenced({{-30, -50, 9}, {-5, -20, 9}}, in).ok) << "across the corner of the L";
  EXPECT_TRUE(fenced({{-10, -50, 9}, {-12, -40, 9}}, out).ok) << "in its notch";
  EXPECT_TRUE(fenced({{-10, -29.99 + half, 9}}, in).ok);
  EXPECT_FALSE(fenced({{-10, -30.01 + half, 9}}, in).ok) << "the vehicle's side is out";
  const CheckResult result = fenced({{-50, -50, 9}, {-50, 7, 9}}, in);
  EXPECT_EQ(result.reason, Reason::fence);
  EXPECT_NEAR(result.worst, 7, 1e-9);
  EXPECT_EQ(result.part, (FlightPart{7, Manoeuvre::corner}));
}

TEST(CheckFences, HoldAllAroundAndEdgesThatBend) {
  const std::vector<Vec3> around = {{-300, -300, 9}, {300, -300, 9}, {0, 300, 9}};
  EXPECT_FALSE(fenced(around, {false, kRing, 0}).ok) << "the fence lies inside the region";
  const double half = block().half().x();
  EXPECT_TRUE(fenced({{0.5 + half, -10, 9}}, {false, kRing, 0}).ok);
  EXPECT_FALSE(fenced({{0.5 + half, -10, 9}}, {false, kRing, 0.6}).ok);
}

}  // namespace
}  // namespace traj
