#include "geom/map/footprint.h"

#include <algorithm>
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

// Those that reach as far down and up as the footprint, and may touch it in plan.
std::vector<Aabb> as_high(std::span<const Aabb> boxes, const Footprint& f, const Vec2& low,
                          const Vec2& high) {
  std::vector<Aabb> out;
  for (const Aabb& box : boxes) {
    if (box.min.z() <= f.bottom && box.max.z() >= f.top && box.min.x() <= high.x() &&
        box.max.x() >= low.x() && box.min.y() <= high.y() && box.max.y() >= low.y()) {
      out.push_back(box);
    }
  }
  return out;
}

struct Row {
  double y;
  double low;  // x
  double high;
};

// Whether the polygon holds the middle of a place in the row that none of the boxes covers; these
// are in the order of their lower x.
bool has_gap(const Polygon& polygon, const std::vector<const Aabb*>& boxes, const Row& row) {
  const auto is_gap = [&](double from, double to) {
    return from < to && contains(polygon, {0.5 * (from + to), row.y});
  };
  double reached = row.low;
  for (const Aabb* box : boxes) {
    if (is_gap(reached, std::min(box->min.x(), row.high))) return true;
    reached = std::max(reached, box->max.x());
  }
  return is_gap(reached, row.high);
}

// Whether the polygon, whose edges lie within the boxes, holds a place that none of them does. The
// boxes' sides cut the rectangle around it into rows. No edge enters what no box covers between two
// boxes of a row, so that lies inside the polygon as a whole or outside as a whole.
bool encloses_gap(const Footprint& f, std::span<const Aabb> boxes) {
  Vec2 low = f.polygon.outer.front();
  Vec2 high = low;
  for (const Vec2& p : f.polygon.outer) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  std::vector<Aabb> near = as_high(boxes, f, low, high);
  if (near.size() > kMostGapBoxes) return true;  // not worth looking: it gets boxes of its own
  std::vector<double> rows = {low.y(), high.y()};
  for (const Aabb& box : near) {
    for (const double y : {box.min.y(), box.max.y()}) {
      if (y > low.y() && y < high.y()) rows.push_back(y);
    }
  }
  std::sort(rows.begin(), rows.end());
  std::sort(near.begin(), near.end(),
            [](const Aabb& a, const Aabb& b) { return a.min.y() < b.min.y(); });
  std::vector<const Aabb*> in_row;  // by their lower x
  auto next = near.begin();
  for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
    if (rows[j] == rows[j + 1]) continue;
    std::erase_if(in_row, [&](const Aabb* box) { return box->max.y() <= rows[j]; });
    for (; next != near.end() && next->min.y() <= rows[j]; ++next) {
      if (next->max.y() <= rows[j]) continue;
      in_row.insert(
          std::upper_bound(in_row.begin(), in_row.end(), &*next,
                           [](const Aabb* a, const Aabb* b) { return a->min.x() < b->min.x(); }),
          &*next);
    }
    const double middle = 0.5 * (rows[j] + rows[j + 1]);
    if (has_gap(f.polygon, in_row, {middle, low.x(), high.x()})) return true;
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

// Of one that has a flat top; they reach `margin` further than needed.
std::vector<Aabb> flat_boxes(const Footprint& f, double slack, double margin) {
  const double pad = margin + f.bulge;  // a corner moves by up to 1.5 times as much
  std::vector<Aabb> out;
  for (const Rectangle& r : cover(f.polygon, slack - 1.5 * pad - f.bulge)) {
    out.push_back(
        {{r.min.x() - pad, r.min.y() - pad, f.bottom}, {r.max.x() + pad, r.max.y() + pad, f.top}});
  }
  return out;
}

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
      append(flat_boxes(f, slack_, margin_));
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

// Features that are covered one after another, so that many small ones cost little each.
struct Block {
  std::vector<Aabb> boxes;
  std::vector<std::uint64_t> ids;
  std::vector<std::uint32_t> label;

  void add(std::span<const Footprint> feature, double slack) {
    const Footprint& first = feature.front();
    const bool flat = feature.size() == 1 && first.heights.empty();
    const std::vector<Aabb> made =
        flat ? flat_boxes(first, slack, 0) : FeatureCover(feature, slack).boxes();
    boxes.insert(boxes.end(), made.begin(), made.end());
    ids.resize(boxes.size(), first.id);
    label.resize(boxes.size(), first.label);
  }
};

}  // namespace

BoxTable boxes_of(const std::vector<Footprint>& footprints, double slack, const Execution& run) {
  std::vector<std::size_t> first;  // of each feature, and their end
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (i == 0 || footprints[i].id != footprints[i - 1].id) first.push_back(i);
  }
  const std::size_t features = first.size();
  first.push_back(footprints.size());
  const std::size_t together = std::clamp<std::size_t>(features / 256, 1, 64);
  std::vector<Block> made((features + together - 1) / together);
  parallel_for(made.size(), run, [&](std::size_t k) {
    for (std::size_t i = k * together; i < std::min(features, (k + 1) * together); ++i) {
      made[k].add(std::span(footprints).subspan(first[i], first[i + 1] - first[i]), slack);
    }
  });
  std::size_t count = 0;
  for (const Block& block : made) count += block.boxes.size();
  BoxTable table;
  table.boxes.reserve(count);
  table.ids.reserve(count);
  table.label.reserve(count);
  for (Block& block : made) {
    table.boxes.insert(table.boxes.end(), block.boxes.begin(), block.boxes.end());
    table.ids.insert(table.ids.end(), block.ids.begin(), block.ids.end());
    table.label.insert(table.label.end(), block.label.begin(), block.label.end());
    block = {};
  }
  return table;
}

double uneven_by(const Footprint& footprint, double slack) {
  if (footprint.heights.empty()) return 0;
  const PlaneFit plane = fit_plane(corners_of(footprint));
  return is_upright(plane, slack) || plane.low == plane.high ? 0 : 2 * plane.residual;
}

}  // namespace geom
