#include "traj/submit/risk_rules.h"

#include <cmath>

#include "curve/portable_math.h"
#include "geom/vehicle/limits.h"

namespace traj {
namespace {

using geom::kGravity;

constexpr double kAbove = 1 + 1e-12;  // more than the few operations of a formula round by

// A vehicle that goes level turns its speed upward: of a climb at 45 degrees, rounded up.
constexpr double kClimbShare = 0.7072;

constexpr std::string_view kTerm = "term of SORA 2.5";
constexpr std::string_view kSize = "term of SORA 2.5; size after the guideline of LBA (Germany)";

}  // namespace

ContingencySize contingency_size(const RiskRules& rules, double speed) {
  if (rules.contingency == ContingencyRule::ways_home) return {};
  const double errors = rules.position_error + rules.holding_error + rules.map_error;
  const double stop = speed * speed / (2 * kGravity * tangent_below(rules.tilt));
  const double rise = speed * speed / (2 * kGravity);
  return {(errors + speed * rules.reaction + stop) * kAbove,
          (rules.altitude_error + kClimbShare * speed * rules.reaction + rise) * kAbove};
}

double ground_buffer(const RiskRules& rules, double speed, double height) {
  const double half = rules.dimension / 2;
  if (rules.buffer == BufferRule::one_to_one) return height + half;
  return (speed * std::sqrt(2 * height / kGravity) + half) * kAbove;
}

double least_geography(const RiskRules& rules) { return 3 * rules.dimension; }

std::vector<RiskFormula> formulas(const RiskRules& rules) {
  std::vector<RiskFormula> out{
      {"flight geography",
       rules.geography == GeographyRule::proved_tube
           ? "the volumes that hold the simulated vehicle in its proved tube, and the stated "
             "buffer, "
             "at every instant"
           : "the volumes that hold the vehicle with its margin and the stated buffer at every "
             "instant",
       kTerm}};
  if (rules.contingency == ContingencyRule::stop) {
    out.push_back({"contingency volume, across",
                   "S_CV = S_GNSS + S_Pos + S_K + V t + V^2 / (2 g tan(tilt))", kSize});
    out.push_back(
        {"contingency volume, vertical", "H_CM = H_err + 0.7072 V t + V^2 / (2 g)", kSize});
  } else {
    out.push_back({"contingency volume",
                   "all places of the autopilot's own return, from every instant of the flight, "
                   "beside the flight geography",
                   kTerm});
  }
  if (rules.buffer == BufferRule::one_to_one) {
    out.push_back({"ground risk buffer", "S_GRB = H_CV + CD / 2 (1:1 rule)", kSize});
  } else {
    out.push_back({"ground risk buffer",
                   "S_GRB = V sqrt(2 H_CV / g) + CD / 2 (ballistic, without drag and wind)",
                   kSize});
  }
  return out;
}

}  // namespace traj
