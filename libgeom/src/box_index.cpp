#include "geom/box_index.h"

#include <algorithm>
#include <cmath>

namespace geom {
namespace {

std::uint64_t key(std::int64_t x, std::int64_t y) {
  return static_cast<std::uint64_t>(x) << 32 ^ (static_cast<std::uint64_t>(y) & 0xffffffffu);
}

struct Cells {
  std::int64_t x0, x1, y0, y1;
  std::int64_t count() const { return (x1 - x0 + 1) * (y1 - y0 + 1); }
};

Cells cells(const Aabb& box, double size) {
  const auto at = [&](double v) { return static_cast<std::int64_t>(std::floor(v / size)); };
  return {at(box.min.x()), at(box.max.x()), at(box.min.y()), at(box.max.y())};
}

}  // namespace

void BoxIndex::add(std::size_t i, const Aabb& box) {
  const double side = (box.max - box.min).head<2>().maxCoeff();
  const int level = side > cell_ ? std::ilogb(side / cell_) + 1 : 0;
  const double size = std::ldexp(cell_, level);
  Level& at = levels_.try_emplace(level, Level{size, {}}).first->second;
  const Cells c = cells(box, size);
  for (std::int64_t y = c.y0; y <= c.y1; ++y) {
    for (std::int64_t x = c.x0; x <= c.x1; ++x) at.hash[key(x, y)].push_back(i);
  }
}

std::vector<std::size_t> BoxIndex::near(const Aabb& region) const {
  std::vector<std::size_t> out;
  const auto take = [&](const std::vector<std::size_t>& some) {
    out.insert(out.end(), some.begin(), some.end());
  };
  for (const auto& [level, at] : levels_) {
    const Cells c = cells(region, at.cell);
    if (static_cast<std::size_t>(c.count()) > at.hash.size()) {
      for (const auto& [cell, some] : at.hash) take(some);
      continue;
    }
    for (std::int64_t y = c.y0; y <= c.y1; ++y) {
      for (std::int64_t x = c.x0; x <= c.x1; ++x) {
        if (const auto found = at.hash.find(key(x, y)); found != at.hash.end()) {
          take(found->second);
        }
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
