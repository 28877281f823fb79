#include "geom/box_index.h"

#include <algorithm>
#include <cmath>

namespace geom {
namespace {

std::uint64_t key(std::int64_t x, std::int64_t y) {
  return static_cast<std::uint64_t>(x) << 32 ^ (static_cast<std::uint64_t>(y) & 0xffffffffu);
}

}  // namespace

BoxIndex::Cells BoxIndex::cells(const Aabb& box) const {
  const auto at = [&](double v) { return static_cast<std::int64_t>(std::floor(v / cell_)); };
  return {at(box.min.x()), at(box.max.x()), at(box.min.y()), at(box.max.y())};
}

void BoxIndex::add(std::size_t i, const Aabb& box) {
  const Cells c = cells(box);
  if (c.count() > kMany) {
    large_.push_back(i);
    return;
  }
  for (std::int64_t y = c.y0; y <= c.y1; ++y) {
    for (std::int64_t x = c.x0; x <= c.x1; ++x) hash_[key(x, y)].push_back(i);
  }
}

std::vector<std::size_t> BoxIndex::near(const Aabb& region) const {
  std::vector<std::size_t> out = large_;
  const Cells c = cells(region);
  const auto take = [&](const std::vector<std::size_t>& some) {
    out.insert(out.end(), some.begin(), some.end());
  };
  if (static_cast<std::size_t>(c.count()) > hash_.size()) {
    for (const auto& [cell, some] : hash_) take(some);
  } else {
    for (std::int64_t y = c.y0; y <= c.y1; ++y) {
      for (std::int64_t x = c.x0; x <= c.x1; ++x) {
        if (const auto at = hash_.find(key(x, y)); at != hash_.end()) take(at->second);
      }
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

double index_cell(std::span<const Aabb> boxes) {
  double sum = 0;
  for (const Aabb& box : boxes) sum += (box.max - box.min).head<2>().maxCoeff();
  return std::max(1.0, boxes.empty() ? 1 : sum / static_cast<double>(boxes.size()));
}

}  // namespace geom
