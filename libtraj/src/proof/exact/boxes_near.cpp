#include "boxes_near.h"

#include <numeric>

namespace traj::exact {
namespace {

using geom::Aabb;
using geom::Vec3;
using Indices = std::vector<std::size_t>;

class Search {
 public:
  Search(std::span<const Aabb> boxes, const Vec3& reach, std::span<const Aabb> regions)
      : boxes_(boxes), reach_(reach), regions_(regions), found_(regions.size()) {}

  std::vector<Indices> run() {
    Indices all(boxes_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    if (!regions_.empty()) look(0, regions_.size(), all);
    return std::move(found_);
  }

 private:
  // Of the boxes that a larger part of the regions has left.
  void look(std::size_t first, std::size_t last, const Indices& left) {
    Aabb around = regions_[first];
    for (std::size_t i = first + 1; i < last; ++i) {
      around.min = around.min.cwiseMin(regions_[i].min);
      around.max = around.max.cwiseMax(regions_[i].max);
    }
    Indices near;
    for (const std::size_t i : left) {
      const Aabb& box = boxes_[i];
      const bool beyond = ((box.min - reach_).array() > around.max.array()).any();
      const bool before = ((box.max + reach_).array() < around.min.array()).any();
      if (!beyond && !before) near.push_back(i);
    }
    if (last - first == 1) {
      found_[first] = std::move(near);
      return;
    }
    const std::size_t middle = first + (last - first) / 2;
    look(first, middle, near);
    look(middle, last, near);
  }

  std::span<const Aabb> boxes_;
  const Vec3& reach_;
  std::span<const Aabb> regions_;
  std::vector<Indices> found_;
};

}  // namespace

std::vector<Indices> boxes_near(std::span<const Aabb> boxes, const Vec3& reach,
                                std::span<const Aabb> regions) {
  return Search(boxes, reach, regions).run();
}

}  // namespace traj::exact
