#include "traj/home/return_heights.h"

#include <algorithm>

namespace traj {
namespace {

constexpr double kLeastSlope = 0.5;  // of ArduPilot's cone: RTL_MIN_CONE_SLOPE
constexpr double kFlatCone = 0.018;  // slope of a cone of 90 degrees, which PX4 1.11 leaves out

// Each of these grows with the distance.

double ardupilot_height(const ReturnModel& model, double full, double away) {
  return model.slope >= kLeastSlope ? std::min(full, model.slope * away) : full;
}

double px4_1_11_height(const ReturnModel& model, double full, double away) {
  const double descend = model.cone.descend;
  if (away <= model.cone.near) return descend;
  if (model.slope <= 0) return std::max(full, descend);
  if (model.slope < kFlatCone) return descend;
  return std::max(std::min(model.slope * away, full), descend);
}

// With this radius of acceptance, the greatest; and the least with any that is smaller.
double px4_1_12_height(const ReturnModel& model, double full, double away) {
  if (away <= model.acceptance) return std::min(2 * away, full);
  const double cone = away <= model.cone.near && model.slope > 0 ? model.slope * away : full;
  return std::min(full, std::max(cone, 2 * model.acceptance));
}

double least_px4_1_12_height(const ReturnModel& model, double full, double away) {
  const double cone = away <= model.cone.near && model.slope > 0 ? model.slope * away : full;
  return std::min({full, cone, away <= model.acceptance ? 2 * away : full});
}

}  // namespace

HeightRange return_heights(const ReturnModel& model, double full, double nearest, double furthest) {
  HeightRange out{full, 0};
  const auto add = [&](auto low, auto high) {
    out.least = std::min(out.least, low(model, full, nearest));
    out.most = std::max(out.most, high(model, full, furthest));
  };
  const ReturnCone& cone = model.cone;
  if (!cone.px4_1_11 && !cone.px4_1_12) add(ardupilot_height, ardupilot_height);
  if (cone.px4_1_11) add(px4_1_11_height, px4_1_11_height);
  if (cone.px4_1_12) add(least_px4_1_12_height, px4_1_12_height);
  if (cone.px4_1_12 && model.slope <= 0) out.most = std::max(out.most, full);
  if (cone.above_height) {
    out.most = std::max(out.most, 2 * std::min(furthest, model.acceptance));
  }
  if (model.low_within > 0) out.most = full;
  if (nearest < model.low_within) out.least = 0;
  return out;
}

}  // namespace traj
