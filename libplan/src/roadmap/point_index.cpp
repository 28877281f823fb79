#include "point_index.h"

#include <algorithm>
#include <bit>
#include <tuple>

namespace plan {
namespace {

using geom::Vec3;

constexpr std::size_t kLeaf = 16;  // entries that are looked at one by one

}  // namespace

void PointIndex::Nearest::offer(double squared, std::uint32_t candidate) {
  if (std::tie(squared, candidate) < std::tie(reach, id)) {
    reach = squared;
    id = candidate;
  }
}

void PointIndex::Within::offer(double squared, std::uint32_t candidate) {
  if (squared <= reach) ids.push_back(candidate);
}

// The trees are of as many leaves as the binary digits of size / kLeaf say, the largest first, as
// in a counter: an entry that completes a leaf carries into a tree of all the smaller ones.
void PointIndex::insert(const Vec3& point, std::uint32_t id) {
  entries_.push_back({point, id, 0});
  const std::size_t size = entries_.size();
  if (size % kLeaf) return;
  const std::size_t leaves = size / kLeaf;
  build(size - kLeaf * (leaves & (~leaves + 1)), size);
}

void PointIndex::build(std::size_t low, std::size_t high) {
  if (high - low <= kLeaf) return;
  Vec3 least = entries_[low].point;
  Vec3 most = least;
  for (std::size_t i = low; i < high; ++i) {
    least = least.cwiseMin(entries_[i].point);
    most = most.cwiseMax(entries_[i].point);
  }
  int axis = 0;
  (most - least).maxCoeff(&axis);
  const std::size_t middle = low + (high - low) / 2;
  const auto at = [&](std::size_t i) { return entries_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(low), at(middle), at(high), [axis](const Entry& a, const Entry& b) {
    return std::tie(a.point[axis], a.id) < std::tie(b.point[axis], b.id);
  });
  entries_[middle].axis = static_cast<std::uint8_t>(axis);
  build(low, middle);
  build(middle + 1, high);
}

// `outside`: how far `p` is from the range along each axis. No point of it is nearer, even as
// rounded, since rounding keeps the order of differences, squares and sums.
template <class Search>
void PointIndex::search(std::size_t low, std::size_t high, const Vec3& p, const Vec3& outside,
                        Search& found) const {
  if (outside.squaredNorm() > found.reach) return;
  if (high - low <= kLeaf) {
    for (std::size_t i = low; i < high; ++i) {
      found.offer((p - entries_[i].point).squaredNorm(), entries_[i].id);
    }
    return;
  }
  const std::size_t middle = low + (high - low) / 2;
  const Entry& split = entries_[middle];
  const double beyond = p[split.axis] - split.point[split.axis];
  Vec3 across = outside;
  across[split.axis] = beyond;
  found.offer((p - split.point).squaredNorm(), split.id);
  if (beyond < 0) {
    search(low, middle, p, outside, found);
    search(middle + 1, high, p, across, found);
  } else {
    search(middle + 1, high, p, outside, found);
    search(low, middle, p, across, found);
  }
}

template <class Search>
void PointIndex::search(const Vec3& p, Search& found) const {
  std::size_t low = 0;
  for (std::size_t leaves = entries_.size() / kLeaf; leaves > 0;) {
    const std::size_t run = std::bit_floor(leaves);
    search(low, low + kLeaf * run, p, Vec3::Zero(), found);
    low += kLeaf * run;
    leaves -= run;
  }
  search(low, entries_.size(), p, Vec3::Zero(), found);
}

std::uint32_t PointIndex::nearest(const Vec3& p) const {
  Nearest found;
  search(p, found);
  return found.id;
}

std::vector<std::uint32_t> PointIndex::within(const Vec3& p, double radius) const {
  Within found{radius * radius, {}};
  search(p, found);
  std::sort(found.ids.begin(), found.ids.end());
  return std::move(found.ids);
}

}  // namespace plan
