#include "bound/proof_log.h"

#include <gtest/gtest.h>

#include "plan/scenes.h"

namespace plan {
namespace {

const EdgePart kPartOne{{5, 1, 0}, {5, 1, 4}, 2, {1, -1}};

Level some_level() { return first_level(PartTree({kPartOne}), {0, 0, 0}, {10, 0, 0}, 20, 1e-12); }

Occluders two_boxes() {
  return Occluders(
      scene_of({{{5, 5, 0}, {8, 8, 8}}, {{12, 5, 0}, {15, 8, 8}}}, {{0, 0, 0}, {20, 20, 20}}));
}

TEST(ProofLog, NamesEachOccluderAndPairOnce) {
  ProofLog log;
  const Level level = some_level();
  log.begin(level);
  log.come(level.come);
  log.hide(2, 1, 1);
  log.hide(0, 1, 1);
  log.hide(2, 1, 1);
  const Occluders occluders = two_boxes();
  const LengthProof proof = std::move(log).take(occluders);
  ASSERT_EQ(proof.occluders.size(), 1u);
  EXPECT_EQ(proof.occluders[0], occluders.box(1));
  ASSERT_EQ(proof.levels.size(), 1u);
  ASSERT_EQ(proof.levels[0].hidden.size(), 2u);
  EXPECT_EQ(proof.levels[0].hidden[0].from, 0u);
  EXPECT_EQ(proof.levels[0].hidden[1].from, 2u);
  EXPECT_EQ(proof.levels[0].hidden[1].occluder, 0u);
}

TEST(ProofLog, LeavesOutWhatWasNotFinished) {
  ProofLog log;
  log.begin(some_level());
  log.come(some_level().come);
  log.begin(some_level());
  log.hide(0, 1, 0);
  const LengthProof proof = std::move(log).take(two_boxes());
  EXPECT_EQ(proof.levels.size(), 1u);
  EXPECT_TRUE(proof.occluders.empty());
  EXPECT_TRUE(proof.levels[0].go.empty());
}

}  // namespace
}  // namespace plan
