#include "level.h"

#include <limits>

namespace plan {
namespace {

EdgePart place(const Vec3& p) { return {p, p, kCorner, {}}; }

}  // namespace

void PartBoxes::add(const EdgePart& part, double to_goal) {
  go.push_back(to_goal);
  for (int k = 0; k < 3; ++k) {
    low[k].push_back(part.low[k]);
    high[k].push_back(part.high[k]);
  }
}

void PartBoxes::squares(const EdgePart& from, std::vector<double>& out) const {
  const std::size_t count = low[0].size();
  out.resize(count);
  const double* const lows[3] = {low[0].data(), low[1].data(), low[2].data()};
  const double* const highs[3] = {high[0].data(), high[1].data(), high[2].data()};
  double* const d = out.data();
  const Vec3 a = from.low;
  const Vec3 b = from.high;
  const auto gap = [&](int k, std::size_t i) {
    const double above = lows[k][i] - b[k];
    const double below = a[k] - highs[k][i];
    const double most = above > below ? above : below;
    return most > 0 ? most : 0.0;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const double x = gap(0, i);
    const double y = gap(1, i);
    const double z = gap(2, i);
    d[i] = x * x + y * y + z * z;
  }
}

Level first_level(const PartTree& parts, const Vec3& from, const Vec3& to, double target,
                  double slack) {
  Level level;
  const EdgePart start = place(from);
  const EdgePart goal = place(to);
  const auto add = [&](const EdgePart& part, double come, double go) {
    const LineLabel g = carried(start, {0, 0}, part, come, slack);
    const LineLabel h = carried(goal, {0, 0}, part, go, slack);
    level.parts.push_back(part);
    for (int side = 0; side < 2; ++side) {
      const bool used = side == 0 || !part.is_corner();
      level.come.push_back(used ? g : LineLabel{});
      level.go.push_back(used ? h : LineLabel{});
    }
  };
  const double straight = (to - from).norm();
  add(start, 0, straight);
  add(goal, straight, 0);
  level.come[2 * kStart] = level.go[2 * kGoal] = {0, 0};
  for (const std::uint32_t i : parts.within(from, to, target)) {
    const EdgePart& part = parts.parts()[i];
    add(part, least_distance(start, part), least_distance(part, goal));
  }
  for (std::uint32_t i = 0; i < level.parts.size(); ++i) {
    level.boxes.add(level.parts[i], least(level.go, i));
  }
  level.links.resize(level.parts.size());
  level.hints.assign(level.parts.size(), kNoHints);
  level.linked.assign(level.parts.size(), std::numeric_limits<double>::infinity());
  return level;
}

}  // namespace plan
