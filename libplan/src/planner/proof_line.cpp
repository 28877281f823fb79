#include "plan/planner/proof_line.h"

#include <utility>

#include "plan/bound/bound_record.h"
#include "plan/reach/enclosure_record.h"

namespace plan {

std::string proof_line(const geom::CollisionScene& scene, const geom::PlanQuery& query,
                       PlanResult result) {
  const geom::Vec3 from = result.snapped_start.value_or(query.from);
  const geom::Vec3 to = result.snapped_goal.value_or(query.to);
  const geom::Aabb& bounds = scene.map().spec().bounds;
  if (result.enclosure) {
    return to_json_line(EnclosureRecord{query.id, from, to, std::move(*result.enclosure), bounds,
                                        geom::provenance_of(scene)});
  }
  if (!result.bound || !result.bound->proof) return "";
  return to_json_line(BoundRecord{query.id, from, to, result.bound->bound,
                                  std::move(*result.bound->proof), bounds,
                                  geom::provenance_of(scene)});
}

}  // namespace plan
