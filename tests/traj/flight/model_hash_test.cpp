#include "traj/flight/model_hash.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

TEST(ModelHash, SeesWhatFliesAlone) {
  const FlightOptions options;
  const std::string hash = model_hash(options);
  EXPECT_EQ(hash.size(), 64u);
  FlightOptions other = options;
  other.mass_error = 0.1;
  other.wind.mean = {1, 2, 3};
  other.seed = 7;
  EXPECT_EQ(model_hash(other), hash);
}

TEST(ModelHash, SeesGainsLoopsControllerAndQuadrotor) {
  const FlightOptions options;
  FlightOptions gains = options, loops = options, law = options, mass = options;
  gains.gains.velocity.d.z() = 0.125;
  loops.periods.position = 20;
  law.law = ControlLaw::geometric;
  mass.quadrotor.mass = 2;
  for (const FlightOptions& other : {gains, loops, law, mass}) {
    EXPECT_NE(model_hash(other), model_hash(options));
  }
}

}  // namespace
}  // namespace traj
