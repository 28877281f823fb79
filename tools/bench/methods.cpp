#include "methods.h"

#ifdef SKYWAY_OMPL
#include "geom/base/error.h"
#include "geom/base/loaded_library.h"
#include "ompl_planners.h"
#endif

namespace bench {
namespace {

#ifdef SKYWAY_OMPL
template <OmplPlanner planner>
plan::bench::Method ompl(const geom::CollisionScene& scene,
                         const plan::bench::MethodOptions& options) {
  if (!scene.free_bounds()) {
    throw geom::InputError("map",
                           {.says = "the vehicle does not fit between the bounds of the map"});
  }
  const geom::LoadedLibrary module(SKYWAY_OMPL, "skyway");
  const auto make = SKYWAY_FUNCTION(module, skyway_ompl_method);
  plan::bench::Method out;
  make({.bounds = *scene.free_bounds(),
        .is_point_free = [&scene](const geom::Vec3& p) { return scene.free(p); },
        .is_segment_free = [&scene](const geom::Vec3& a,
                                    const geom::Vec3& b) { return scene.free(a, b); },
        .seconds = options.seconds,
        .seed = options.seed},
       planner, out);
  return out;
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
