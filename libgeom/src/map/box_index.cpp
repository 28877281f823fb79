#include "geom/map/box_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/base/error.h"
#include "geom/base/precondition.h"

namespace geom {
namespace {

constexpr double kLeastCell = 1e-6;  // metres: cells are counted in 64 bits out to kFarthest

std::uint64_t key(std::int64_t x, std::int64_t y) {
  return static_cast<std::uint64_t>(x) << 32 ^ (static_cast<std::uint64_t>(y) & 0xffffffffu);
}

struct Cells {
  std::int64_t x0, x1, y0, y1;
  double count() const {
    return (static_cast<double>(x1 - x0) + 1) * (static_cast<double>(y1 - y0) + 1);
  }
};

Cells cells(const Aabb& box, double size) {
  require_point("box", box.min);
  require_point("box", box.max);
  const auto at = [&](double v) { return static_cast<std::int64_t>(std::floor(v / size)); };
  return {at(box.min.x()), at(box.max.x()), at(box.min.y()), at(box.max.y())};
}

}  // namespace

BoxIndex::BoxIndex(double cell) : cell_(cell) {
  if (!(cell >= kLeastCell && cell <= kLargestCoordinate)) {
    throw InputError("box index", {.expected = fmt::format("cells of {} to {} metres", kLeastCell,
                                                           kLargestCoordinate),
                                   .found = fmt::to_string(cell)});
  }
}

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
    if (c.count() > static_cast<double>(at.hash.size())) {
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
