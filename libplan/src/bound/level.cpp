#include "level.h"

#include <limits>

namespace plan {
namespace {

EdgePart place(const Vec3& p) { return {p, p, kCorner, {}}; }

}  // namespace

Level first_level(const std::vector<EdgePart>& parts, const Vec3& from, const Vec3& to,
                  double target, double slack) {
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
  for (const EdgePart& part : parts) {
    const double come = least_distance(start, part);
    const double go = least_distance(part, goal);
    if (come + go < target) add(part, come, go);
  }
  level.links.resize(level.parts.size());
  level.hints.resize(level.parts.size());
  level.linked.assign(level.parts.size(), std::numeric_limits<double>::infinity());
  return level;
}

}  // namespace plan
