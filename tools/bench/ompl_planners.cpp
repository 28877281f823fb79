#include "ompl_planners.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

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
  ExactMotion(const ob::SpaceInformationPtr& space, const OmplProblem& problem)
      : MotionValidator(space), is_free_(problem.is_segment_free) {}

  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    const bool free = is_free_(position(a), position(b));
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
  std::function<bool(const geom::Vec3&, const geom::Vec3&)> is_free_;
};

ob::StateSpacePtr space_of(const geom::Aabb& box) {
  auto space = std::make_shared<Space>(3);
  ob::RealVectorBounds bounds(3);
  for (unsigned k = 0; k < 3; ++k) {
    bounds.setLow(k, box.min[k]);
    bounds.setHigh(k, box.max[k]);
  }
  space->setBounds(bounds);
  return space;
}

class Adapter {
 public:
  Adapter(const OmplProblem& problem, OmplPlanner planner)
      : planner_(planner), seconds_(problem.seconds), setup_(space_of(problem.bounds)) {
    const ob::SpaceInformationPtr& space = setup_.getSpaceInformation();
    setup_.setStateValidityChecker([is_free = problem.is_point_free](const ob::State* state) {
      return is_free(position(state));
    });
    space->setMotionValidator(std::make_shared<ExactMotion>(space, problem));
    if (planner == OmplPlanner::rrt_connect) {
      setup_.setPlanner(std::make_shared<og::RRTConnect>(space));
    } else {
      setup_.setPlanner(std::make_shared<og::InformedRRTstar>(space));
    }
  }

  plan::bench::Answer plan(const geom::PlanQuery& query) {
    setup_.clear();
    ob::ScopedState<Space> start(setup_.getStateSpace());
    ob::ScopedState<Space> goal(setup_.getStateSpace());
    for (unsigned k = 0; k < 3; ++k) {
      start[k] = query.from[k];
      goal[k] = query.to[k];
    }
    setup_.setStartAndGoalStates(start, goal);
    if (planner_ == OmplPlanner::rrt_connect) {
      setup_.solve(seconds_);  // wall: it stops at its first path, and a CPU clock costs more
    } else {
      const double end = geom::thread_seconds() + seconds_;
      setup_.solve(
          ob::PlannerTerminationCondition([end] { return geom::thread_seconds() >= end; }));
    }
    if (!setup_.haveExactSolutionPath()) return {geom::PathStatus::stopped, {}, std::nullopt};
    if (planner_ == OmplPlanner::rrt_connect) setup_.simplifySolution();
    plan::bench::Answer answer{geom::PathStatus::found, {}, std::nullopt};
    for (const ob::State* state : setup_.getSolutionPath().getStates()) {
      answer.path.push_back(position(state));
    }
    return answer;
  }

 private:
  OmplPlanner planner_;
  double seconds_;
  og::SimpleSetup setup_;
};

}  // namespace
}  // namespace bench

void skyway_ompl_method(const bench::OmplProblem& problem, bench::OmplPlanner planner,
                        plan::bench::Method& out) {
  ompl::msg::noOutputHandler();
  constexpr std::uint64_t kSeeds = 0xffffffff;  // 0 means the clock
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(problem.seed % kSeeds + 1));
  const auto adapter = std::make_shared<bench::Adapter>(problem, planner);
  out = [adapter](const geom::PlanQuery& query) { return adapter->plan(query); };
}
