#include "plan/planner/moved_ends.h"

#include <fmt/format.h>

#include "plan/planner/snap_end.h"

namespace plan {
namespace {

constexpr double kRounding = 1e-9;  // metres

std::string moved_end(const geom::CollisionScene& scene, const std::string& id, const char* end,
                      const geom::Vec3& from, const geom::Vec3& to) {
  const char* why = scene.inside_bounds(from) ? "inside an obstacle" : "outside the bounds";
  std::string said =
      fmt::format("{}: the {} was {} and was moved {:.3f} m, to ({:.3f}, {:.3f}, {:.3f})", id, end,
                  why, (to - from).norm(), to[0], to[1], to[2]);
  if (!has_room(scene, to, kSnapRoom - kRounding)) {
    said += fmt::format(
        "; there is less than {} m to spare, and drone files that round may be "
        "refused",
        kSnapRoom);
  }
  return said;
}

}  // namespace

std::vector<std::string> moved_ends(const geom::CollisionScene& scene, const geom::PlanQuery& query,
                                    const PlanResult& result) {
  std::vector<std::string> said;
  if (result.snapped_start) {
    said.push_back(moved_end(scene, query.id, "start", query.from, *result.snapped_start));
  }
  if (result.snapped_goal) {
    said.push_back(moved_end(scene, query.id, "goal", query.to, *result.snapped_goal));
  }
  return said;
}

}  // namespace plan
