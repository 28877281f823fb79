#include "roadmap/shadows.h"

#include <gtest/gtest.h>

#include "plan/scenes.h"

namespace plan {
namespace {

using geom::Aabb;

const Aabb kBounds{Vec3(-500, -500, 0), Vec3(500, 500, 100)};

Vec3 place(support::Random& random, const Aabb& in) {
  Vec3 p;
  for (int k = 0; k < 3; ++k) p[k] = random.uniform(in.min[k], in.max[k]);
  return p;
}

// Blocks in streets, some of two storeys of different widths.
geom::CollisionScene blocks(support::Random& random, const Vec3& half) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < 400; ++i) {
    const Vec3 low(random.stepped(-490, 460, 25), random.stepped(-490, 460, 25), 0);
    const Vec3 size(random.uniform(2, 20), random.uniform(2, 20), random.uniform(1, 60));
    boxes.push_back({low, low + size});
    if (random.below(2)) {
      const Vec3 upper(1, 1, size.z() - random.uniform(0, 1));
      boxes.push_back({low + upper, low + Vec3(size.x() + 3, size.y() - 0.5, size.z() + 20)});
    }
  }
  return scene_of(std::move(boxes), kBounds, half);
}

TEST(Shadows, HideNothingThatIsSeen) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    support::Random random(seed);
    const geom::CollisionScene scene = blocks(random, Vec3(1, 0.5, 0.25));
    int hidden = 0;
    for (int n = 0; n < 100; ++n) {
      Vec3 eye = place(random, kBounds);
      if (random.below(2)) eye.z() = random.uniform(0, 20);
      const Shadows shadows(scene, eye);
      for (int k = 0; k < 300; ++k) {
        const Vec3 p = place(random, kBounds);
        if (!shadows.hides(p)) continue;
        ++hidden;
        ASSERT_TRUE(scene.hits(eye, p)) << eye.transpose() << " to " << p.transpose();
      }
    }
    EXPECT_GT(hidden, 100);
  }
}

TEST(Shadows, HideABoxOnlyWhereAllOfItIsHidden) {
  support::Random random(4);
  const geom::CollisionScene scene = blocks(random, Vec3::Zero());
  int hidden = 0;
  for (int n = 0; n < 300; ++n) {
    Vec3 eye = place(random, kBounds);
    eye.z() = random.uniform(0, 20);
    const Shadows shadows(scene, eye);
    for (int k = 0; k < 100; ++k) {
      const Vec3 low = place(random, kBounds);
      const Aabb box{
          low, low + Vec3(random.uniform(0, 40), random.uniform(0, 40), random.uniform(0, 10))};
      if (!shadows.hides(box)) continue;
      ++hidden;
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p(corner & 1 ? box.max.x() : box.min.x(), corner & 2 ? box.max.y() : box.min.y(),
                     corner & 4 ? box.max.z() : box.min.z());
        ASSERT_TRUE(scene.hits(eye, p)) << eye.transpose() << " to " << p.transpose();
      }
      for (int m = 0; m < 20; ++m) ASSERT_TRUE(scene.hits(eye, place(random, box)));
    }
  }
  EXPECT_GT(hidden, 100);
}

TEST(Shadows, OfAWallReachAsFarAsItsEdges) {
  const geom::CollisionScene scene = scene_of({{Vec3(10, -20, 0), Vec3(12, 20, 30)}}, kBounds);
  const Shadows shadows(scene, Vec3(0, 0, 10));
  EXPECT_TRUE(shadows.hides(Vec3(100, 0, 10)));
  EXPECT_TRUE(shadows.hides(Vec3(100, 150, 10)));
  EXPECT_TRUE(shadows.hides(Vec3(100, 0, 150)));
  EXPECT_FALSE(shadows.hides(Vec3(100, 0, 260)));   // over it
  EXPECT_FALSE(shadows.hides(Vec3(100, 220, 10)));  // beside it
  EXPECT_FALSE(shadows.hides(Vec3(-100, 0, 10)));   // behind the eye
  EXPECT_FALSE(shadows.hides(Vec3(5, 0, 10)));      // before it
  EXPECT_TRUE(shadows.hides(Aabb{Vec3(100, -20, 0), Vec3(140, 20, 40)}));
  EXPECT_FALSE(shadows.hides(Aabb{Vec3(100, -20, 0), Vec3(140, 20, 300)}));
  EXPECT_FALSE(shadows.hides(Aabb{Vec3(-140, -20, 0), Vec3(140, 20, 40)}));
}

TEST(Shadows, OfAnEyeInTheOpenOrAboveABoxAreNone) {
  const geom::CollisionScene scene = scene_of({{Vec3(-5, -5, 0), Vec3(5, 5, 9)}}, kBounds);
  const Shadows above(scene, Vec3(0, 0, 10));
  EXPECT_FALSE(above.hides(Vec3(100, 0, 5)));
  EXPECT_FALSE(above.hides(Vec3(0, 0, 10)));
  const Shadows open(scene, Vec3(400, 400, 5));
  EXPECT_FALSE(open.hides(Vec3(-100, -100, 5)));
}

}  // namespace
}  // namespace plan
