// The collision structure beside brute force, FCL and CGAL's AABB tree, on the same boxes and
// segments in one run. CGAL's tree is GPL: this program links no Ipopt and is not installed.

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <benchmark/benchmark.h>
#include <fcl/fcl.h>

#include <limits>

#include "support/bench_scene.h"

namespace {

using geom::Vec3;
using support::grown_boxes;
using support::scene;
using support::segments;
using Kernel = CGAL::Simple_cartesian<double>;

Kernel::Point_3 point(const Vec3& v) { return {v[0], v[1], v[2]}; }

struct BoxPrimitive {
  using Id = std::size_t;
  using Point = Kernel::Point_3;
  using Datum = Kernel::Iso_cuboid_3;

  BoxPrimitive(std::vector<geom::Aabb>::const_iterator it)
      : index(static_cast<std::size_t>(it - grown_boxes().begin())),
        box(point(it->min), point(it->max)) {}
  Id id() const { return index; }
  Datum datum() const { return box; }
  Point reference_point() const { return (box.min)(); }

  Id index;
  Datum box;
};

using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, BoxPrimitive>>;

struct FclWorld {
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
  fcl::DynamicAABBTreeCollisionManagerd manager;

  FclWorld() {
    for (const geom::Aabb& box : grown_boxes()) {
      const Vec3 size = box.max - box.min;
      fcl::Transform3d place = fcl::Transform3d::Identity();
      place.translation() = 0.5 * (box.min + box.max);
      objects.push_back(std::make_unique<fcl::CollisionObjectd>(
          std::make_shared<fcl::Boxd>(size[0], size[1], size[2]), place));
      manager.registerObject(objects.back().get());
    }
    manager.setup();
  }
};

FclWorld& fcl_world() {
  static FclWorld world;
  return world;
}

// FCL has no segments: a capsule of a nanometre stands for one.
fcl::CollisionObjectd thin(const Vec3& a, const Vec3& b) {
  fcl::Transform3d place = fcl::Transform3d::Identity();
  place.translation() = 0.5 * (a + b);
  place.linear() = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), b - a).toRotationMatrix();
  return {std::make_shared<fcl::Capsuled>(1e-9, (b - a).norm()), place};
}

template <class F>
void over_segments(benchmark::State& state, const F& f) {
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [a, b] = segments()[i++ % segments().size()];
    benchmark::DoNotOptimize(f(a, b));
  }
}

void SegmentBruteForce(benchmark::State& state) { over_segments(state, support::brute_force); }
BENCHMARK(SegmentBruteForce);

void SegmentBruteForceExact(benchmark::State& state) {
  over_segments(state, [](const Vec3& a, const Vec3& b) {
    return std::any_of(grown_boxes().begin(), grown_boxes().end(),
                       [&](const geom::Aabb& box) { return geom::segment_hits(a, b, box); });
  });
}
BENCHMARK(SegmentBruteForceExact);

void SegmentSkyway(benchmark::State& state) {
  over_segments(state, [](const Vec3& a, const Vec3& b) { return scene().hits(a, b); });
}
BENCHMARK(SegmentSkyway);

void SegmentCgalTree(benchmark::State& state) {
  static Tree tree(grown_boxes().begin(), grown_boxes().end());
  over_segments(state, [](const Vec3& a, const Vec3& b) {
    return tree.do_intersect(Kernel::Segment_3(point(a), point(b)));
  });
}
BENCHMARK(SegmentCgalTree);

void SegmentFcl(benchmark::State& state) {
  over_segments(state, [](const Vec3& a, const Vec3& b) {
    fcl::CollisionObjectd object = thin(a, b);
    object.computeAABB();
    fcl::DefaultCollisionData<double> data;
    fcl_world().manager.collide(&object, &data, fcl::DefaultCollisionFunction<double>);
    return data.result.isCollision();
  });
}
BENCHMARK(SegmentFcl);

void NearestSkyway(benchmark::State& state) {
  over_segments(state, [](const Vec3& a, const Vec3&) {
    return scene().nearest(a, std::numeric_limits<double>::infinity());
  });
}
BENCHMARK(NearestSkyway);

void NearestBruteForce(benchmark::State& state) {
  over_segments(state, [](const Vec3& a, const Vec3&) {
    double best = std::numeric_limits<double>::infinity();
    for (const geom::Aabb& box : grown_boxes()) best = std::min(best, geom::distance(a, box));
    return best;
  });
}
BENCHMARK(NearestBruteForce);

void NearestFcl(benchmark::State& state) {
  over_segments(state, [](const Vec3& a, const Vec3&) {
    fcl::Transform3d place = fcl::Transform3d::Identity();
    place.translation() = a;
    fcl::CollisionObjectd object(std::make_shared<fcl::Sphered>(1e-9), place);
    object.computeAABB();
    fcl::DefaultDistanceData<double> data;
    fcl_world().manager.distance(&object, &data, fcl::DefaultDistanceFunction<double>);
    return data.result.min_distance;
  });
}
BENCHMARK(NearestFcl);

}  // namespace

BENCHMARK_MAIN();
