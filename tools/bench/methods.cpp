#include "methods.h"

#include <memory>
#ifdef SKYWAY_OMPL
#include "ompl_planners.h"
#endif

namespace bench {
namespace {

#ifdef SKYWAY_OMPL
template <OmplPlanner planner>
plan::bench::Method ompl(const geom::CollisionScene& scene,
                         const plan::bench::MethodOptions& options) {
  const auto adapter = std::make_shared<OmplAdapter>(scene, planner, options.seconds, options.seed);
  return [adapter](const geom::PlanQuery& query) { return adapter->plan(query); };
}
#endif

}  // namespace

std::vector<plan::bench::KnownMethod> methods() {
  std::vector<plan::bench::KnownMethod> out = plan::bench::known_methods();
#ifdef SKYWAY_OMPL
  out.push_back({"rrt-connect-ompl", ompl<OmplPlanner::rrt_connect>});
  out.push_back({"informed-rrt-star-ompl", ompl<OmplPlanner::informed_rrt_star>});
#endif
  return out;
}

}  // namespace bench
