#include "geom/map/footprint.h"

#include <algorithm>

#include "box_runs.h"
#include "cover_slope.h"
#include "cover_upright.h"
#include "geom/base/parallel.h"
#include "geom/shape/cover.h"
#include "held_within.h"

namespace geom {
namespace {

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

// Calls take(box) for the boxes of one that has a flat top; they reach `margin` further than
// needed.
template <class Take>
void for_each_flat_box(const Footprint& f, double slack, double margin, const Take& take) {
  const double pad = margin + f.bulge;  // a corner moves by up to 1.5 times as much
  for (const Rectangle& r : cover(f.polygon, slack - 1.5 * pad - f.bulge)) {
    take(Aabb{{r.min.x() - pad, r.min.y() - pad, f.bottom},
              {r.max.x() + pad, r.max.y() + pad, f.top}});
  }
}

std::vector<Aabb> flat_boxes(const Footprint& f, double slack, double margin) {
  std::vector<Aabb> out;
  for_each_flat_box(f, slack, margin, [&](const Aabb& box) { out.push_back(box); });
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
    for (const bool likely : {false, true}) {
      for (const Surface& s : surfaces_) {
        if (s.likely_covered() == likely) add(s);
      }
    }
    return boxes_.take();
  }

 private:
  void add(const Surface& s) {
    const Footprint& f = *s.footprint;
    if (s.upright) {
      boxes_.add(cover_upright(f, s.plane, slack_, boxes_));
    } else if (s.slopes) {
      boxes_.add(cover_slope(f, s.plane, slack_, margin_));
    } else if (!s.likely_covered() || f.bulge > 0 || !is_held(f)) {
      boxes_.add(flat_boxes(f, slack_, margin_));
    }
  }

  bool is_held(const Footprint& f) { return is_held_(f, boxes_.as_high_as(reach_of(f))); }

  double slack_;
  double margin_ = 0;
  std::vector<Surface> surfaces_;
  BoxRuns boxes_;
  HeldWithin is_held_;
};

// Features that are covered one after another, so that many small ones cost little each.
struct Block {
  std::vector<Aabb> boxes;
  std::vector<std::uint64_t> ids;
  std::vector<std::uint32_t> label;

  void add(std::span<const Footprint> feature, double slack) {
    const Footprint& first = feature.front();
    if (feature.size() == 1 && first.heights.empty()) {
      for_each_flat_box(first, slack, 0, [&](const Aabb& box) { boxes.push_back(box); });
    } else {
      const std::vector<Aabb> made = FeatureCover(feature, slack).boxes();
      boxes.insert(boxes.end(), made.begin(), made.end());
    }
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
