#include "traj/record/solve_in_tube.h"

#include <gtest/gtest.h>

#include "geom/record/scenes.h"
#include "traj/curve/trajectory_hash.h"
#include "traj/flight/tilted_radius.h"
#include "traj/scenes.h"

namespace traj {
namespace {

// A wall along y, and a way that touches it and turns away.
const geom::BoxMap& map() {
  static const auto scene = testing::scene_of({{Vec3(-0.5, -50, 0), Vec3(0.5, 0, 50)}});
  return scene.map();
}

TubeTask quad() {
  TubeTask task;
  task.profile = *vehicle_named("quad2kg");
  task.flight = {.quadrotor = *quadrotor_of(task.profile.airframe)};
  task.flight.gains = *task.profile.airframe.gains;
  task.flight.law = ControlLaw::geometric;
  task.flight.hover = 0.1;
  task.flight.settle = 0.1;
  task.disturbances = {.wind = {1, 0, 0}, .wind_spread = 0.1, .gust_most = 0.3};
  task.solve.limits = task.profile.vehicle.limits;
  task.solve.limits[Limit::speed] = 5;
  task.solve.limits[Limit::acceleration] = 3;
  task.solve.solver = Solver::stop_and_go;
  return task;
}

// It touches the wall, grown by the vehicle and the margin, in its bend.
geom::PathRecord way(const TubeTask& task, double margin) {
  const Vec3 room = task.profile.vehicle.half + Vec3::Constant(margin + 1e-9);
  geom::PathRecord path{.id = "a", .status = geom::PathStatus::found};
  path.points = {Vec3(-2, -6, 10), Vec3(-0.5 - room.x(), -5, 10), Vec3(-2, -4, 10)};
  path.provenance = {.frame = geom::Axes::enu, .vehicle = task.profile.vehicle, .margin = margin};
  return path;
}

std::shared_ptr<const geom::CollisionScene> scene(const TubeTask& task, double margin) {
  return std::make_shared<geom::CollisionScene>(map(), task.profile.vehicle, margin);
}

TubeSolved solved(const TubeTask& task, double margin, bool replans = true) {
  TubeRooms rooms{[&](double m) { return scene(task, m); }, {}};
  if (replans) rooms.path = [&](const geom::CollisionScene& in) { return way(task, in.margin()); };
  return solve_in_tube(task, way(task, margin), rooms, {});
}

// The tube of another round would not be the one of this trajectory.
void expect_its_own_tube(const TubeTask& task, const TubeSolved& out) {
  const Trajectory& trajectory = out.solved.record.trajectory;
  EXPECT_EQ(out.report.trajectory, trajectory_hash(trajectory));
  const ProvedTube again =
      prove_tube(ReferenceTrack(trajectory), task.flight, task.disturbances, {});
  EXPECT_EQ(out.report.proved.radius, again.radius);
  EXPECT_EQ(out.report.proved.tilt, again.tilt);
  const auto radius =
      tilted_radius(again.radius, again.tilt, task.profile.vehicle, task.profile.body);
  EXPECT_TRUE(check_tube(*scene(task, 0), trajectory, radius, kTubePeriod).clear);
  EXPECT_TRUE(accepted(out.report));
}

TEST(SolveInTube, KeepsTheTubeOfTheResultAsMargin) {
  const TubeTask task = quad();
  const TubeSolved out = solved(task, 0);
  ASSERT_EQ(out.why, "");
  ASSERT_GE(out.rounds.size(), 2u) << "the first path touches";
  EXPECT_FALSE(out.rounds.front().clear);
  EXPECT_TRUE(out.rounds.back().clear);
  EXPECT_TRUE(out.rounds.back().is_new);
  EXPECT_GT(out.rounds.back().margin, out.rounds.front().largest);
  EXPECT_EQ(*out.solved.record.provenance.margin, out.rounds.back().margin);
  EXPECT_EQ(out.solved.record.status, TrajectoryStatus::solved);
  expect_its_own_tube(task, out);
  EXPECT_NE(in_words(out.rounds).find("round 2: "), std::string::npos);
}

TEST(SolveInTube, IsOneRoundWhereTheMarginIsWideEnough) {
  const TubeTask task = quad();
  const TubeSolved out = solved(task, 0.3);
  ASSERT_EQ(out.why, "");
  ASSERT_EQ(out.rounds.size(), 1u);
  EXPECT_LT(out.rounds[0].largest, 0.3);
  EXPECT_EQ(*out.solved.record.provenance.margin, 0.3);
  expect_its_own_tube(task, out);
}

// Wider and wider tubes must not end in one that is not of the result.
TEST(SolveInTube, GivesUpAfterSomeRounds) {
  const TubeTask task = quad();
  const TubeRooms rooms{[&](double) { return scene(task, 0); }, {}};  // nobody keeps a margin
  const TubeSolved out = solve_in_tube(task, way(task, 0), rooms, {});
  EXPECT_EQ(out.rounds.size(), static_cast<std::size_t>(kMostTubeRounds));
  EXPECT_NE(out.why.find("no tube was clear after 6 rounds"), std::string::npos) << out.why;
  EXPECT_EQ(out.solved.record.status, TrajectoryStatus::infeasible);
  EXPECT_TRUE(out.solved.record.trajectory.segments.empty());
  EXPECT_FALSE(accepted(out.report));
}

TEST(SolveInTube, SaysWhyThereIsNone) {
  TubeTask task = quad();
  TubeSolved out = solved(task, 0, false);
  EXPECT_NE(out.why.find("no path keeps"), std::string::npos) << out.why;
  task.disturbances.gust_most = 30;
  out = solved(task, 0.3);
  EXPECT_NE(out.why.find("may saturate"), std::string::npos) << out.why;
  EXPECT_EQ(out.solved.record.message, out.why);
  EXPECT_TRUE(out.solved.record.trajectory.segments.empty());
  EXPECT_FALSE(accepted(out.report));
  geom::PathRecord none{.id = "b", .status = geom::PathStatus::unreachable, .message = "closed"};
  out = solve_in_tube(task, none, {}, {});
  EXPECT_EQ(out.solved.record.status, TrajectoryStatus::no_path);
  EXPECT_EQ(reason(out.report), "no_path");
  EXPECT_NE(out.why, "");
}

}  // namespace
}  // namespace traj
