#include "level.h"

#include <algorithm>
#include <limits>

namespace plan {
namespace {

constexpr std::uint32_t kGroup = 16;

EdgePart place(const Vec3& p) { return {p, p, kCorner, {}}; }

std::vector<PartGroup> groups_of(const Level& level) {
  std::vector<PartGroup> out;
  for (std::uint32_t i = 0; i < level.parts.size(); ++i) {
    const geom::Aabb box{level.parts[i].low, level.parts[i].high};
    const double go = least(level.go, i);
    const bool is_end = i == kStart || i == kGoal;
    if (is_end || (i - kGoal - 1) % kGroup == 0) out.push_back({box, go, i});
    PartGroup& group = out.back();
    group = {geom::merged(group.box, box), std::min(group.go, go), i + 1};
  }
  return out;
}

}  // namespace

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
  level.groups = groups_of(level);
  level.links.resize(level.parts.size());
  level.hints.assign(level.parts.size(), kNoHints);
  level.linked.assign(level.parts.size(), std::numeric_limits<double>::infinity());
  return level;
}

}  // namespace plan
