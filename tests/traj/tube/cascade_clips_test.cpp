#include "tube/cascade_clips.h"

#include <gtest/gtest.h>

#include "step_case.h"

namespace traj {
namespace {

using Kind = TubeTrouble::Kind;
using Model = CascadeRows::Model;
using Step = CascadeStep<Model>;

CascadeLoop limited_loop() {
  const FlightOptions options = testing::flight_of("quad2kg", ControlLaw::cascade);
  CascadeLoop loop{options.quadrotor, options.gains, options.periods, {1, 0}};
  loop.gains.position.clip = 3;  // m/s
  loop.gains.velocity.clip = 4;  // m/s2
  loop.gains.rates.clip = 50;    // rad/s2
  return loop;
}

// It hovers, and the position loop runs in the third millisecond.
Step hover(const CascadeLoop& loop) {
  Step step;
  const double each = loop.model.mass * 9.80665 / 4;
  step.commands.assign(4, {each, each, each, each});
  step.turns.resize(4);
  PositionRun<Model> run;
  run.millisecond = 2;
  run.lift.z = 9.80665;
  step.runs = {run};
  return step;
}

std::optional<TubeTrouble> met(const CascadeLoop& loop, const Step& step) {
  return first_clip(loop, step, [](const Model& m) { return m.radius(); });
}

TEST(CascadeClips, AreNotMetInHover) {
  const CascadeLoop loop = limited_loop();
  EXPECT_FALSE(met(loop, hover(loop)));
}

// Each quantity in turn: just within its limit, and just beyond it, at either end of what it may
// be.
TEST(CascadeClips, OfEachQuantityAreFound) {
  const CascadeLoop loop = limited_loop();
  const double most_lift = 4 * loop.model.motor_most / loop.model.mass;
  const double lean = 9.80665 * std::tan(loop.gains.tilt_max);
  struct Case {
    Kind kind;
    double limit;
    std::function<Model&(Step&)> of;
    double time;
  };
  const auto run = [](Step& s) -> PositionRun<Model>& { return s.runs[0]; };
  const Case cases[] = {
      {Kind::velocity, 3, [&](Step& s) -> Model& { return run(s).velocity.y; }, 2e-3},
      {Kind::acceleration, 4, [&](Step& s) -> Model& { return run(s).before.x; }, 2e-3},
      {Kind::acceleration, -4, [&](Step& s) -> Model& { return run(s).acceleration.z; }, 2e-3},
      {Kind::lift, most_lift, [&](Step& s) -> Model& { return run(s).lift.z; }, 2e-3},
      {Kind::lift, 0.3 * 9.80665, [&](Step& s) -> Model& { return run(s).lift.z; }, 2e-3},
      {Kind::lean, -lean, [&](Step& s) -> Model& { return run(s).lift.x; }, 2e-3},
      {Kind::rates, loop.model.body_rate_max.z(), [](Step& s) -> Model& { return s.rates.z; }, 0},
      {Kind::motor, loop.model.motor_most, [](Step& s) -> Model& { return s.commands[3][1]; },
       3e-3},
      {Kind::motor, loop.model.motor_least, [](Step& s) -> Model& { return s.commands[1][3]; },
       1e-3},
      {Kind::turn, 50, [](Step& s) -> Model& { return s.turns[3].before.x; }, 3e-3},
      {Kind::turn, -50, [](Step& s) -> Model& { return s.turns[0].spin.z; }, 0},
  };
  for (const Case& one : cases) {
    const double middle = one.of(*std::make_unique<Step>(hover(loop))).c;
    const double way = one.limit - middle;
    for (const double share :
         {0.5, 0.99}) {  // of the way that the middle goes, the radius the rest
      Step step = hover(loop);
      one.of(step) = Model::within(middle + share * way, (1 - share - 1e-6) * std::abs(way));
      EXPECT_FALSE(met(loop, step)) << one.limit;
      one.of(step) = Model::within(middle + share * way, (1 - share + 1e-6) * std::abs(way));
      const auto trouble = met(loop, step);
      ASSERT_TRUE(trouble) << one.limit;
      EXPECT_EQ(trouble->kind, one.kind) << one.limit;
      EXPECT_EQ(trouble->time, one.time) << one.limit;
      EXPECT_LE(trouble->room, 0);
    }
  }
}

// The lift is at its most in any direction.
TEST(CascadeClips, OfALeaningLiftAreFound) {
  CascadeLoop loop = limited_loop();
  loop.gains.tilt_max = 1.4;
  const double most = 4 * loop.model.motor_most / loop.model.mass;
  Step step = hover(loop);
  step.runs[0].lift.x = 0.8 * most;
  step.runs[0].lift.z = 0.599 * most;
  EXPECT_FALSE(met(loop, step));
  step.runs[0].lift.z = 0.601 * most;
  ASSERT_TRUE(met(loop, step));
  EXPECT_EQ(met(loop, step)->kind, Kind::lift);
}

TEST(CascadeClips, OfWhatIsNotFiniteAreTilts) {
  const CascadeLoop loop = limited_loop();
  Step step = hover(loop);
  step.commands[2][0] = Model::within(1, std::numeric_limits<double>::infinity());
  ASSERT_TRUE(met(loop, step));
  EXPECT_EQ(met(loop, step)->kind, Kind::tilt);
  step = hover(loop);
  step.runs[0].lift.y = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(met(loop, step));
}

}  // namespace
}  // namespace traj
