#include "plan/planner/proof_line.h"

#include <gtest/gtest.h>

#include "plan/scenes.h"

namespace plan {
namespace {

const geom::Aabb kCube{{0, 0, 0}, {40, 40, 40}};
const geom::PlanQuery kQuery{.id = "q1", .from = {5, 20, 5}, .to = {35, 20, 5}};

std::string line_of(const geom::CollisionScene& scene, const PlanOptions& options) {
  return proof_line(scene, kQuery, Planner(scene).plan(kQuery.from, kQuery.to, options));
}

TEST(ProofLine, IsTheEnclosureWhereThereIsNoWay) {
  const auto scene = scene_of({{{19, 0, 0}, {21, 40, 40}}}, kCube);
  EXPECT_EQ(line_of(scene, {.keep_cells = true}).find(R"({"type":"enclosure","id":"q1")"), 0u);
  EXPECT_EQ(line_of(scene, {}), "");
}

TEST(ProofLine, IsTheProofOfTheBoundWhereItWasKept) {
  const auto scene = scene_of({{{19, 10, 0}, {21, 40, 40}}}, kCube);
  EXPECT_EQ(line_of(scene, {.keep_proof = true, .gap = 0.1}).find(R"({"type":"bound","id":"q1")"),
            0u);
  EXPECT_EQ(line_of(scene, {.gap = 0.1}), "");
}

}  // namespace
}  // namespace plan
