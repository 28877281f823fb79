#include "traj/together/spacing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/base/rounding.h"
#include "geom/base/usage_error.h"

namespace traj {

Zone cylinder(double across, double up) { return {true, {across, across, up}}; }

std::vector<Zone> zones_between(const Spacing& spacing, const Vec3& room, const Vec3& other) {
  std::vector<Zone> zones;
  if (spacing.zone) {
    zones.push_back(*spacing.zone);
  } else {
    Zone sum;
    for (int axis = 0; axis < 3; ++axis) sum.reach[axis] = geom::add_up(room[axis], other[axis]);
    zones.push_back(sum);
  }
  if (spacing.downwash) zones.push_back(*spacing.downwash);
  return zones;
}

Vec3 reach_of(const Spacing& spacing, const Vec3& room) {
  Vec3 reach = spacing.zone ? Vec3(0.5 * spacing.zone->reach) : room;
  if (spacing.downwash) reach = reach.cwiseMax(0.5 * spacing.downwash->reach);
  return reach * (1 + 0x1p-50);  // more than zones_between() rounds sums up
}

std::optional<geom::Fault> spacing_fault(const Zone& zone) {
  for (const double reach : zone.reach) {
    if (reach > 0 && reach <= geom::kLargestCoordinate) continue;
    return geom::Fault{
        .expected = fmt::format("metres above 0 and at most {:g}", geom::kLargestCoordinate),
        .found = fmt::to_string(reach)};
  }
  return std::nullopt;
}

void VehiclesInZone::add(const std::string& id, const Vec3& half) {
  if (!zone_) return;
  for (int axis = 0; axis < 3; ++axis) {
    Largest& largest = largest_[static_cast<std::size_t>(axis)];
    const double both = geom::add_up(largest.half, half[axis]);
    if (!largest.id.empty() && largest.id != id && zone_->reach[axis] < both) {
      throw geom::UsageError(sentence(geom::Fault{
          .item = "--separation",
          .expected = fmt::format("at least {:g} m {}, as the vehicles of \"{}\" and \"{}\" are so "
                                  "large together",
                                  both, axis == 2 ? "in height" : "across", largest.id, id),
          .found = fmt::format("{:g} m", zone_->reach[axis]),
          .advice = "give more, or leave the option out: then boxes of vehicles and margins keep "
                    "apart"}));
    }
    if (largest.id.empty() || half[axis] > largest.half) largest = {half[axis], id};
  }
}

double share_of(const Zone& zone, const Vec3& d) {
  if (zone.round) {
    return std::max(std::hypot(d.x(), d.y()) / zone.reach.x(), std::abs(d.z()) / zone.reach.z());
  }
  return (d.cwiseAbs().array() / zone.reach.array()).maxCoeff();
}

double depth_in(const Zone& zone, const Vec3& d) {
  if (!zone.round) return (zone.reach - d.cwiseAbs()).minCoeff();
  return std::min(zone.reach.x() - std::hypot(d.x(), d.y()), zone.reach.z() - std::abs(d.z()));
}

}  // namespace traj
