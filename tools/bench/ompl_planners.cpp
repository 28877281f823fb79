#include "ompl_planners.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "geom/base/error.h"
#include "geom/base/thread_seconds.h"

namespace bench {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

using Space = ob::RealVectorStateSpace;

geom::Vec3 position(const ob::State* state) {
  const double* values = state->as<Space::StateType>()->values;
  return {values[0], values[1], values[2]};
}

// Edges are decided exactly, not by states along them.
class ExactMotion : public ob::MotionValidator {
 public:
  ExactMotion(const ob::SpaceInformationPtr& space, const geom::CollisionScene& scene)
      : MotionValidator(space), scene_(scene) {}

  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    const bool free = scene_.free(position(a), position(b));
    ++(free ? valid_ : invalid_);
    return free;
  }

  // The start of a blocked motion stands for its last valid state.
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last) const override {
    if (checkMotion(a, b)) return true;
    if (last.first) si_->copyState(last.first, a);
    last.second = 0;
    return false;
  }

 private:
  const geom::CollisionScene& scene_;
};

ob::StateSpacePtr space_of(const geom::CollisionScene& scene) {
  if (!scene.free_bounds()) {
    throw geom::InputError("map",
                           {.says = "the vehicle does not fit between the bounds of the map"});
  }
  auto space = std::make_shared<Space>(3);
  ob::RealVectorBounds bounds(3);
  for (unsigned k = 0; k < 3; ++k) {
    bounds.setLow(k, scene.free_bounds()->min[k]);
    bounds.setHigh(k, scene.free_bounds()->max[k]);
  }
  space->setBounds(bounds);
  return space;
}

}  // namespace

struct OmplAdapter::Impl {
  OmplPlanner planner;
  double seconds;
  og::SimpleSetup setup;

  Impl(const geom::CollisionScene& scene, OmplPlanner which, double limit)
      : planner(which), seconds(limit), setup(space_of(scene)) {
    const ob::SpaceInformationPtr& space = setup.getSpaceInformation();
    setup.setStateValidityChecker(
        [&scene](const ob::State* state) { return scene.free(position(state)); });
    space->setMotionValidator(std::make_shared<ExactMotion>(space, scene));
    if (planner == OmplPlanner::rrt_connect) {
      setup.setPlanner(std::make_shared<og::RRTConnect>(space));
    } else {
      setup.setPlanner(std::make_shared<og::InformedRRTstar>(space));
    }
  }
};

OmplAdapter::OmplAdapter(const geom::CollisionScene& scene, OmplPlanner planner, double seconds,
                         std::uint64_t seed) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed % 0xffffffffu + 1));  // 0 means the clock
  impl_ = std::make_unique<Impl>(scene, planner, seconds);
}

OmplAdapter::~OmplAdapter() = default;

plan::bench::Answer OmplAdapter::plan(const geom::PlanQuery& query) {
  og::SimpleSetup& setup = impl_->setup;
  setup.clear();
  ob::ScopedState<Space> start(setup.getStateSpace());
  ob::ScopedState<Space> goal(setup.getStateSpace());
  for (unsigned k = 0; k < 3; ++k) {
    start[k] = query.from[k];
    goal[k] = query.to[k];
  }
  setup.setStartAndGoalStates(start, goal);
  if (impl_->planner == OmplPlanner::rrt_connect) {
    setup.solve(impl_->seconds);  // wall: it stops at its first path, and a CPU clock costs more
  } else {
    const double end = geom::thread_seconds() + impl_->seconds;
    setup.solve(ob::PlannerTerminationCondition([end] { return geom::thread_seconds() >= end; }));
  }
  if (!setup.haveExactSolutionPath()) return {geom::PathStatus::stopped, {}, std::nullopt};
  if (impl_->planner == OmplPlanner::rrt_connect) setup.simplifySolution();
  plan::bench::Answer answer{geom::PathStatus::found, {}, std::nullopt};
  for (const ob::State* state : setup.getSolutionPath().getStates()) {
    answer.path.push_back(position(state));
  }
  return answer;
}

}  // namespace bench
