#include "plan/planner/path_record.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "plan/scenes.h"

namespace plan {
namespace {

using Json = nlohmann::json;

geom::CollisionScene yard() {
  return scene_of({{{5, 5, 0}, {9, 9, 9}}}, {{0, 0, 0}, {60, 60, 30}}, {0.5, 0.5, 0.25}, 0.1);
}

PlanResult found() {
  PlanResult result;
  result.status = PathStatus::found;
  result.path = {{1, 2, 3}, {4, 5, 6}};
  result.route = OwnRoute::lattice;
  result.expanded = 42;
  return result;
}

TEST(PathRecordOf, SaysWhatWasFoundAndForWhat) {
  const auto scene = yard();
  const geom::PathRecord record = path_record(scene, "q7", found());
  EXPECT_EQ(record.id, "q7");
  EXPECT_EQ(record.status, PathStatus::found);
  EXPECT_EQ(record.points, found().path);
  EXPECT_EQ(record.provenance.map, scene.map().hash());
  EXPECT_EQ(record.provenance.margin, 0.1);
  EXPECT_EQ(record.provenance.vehicle->half, Vec3(0.5, 0.5, 0.25));
  geom::SearchReport search;
  search.method = "lattice";
  search.expanded = 42;
  EXPECT_EQ(record.search, search);
}

TEST(PathRecordOf, SaysWhatNoPathIsShorterThan) {
  PlanResult result = found();
  EXPECT_FALSE(Json::parse(to_json_line(path_record(yard(), "q", result))).contains("bound"));
  result.path = {{1, 1, 1}, {1, 1, 9}};
  result.bound = LengthBound{6.4};
  const geom::PathRecord record = path_record(yard(), "q", result);
  const Json json = Json::parse(to_json_line(record));
  EXPECT_EQ(json["bound"], 6.4);
  EXPECT_EQ(json["gap"], 8 / 6.4 - 1);
  EXPECT_EQ(geom::parse_path_record(to_json_line(record), "s", 1).bound, 6.4);
}

TEST(PathRecordOf, ReportsResolutionStepsAndMovedEnds) {
  PlanResult result = found();
  result.resolution = 2.5;
  result.steps = {{"search", 9, 12.5}, {"taut", 2, 10}};
  result.snapped_goal = Vec3(4, 5, 6);
  const geom::SearchReport search = *path_record(yard(), "q", result).search;
  EXPECT_EQ(search.resolution, 2.5);
  EXPECT_EQ(search.steps, result.steps);
  EXPECT_EQ(search.snapped_goal, Vec3(4, 5, 6));
  EXPECT_EQ(search.snapped_start, std::nullopt);
  result.steps.resize(1);
  EXPECT_TRUE(path_record(yard(), "q", result).search->steps.empty());
}

TEST(PathRecordOf, HasNoReportWhereNothingWasSearched) {
  PlanResult blocked;
  blocked.status = PathStatus::start_blocked;
  blocked.message = "the start is within box 0";
  const geom::PathRecord record = path_record(yard(), "q", blocked);
  EXPECT_EQ(record.search, std::nullopt);
  EXPECT_EQ(record.message, blocked.message);
  EXPECT_TRUE(record.points.empty());
}

TEST(PathRecordOf, ComesBackFromItsLine) {
  const geom::PathRecord record = path_record(yard(), "q7", found());
  const geom::PathRecord back = geom::parse_path_record(to_json_line(record), "line", 1);
  EXPECT_EQ(back.points, record.points);
  EXPECT_EQ(back.search, record.search);
  EXPECT_EQ(geom::mismatch(back.provenance, record.provenance), std::nullopt);
}

}  // namespace
}  // namespace plan
