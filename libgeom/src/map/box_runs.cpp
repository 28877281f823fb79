#include "box_runs.h"

#include <algorithm>

namespace geom {
namespace {

constexpr std::size_t kRun = 16;

}  // namespace

void BoxRuns::add(std::span<const Aabb> boxes) {
  for (const Aabb& box : boxes) {
    std::size_t index = levels_.front().size();
    levels_.front().push_back(box);
    for (std::size_t level = 1; index >= kRun || level < levels_.size(); ++level) {
      index /= kRun;
      if (level == levels_.size()) {
        levels_.push_back({*bounds(std::span(levels_[level - 1]).first(kRun))});
      }
      std::vector<Aabb>& runs = levels_[level];
      if (index == runs.size()) {
        runs.push_back(box);
      } else {
        runs[index] = merged(runs[index], box);
      }
    }
  }
}

std::vector<Aabb> BoxRuns::as_high_as(const Aabb& region) const {
  std::vector<Aabb> out;
  look_up(region, levels_.size() - 1, 0, levels_.back().size(), out);
  return out;
}

void BoxRuns::look_up(const Aabb& region, std::size_t level, std::size_t first, std::size_t last,
                      std::vector<Aabb>& out) const {
  const std::vector<Aabb>& list = levels_[level];
  for (std::size_t i = first; i < std::min(last, list.size()); ++i) {
    if (!is_as_high(list[i], region)) continue;
    if (level == 0) {
      out.push_back(list[i]);
    } else {
      look_up(region, level - 1, i * kRun, (i + 1) * kRun, out);
    }
  }
}

}  // namespace geom
