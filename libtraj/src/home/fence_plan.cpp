#include "traj/home/fence_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "few_corners.h"
#include "free_cells.h"
#include "geom/base/precondition.h"
#include "geom/map/geographic_frame.h"
#include "geom/shape/hull.h"
#include "plan_shape.h"
#include "traj/mission/judge/regions.h"

namespace traj {
namespace {

constexpr double kParts = 1e7;  // of a degree, as MAVLink sends them
constexpr double kAround = 15;  // m around all regions that fences may use
constexpr double kGaps[] = {8, 4, 2, 1, 0.5, 0.25, 0.12, 0.06, 0.03, 0.018};  // m, tried in turn
constexpr double kRegionShare = 0.45;  // of a gap, kept beside a region; and beside a box
constexpr double kBoxShare = 0.5;
constexpr double kFarShare = 0.25;     // beside a box that is far from all regions,
constexpr double kCoarseShare = 0.25;  // and as much for the grid on which it is drawn
constexpr double kFine = 1;            // m: that grid, or coarser for long missions,
constexpr double kCoarse = 2;          // but no coarser than this
constexpr double kCellsAcross = 800;
constexpr std::uint64_t kSeeds = 8;

// --- what the fences keep between ---------------------------------------------------------------

struct TallBox {
  std::size_t index;
  PlanBox plan;
  double gap = kGaps[0];
};

struct Region {
  Outline outline;
  PlanBox around;
  double gap = kGaps[0];
};

std::vector<Region> regions_of(const FenceTask& task) {
  std::vector<Region> out;
  for (const FencedRegion& one : task.regions) {
    Outline outline = outline_around(one.hull, one.room);
    const auto in = [&](const Outline& a, const Outline& b) { return holds(b, a); };
    if (std::any_of(out.begin(), out.end(),
                    [&](const Region& r) { return in(outline, r.outline); }))
      continue;
    std::erase_if(out, [&](const Region& r) { return in(r.outline, outline); });
    const PlanBox around = box_around(outline);
    out.push_back({std::move(outline), around});
  }
  return out;
}

PlanBox bounds_of(std::span<const Region> regions) {
  PlanBox box = regions.front().around;
  for (const Region& one : regions) {
    box = {box.min.cwiseMin(one.around.min), box.max.cwiseMax(one.around.max)};
  }
  return grown(box, kAround);
}

std::vector<TallBox> tall_boxes(const geom::CollisionScene& scene, const FenceTask& task,
                                const PlanBox& bounds) {
  std::vector<TallBox> out;
  const geom::Aabb region{{bounds.min.x(), bounds.min.y(), task.low},
                          {bounds.max.x(), bounds.max.y(), task.high}};
  for (const std::size_t box : scene.boxes_meeting(region)) {
    const geom::Aabb obstacle = scene.map().box(box);
    out.push_back({box, {obstacle.min.head<2>(), obstacle.max.head<2>()}});
  }
  return out;
}

// The largest of the gaps by which a box may grow and not meet the region; 0: none.
double gap_between(const TallBox& box, const Region& region) {
  for (const double gap : kGaps) {
    const PlanBox larger = grown(box.plan, gap);
    if (!overlap(larger, region.around)) return gap;
    if (!meet(outline_of(larger), region.outline)) return gap;
  }
  return 0;
}

// How near regions and boxes are to each other. Takes out the boxes that are too near, and gives
// their indices.
std::vector<std::size_t> take_gaps(std::vector<TallBox>& boxes, std::vector<Region>& regions) {
  std::vector<std::size_t> open;
  for (TallBox& box : boxes) {
    std::vector<double> gaps;
    for (const Region& one : regions) {
      gaps.push_back(gap_between(box, one));
      box.gap = std::min(box.gap, gaps.back());
      if (box.gap == 0) break;
    }
    if (box.gap == 0) {
      open.push_back(box.index);
      continue;
    }
    for (std::size_t i = 0; i < regions.size(); ++i) {
      regions[i].gap = std::min(regions[i].gap, gaps[i]);
    }
  }
  std::erase_if(boxes, [](const TallBox& box) { return box.gap == 0; });
  return open;
}

// Its box on a coarse grid, where that is still far from regions.
PlanBox drawn(const TallBox& box, double grid) {
  static_assert(kCoarse <= kCoarseShare * kGaps[0]);
  if (box.gap < kGaps[0]) return grown(box.plan, kBoxShare * box.gap);
  const PlanBox larger = grown(box.plan, kFarShare * box.gap);
  return {(larger.min / grid).array().floor().matrix() * grid,
          (larger.max / grid).array().ceil().matrix() * grid};
}

// --- rings and fences ---------------------------------------------------------------------------

using Rings = std::vector<std::vector<Vec2>>;  // the inclusion's, then those of exclusions

class FenceMaker {
 public:
  FenceMaker(const geom::CollisionScene& scene, const FenceTask& task)
      : task_(task),
        axes_(scene.map().spec().frame.axes),
        earth_(task.origin),
        regions_(regions_of(task)),
        bounds_(bounds_of(regions_)) {
    boxes_ = tall_boxes(scene, task, bounds_);
    open_ = take_gaps(boxes_, regions_);
  }

  const std::vector<std::size_t>& open() const { return open_; }

  // The rings with the fewest corners; none where regions are apart.
  Rings rings() const {
    std::vector<Outline> inside;
    for (const Region& one : regions_) {
      inside.push_back(grown(one.outline, kRegionShare * one.gap));
    }
    std::vector<PlanBox> outside;
    const double across = (bounds_.max - bounds_.min).maxCoeff();
    const double grid = std::clamp(across / kCellsAcross, kFine, kCoarse);
    for (const TallBox& box : boxes_) outside.push_back(drawn(box, grid));
    const auto area = rings_between(inside, outside, bounds_);
    if (!area) return {};
    std::vector<Outline> shapes = std::move(inside);
    for (const PlanBox& box : outside) shapes.push_back(outline_of(box));
    return fewest(*area, Kept(std::move(shapes), bounds_));
  }

  std::vector<GeodeticFence> fences(const Rings& rings) const {
    std::vector<GeodeticFence> out;
    for (const std::vector<Vec2>& ring : rings) {
      GeodeticFence& fence = out.emplace_back();
      fence.inclusion = out.size() == 1;
      for (const Vec2& p : ring) fence.ring.push_back(place(p));
    }
    return out;
  }

 private:
  Rings fewest(const AreaRings& area, const Kept& kept) const {
    Rings best{fewest(area.outer, kept)};
    for (const std::vector<Vec2>& hole : area.holes) best.push_back(fewest(hole, kept));
    return best;
  }

  // Of several orders in which corners go, the first with the fewest left.
  std::vector<Vec2> fewest(const std::vector<Vec2>& ring, const Kept& kept) const {
    std::vector<Vec2> best;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      std::vector<Vec2> made = cut(few_corners(ring, kept, seed));
      if (is_apart(made) && (best.empty() || made.size() < best.size())) best = std::move(made);
      if (best.size() == 3 || best.size() == 4) break;
    }
    return best.empty() ? ring : best;
  }

  // With further corners on edges so long that their bulge would matter.
  std::vector<Vec2> cut(const std::vector<Vec2>& ring) const {
    double least = kGaps[0];
    for (const Region& one : regions_) least = std::min(least, one.gap);
    const double longest = std::sqrt(0.2 * least * 8 / kBend);
    std::vector<Vec2> out;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 way = ring[(i + 1) % ring.size()] - ring[i];
      const double parts = std::max(1.0, std::ceil(way.norm() / longest));
      for (double k = 0; k < parts; ++k) out.push_back(ring[i] + way * (k / parts));
    }
    return out;
  }

  geom::GeodeticPlace place(const Vec2& p) const {
    geom::GeodeticPlace place = earth_.place(geom::to_enu(axes_, Vec3(p.x(), p.y(), 0)));
    place.latitude = std::round(place.latitude * kParts) / kParts;
    place.longitude = std::round(place.longitude * kParts) / kParts;
    place.height = 0;
    return place;
  }

  // Of geom::outline_on_map, at 60 degrees of latitude: an edge bends by this times the square of
  // its length over 8.
  static constexpr double kBend = 2.8 / 6.3e6;

  const FenceTask& task_;
  geom::Axes axes_;
  geom::GeographicFrame earth_;
  std::vector<Region> regions_;
  PlanBox bounds_;
  std::vector<TallBox> boxes_;
  std::vector<std::size_t> open_;
};

// --- the proof
// ------------------------------------------------------------------------------------

Fence on_map(const GeodeticFence& fence, const geom::GeodeticOrigin& origin, geom::Axes axes,
             std::string_view source) {
  Fence out = fence_on_map(fence, origin, source);
  for (Vec2& p : out.ring) p = geom::to_enu(axes, Vec3(p.x(), p.y(), 0)).head<2>();
  return out;
}

Vec3 flat(const Vec2& p) { return {p.x(), p.y(), 0}; }

// Whether the whole box is where the fence lets nobody be: no edge comes as near to it as edges may
// bulge, and one of its corners is on that side. `around`: the fence's ring.
bool keeps_out(const Fence& fence, const PlanBox& around, const geom::Aabb& box) {
  const PlanBox larger = grown(PlanBox{box.min.head<2>(), box.max.head<2>()}, fence.bulge + 1e-6);
  if (!overlap(larger, around)) return fence.inclusion;
  const geom::Aabb plan{flat(larger.min), flat(larger.max)};
  for (std::size_t i = 0; i < fence.ring.size(); ++i) {
    const Vec3 edge[] = {flat(fence.ring[i]), flat(fence.ring[(i + 1) % fence.ring.size()])};
    if (geom::hull_meets(edge, plan)) return false;
  }
  return geom::contains(geom::Polygon{fence.ring, {}}, box.min.head<2>()) != fence.inclusion;
}

std::optional<std::string> why_region_leaves(const geom::CollisionScene& scene,
                                             const FenceTask& task, std::span<const Fence> fences) {
  for (std::size_t i = 0; i < task.regions.size(); ++i) {
    const FencedRegion& region = task.regions[i];
    const Vec2 stray = region.room - scene.half().head<2>();
    CheckResult result;
    check_fences(scene, {{Sweep{region.hull, {}}}}, fences, {stray.x(), stray.y(), 0}, result);
    if (result.reason == Reason::none) continue;
    return fmt::format("region {} leaves a fence near [{:.3f}, {:.3f}]", i, result.place.x(),
                       result.place.y());
  }
  return std::nullopt;
}

std::string counted_corners(std::size_t corners, std::size_t budget) {
  return fmt::format("{} corners were needed, and {} is what the autopilot stores", corners,
                     budget);
}

}  // namespace

CompiledFences compile_fences(const geom::CollisionScene& scene, const FenceTask& task) {
  CompiledFences out;
  const FenceMaker maker(scene, task);
  out.open = maker.open();
  const Rings rings = maker.rings();
  if (rings.empty()) {
    out.missing = "tall obstacles keep parts of the mission and its returns apart in plan";
    return out;
  }
  out.fences = maker.fences(rings);
  out.corners = corners_of(out.fences);
  if (out.corners > task.budget) {
    out.missing = counted_corners(out.corners, task.budget);
  } else if (auto why = why_not_fenced(scene, task, out.fences, out.open, "compiled fences")) {
    out.missing = std::move(*why);
  }
  if (!out.missing.empty()) out.fences.clear();
  return out;
}

std::optional<std::string> why_not_fenced(const geom::CollisionScene& scene, const FenceTask& task,
                                          std::span<const GeodeticFence> fences,
                                          std::span<const std::size_t> open,
                                          std::string_view source) {
  std::vector<Fence> on;
  for (const GeodeticFence& one : fences) {
    on.push_back(on_map(one, task.origin, scene.map().spec().frame.axes, source));
  }
  if (auto why = why_region_leaves(scene, task, on)) return why;
  const geom::Aabb everywhere{{-geom::kFarthest, -geom::kFarthest, task.low},
                              {geom::kFarthest, geom::kFarthest, task.high}};
  std::vector<PlanBox> around;
  for (const Fence& one : on) around.push_back(box_around(one.ring));
  const auto is_out = [&](const geom::Aabb& box) {
    for (std::size_t i = 0; i < on.size(); ++i) {
      if (keeps_out(on[i], around[i], box)) return true;
    }
    return false;
  };
  for (const std::size_t box : scene.boxes_meeting(everywhere)) {
    if (std::binary_search(open.begin(), open.end(), box)) continue;
    if (is_out(scene.map().box(box))) continue;
    return fmt::format("no fence keeps out of box {}", box);
  }
  return std::nullopt;
}

std::size_t corners_of(std::span<const GeodeticFence> fences) {
  std::size_t corners = 0;
  for (const GeodeticFence& one : fences) corners += std::max<std::size_t>(1, one.ring.size());
  return corners;
}

std::size_t fence_budget(std::span<const Autopilot> autopilots) {
  std::size_t budget = 70;
  for (const Autopilot& one : autopilots) {
    if (one.firmware != Firmware::px4) continue;
    const std::string& name = one.name;  // "px4:1.15", or "px4:1.11-1.17"
    const bool new_enough = name.starts_with("px4:1.15") || name.starts_with("px4:1.16") ||
                            name.starts_with("px4:1.17");
    budget = std::min<std::size_t>(budget, new_enough ? 64 : 63);
  }
  return budget;
}

}  // namespace traj
