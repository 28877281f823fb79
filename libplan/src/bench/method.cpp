#include "plan/bench/method.h"

#include <functional>
#include <memory>

#include "plan/lattice/fitting_length.h"
#include "plan/lattice/visible_nodes.h"

namespace plan::bench {
namespace {

using geom::CollisionScene;
using geom::PlanQuery;

// std::function copies what it holds, so what a planner keeps between queries is shared.

Method automatic(const CollisionScene& scene, const MethodOptions& options) {
  const auto planner = std::make_shared<plan::Planner>(scene, options.lattice, options.roadmap);
  plan::PlanOptions plan_options;
  plan_options.quality = options.quality;
  return [planner, plan_options](const PlanQuery& query) -> Answer {
    plan::PlanResult result = planner->plan(query.from, query.to, plan_options);
    return {result.status, std::move(result.path), result.expanded};
  };
}

plan::LatticeSpec spec_for(const CollisionScene& scene, const MethodOptions& options) {
  plan::LatticeSpec spec = options.spec;
  if (options.spacing) {
    spec.spacing = *options.spacing;
  } else if (scene.free_bounds()) {
    spec.spacing = plan::fitting_length(*scene.free_bounds(), spec.spacing);
  }
  return spec;
}

// A* on one lattice, nothing before and nothing after it.
class Astar {
 public:
  Astar(const CollisionScene& scene, const MethodOptions& options)
      : scene_(scene),
        lattice_(plan::build_lattice(scene, spec_for(scene, options), options.build)),
        search_(lattice_) {}

  Answer plan(const PlanQuery& query) {
    plan::SearchResult result;
    std::size_t expanded = 0;
    for (const plan::Rings rings : {plan::Rings::nearest, plan::Rings::all}) {
      result = search_.search(plan::visible_nodes(scene_, lattice_, search_, query.from, rings),
                              plan::visible_nodes(scene_, lattice_, search_, query.to, rings));
      expanded += result.expanded;
      if (result.found || result.gave_up) break;
    }
    if (!result.found)
      return {
          result.gave_up ? geom::PathStatus::stopped : geom::PathStatus::unreachable, {}, expanded};
    geom::Polyline path = {query.from};
    for (const std::size_t node : result.nodes) path.push_back(lattice_.position(node));
    path.push_back(query.to);
    return {geom::PathStatus::found, std::move(path), expanded};
  }

 private:
  const CollisionScene& scene_;
  plan::Lattice lattice_;
  plan::AstarSearch search_;
};

Method astar(const CollisionScene& scene, const MethodOptions& options) {
  const auto search = std::make_shared<Astar>(scene, options);
  return [search](const PlanQuery& query) { return search->plan(query); };
}

// Shortened and pulled taut, as skyway-plan does.
Method sampling(plan::SamplingMethod method, const CollisionScene& scene,
                const MethodOptions& options) {
  const auto planner = std::make_shared<plan::Planner>(scene, nullptr);
  plan::PlanOptions plan_options;
  plan_options.method = method;
  plan_options.sampling.seed = options.seed + 1;
  return [planner, plan_options](const PlanQuery& query) -> Answer {
    plan::PlanResult result = planner->plan(query.from, query.to, plan_options);
    return {result.status, std::move(result.path), result.expanded};
  };
}

std::vector<KnownMethod> all_methods() {
  std::vector<KnownMethod> out = {{name(plan::kAutomatic), automatic},
                                  {name(plan::kAstar), astar, true}};
  for (const auto& [method, word] : plan::kSamplingWords) {
    out.push_back({word, std::bind_front(sampling, method)});
  }
  return out;
}

}  // namespace

const std::vector<KnownMethod>& known_methods() {
  static const std::vector<KnownMethod> kMethods = all_methods();
  return kMethods;
}

}  // namespace plan::bench
