#include "geom/map/footprint.h"

#include <algorithm>
#include <array>
#include <optional>

#include "cover_slope.h"
#include "cover_upright.h"
#include "geom/base/parallel.h"
#include "geom/map/box_index.h"
#include "geom/shape/cover.h"

namespace geom {
namespace {

// Whether the wall over the segment lies within the boxes. Rounding may say no, never a wrong yes
// by more than the 1e-9 m that cover() rounds outward.
bool wall_covered(const Vec2& a, const Vec2& b, const Footprint& f, std::span<const Aabb> boxes) {
  const Vec3 from(a.x(), a.y(), f.bottom);
  const Vec3 to(b.x(), b.y(), f.bottom);
  std::vector<SegmentPart> parts;
  for (const Aabb& box : boxes) {
    if (box.min.z() > f.bottom || box.max.z() < f.top) continue;
    if (const auto part = clip(from, to, box)) parts.push_back(*part);
  }
  std::sort(parts.begin(), parts.end(),
            [](const SegmentPart& s, const SegmentPart& t) { return s.from < t.from; });
  double reached = 0;
  for (const SegmentPart& part : parts) {
    if (part.from > reached) return false;
    reached = std::max(reached, part.to);
  }
  return !parts.empty() && reached >= 1;
}

constexpr std::size_t kMostGapBoxes = 1000;

// Whether the polygon, whose edges lie within the boxes, holds a place that none of them does. The
// boxes' sides cut the plane into cells; no edge enters one that no box covers, so it lies inside
// the polygon as a whole or outside as a whole.
bool encloses_gap(const Footprint& f, std::span<const Aabb> boxes) {
  Vec2 low = f.polygon.outer.front();
  Vec2 high = low;
  for (const Vec2& p : f.polygon.outer) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  std::vector<Aabb> near;
  for (const Aabb& box : boxes) {
    if (box.min.z() <= f.bottom && box.max.z() >= f.top && box.min.x() <= high.x() &&
        box.max.x() >= low.x() && box.min.y() <= high.y() && box.max.y() >= low.y()) {
      near.push_back(box);
    }
  }
  if (near.size() > kMostGapBoxes) return true;  // not worth looking: it gets boxes of its own
  std::array<std::vector<double>, 2> sides;
  for (int i = 0; i < 2; ++i) {
    auto& side = sides[static_cast<std::size_t>(i)];
    side = {low[i], high[i]};
    for (const Aabb& box : near) {
      side.push_back(box.min[i]);
      side.push_back(box.max[i]);
    }
    std::sort(side.begin(), side.end());
    side.erase(std::unique(side.begin(), side.end()), side.end());
  }
  const std::vector<double>& xs = sides[0];
  const std::vector<double>& ys = sides[1];
  for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
    std::vector<int> depth(xs.size());
    const auto column = [&](double x) {
      return static_cast<std::size_t>(std::lower_bound(xs.begin(), xs.end(), x) - xs.begin());
    };
    for (const Aabb& box : near) {
      if (box.min.y() > ys[j] || box.max.y() < ys[j + 1]) continue;
      ++depth[column(box.min.x())];
      --depth[column(box.max.x())];
    }
    int over = 0;
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
      over += depth[i];
      const Vec2 middle(0.5 * (xs[i] + xs[i + 1]), 0.5 * (ys[j] + ys[j + 1]));
      if (over == 0 && contains(f.polygon, middle)) return true;
    }
  }
  return false;
}

bool covered(const Footprint& f, std::span<const Aabb> boxes) {
  const auto ring_covered = [&](const std::vector<Vec2>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (!wall_covered(ring[i], ring[(i + 1) % ring.size()], f, boxes)) return false;
    }
    return true;
  };
  return ring_covered(f.polygon.outer) &&
         std::all_of(f.polygon.holes.begin(), f.polygon.holes.end(), ring_covered) &&
         !encloses_gap(f, boxes);
}

// A surface of a feature, and what it is taken as.
struct Surface {
  const Footprint* footprint;
  PlaneFit plane;
  bool slopes = false;
  bool upright = false;

  Surface(const Footprint& f, double slack) : footprint(&f) {
    if (f.heights.empty()) return;
    plane = fit_plane(corners_of(f));
    upright = is_upright(plane, slack);
    slopes = !upright && plane.low < plane.high;
  }
  bool likely_covered() const { return upright || footprint->likely_covered; }
};

// The boxes of one feature: roofs first, then what they may hold already.
class FeatureCover {
 public:
  FeatureCover(std::span<const Footprint> footprints, double slack) : slack_(slack) {
    for (const Footprint& f : footprints) surfaces_.emplace_back(f, slack);
    // Walls that lean by little, as corners are rounded to millimetres, stay within the boxes of
    // the roofs on them where those reach beyond the roofs by as much.
    for (const Surface& s : surfaces_) {
      const double thickness = s.upright ? s.plane.thickness() : 0;
      if (thickness <= slack / 50) margin_ = std::max(margin_, thickness);
    }
  }

  std::vector<Aabb> boxes() {
    std::size_t done = 0;
    for (const bool likely : {false, true}) {
      for (const Surface& s : surfaces_) {
        if (s.likely_covered() != likely) continue;
        add(s);
        ++done;
      }
      if (!likely && done < surfaces_.size()) look_up();
    }
    return std::move(boxes_);
  }

 private:
  void add(const Surface& s) {
    const Footprint& f = *s.footprint;
    if (s.upright) {
      append(
          cover_upright(f, s.plane, slack_, [&](const Footprint& part) { return is_held(part); }));
    } else if (s.slopes) {
      append(cover_slope(f, s.plane, slack_, margin_));
    } else if (!s.likely_covered() || f.bulge > 0 || !is_held(f)) {
      const double pad = margin_ + f.bulge;  // a corner moves by up to 1.5 times as much
      std::vector<Aabb> flat;
      for (const Rectangle& r : cover(f.polygon, slack_ - 1.5 * pad - f.bulge)) {
        flat.push_back({{r.min.x() - pad, r.min.y() - pad, f.bottom},
                        {r.max.x() + pad, r.max.y() + pad, f.top}});
      }
      append(flat);
    }
  }

  // Once the roofs are covered.
  bool is_held(const Footprint& f) {
    constexpr double kPad = 1e-6;  // more than coordinates are rounded
    Aabb region{Vec3::Constant(-kLargestCoordinate), Vec3::Constant(kLargestCoordinate)};
    region.min.head<2>() = region.max.head<2>() = f.polygon.outer.front();
    for (const Vec2& p : f.polygon.outer) {
      region.min.head<2>() = region.min.head<2>().cwiseMin(p - Vec2::Constant(kPad));
      region.max.head<2>() = region.max.head<2>().cwiseMax(p + Vec2::Constant(kPad));
    }
    std::vector<Aabb> near;
    for (const std::size_t i : index_->near(region)) near.push_back(boxes_[i]);
    return covered(f, near);
  }

  void look_up() {
    index_.emplace(boxes_.empty() ? 1 : index_cell(boxes_));
    for (std::size_t i = 0; i < boxes_.size(); ++i) index_->add(i, boxes_[i]);
  }

  void append(const std::vector<Aabb>& boxes) {
    for (const Aabb& box : boxes) {
      boxes_.push_back(box);
      if (index_) index_->add(boxes_.size() - 1, box);
    }
  }

  double slack_;
  double margin_ = 0;
  std::vector<Surface> surfaces_;
  std::vector<Aabb> boxes_;
  std::optional<BoxIndex> index_;  // once the roofs are covered
};

}  // namespace

BoxTable boxes_of(const std::vector<Footprint>& footprints, double slack, const Execution& run) {
  std::vector<std::size_t> first;  // of each feature
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (i == 0 || footprints[i].id != footprints[i - 1].id) first.push_back(i);
  }
  std::vector<std::vector<Aabb>> made(first.size());
  parallel_for(first.size(), run, [&](std::size_t k) {
    const std::size_t end = k + 1 < first.size() ? first[k + 1] : footprints.size();
    made[k] = FeatureCover(std::span(footprints).subspan(first[k], end - first[k]), slack).boxes();
  });
  BoxTable table;
  for (std::size_t k = 0; k < made.size(); ++k) {
    table.boxes.insert(table.boxes.end(), made[k].begin(), made[k].end());
    table.ids.resize(table.boxes.size(), footprints[first[k]].id);
  }
  table.label.resize(table.boxes.size(), 0);
  return table;
}

double uneven_by(const Footprint& footprint, double slack) {
  if (footprint.heights.empty()) return 0;
  const PlaneFit plane = fit_plane(corners_of(footprint));
  return is_upright(plane, slack) || plane.low == plane.high ? 0 : 2 * plane.residual;
}

}  // namespace geom
