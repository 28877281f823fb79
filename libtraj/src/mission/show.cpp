#include "traj/mission/show.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "geom/base/rounding.h"
#include "traj/mission/read_mission.h"
#include "traj/together/check_together.h"

namespace traj {
namespace {

Vec3 sum_above(const Vec3& a, const Vec3& b) {
  return (a + b).unaryExpr([](double v) { return geom::next_up(v); });
}

Vec3 stray_of(const FlownCurve& flown) {
  Vec3 most = Vec3::Zero();
  for (const Stray& stray : flown.stray) most = most.cwiseMax(stray.position);
  return most;
}

// Zones grown by what both files' rounding adds; rooms have it already.
Spacing with_stray(Spacing spacing, const Vec3& stray) {
  const double across = geom::next_up(std::hypot(stray.x(), stray.y()));
  for (auto* zone : {&spacing.zone, &spacing.downwash}) {
    if (!*zone) continue;
    const Vec3 more = (*zone)->round ? Vec3(across, across, stray.z()) : stray;
    (*zone)->reach = sum_above((*zone)->reach, 2 * more);
  }
  return spacing;
}

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

// YAML 1.1 takes a number with an exponent and no point for a text.
std::string number(double value) {
  std::string text = fmt::format("{}", value);
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && text.find('.') == std::string::npos) {
    text.insert(exponent, ".0");
  }
  return text;
}

std::string point(const Vec3& p) {
  return fmt::format("[{}, {}, {}]", number(p.x()), number(p.y()), number(p.z()));
}

std::string spacing_words(const ShowClaim& claim) {
  if (!claim.spacing.zone) {
    return claim.spare > 0
               ? fmt::format("the vehicles' boxes with their margins less {} m", claim.spare)
               : "the vehicles' boxes with their margins";
  }
  const Vec3& reach = claim.spacing.zone->reach;
  return claim.spacing.zone->round
             ? fmt::format("{} m across or {} m in height", reach.x(), reach.z())
             : fmt::format("{} m along x, {} m along y or {} m in height", reach.x(), reach.y(),
                           reach.z());
}

std::string head_of(const ShowClaim& claim, const std::optional<std::string>& epoch) {
  std::string out = "# When each file of this folder begins, in seconds after one instant.\n";
  if (!claim.checked) {
    out += "# UNCHECKED: not compared with any map, nor with one another.\n";
  } else {
    out += fmt::format("# Proved clear of the map, and apart by {}, while they begin so.\n",
                       spacing_words(claim));
    if (claim.parked == Parked::gone) {
      out += "# Only in flight: one that stands before or after was not looked at.\n";
    }
  }
  out += fmt::format("checked: {}\n", claim.checked);
  if (epoch) out += fmt::format("epoch: {}\n", quoted(*epoch));
  return out;
}

}  // namespace

ShowFlight read_back(ShowFlight flight, const geom::CollisionScene& scene,
                     const MissionFormat& format, const WrittenMission& written) {
  const auto read =
      read_mission(written.text, flight.file, format, written.reading, scene.map().spec().frame);
  const auto& flown = std::get<FlownCurve>(read.front().flown.way);
  flight.stray = stray_of(flown);
  flight.room = sum_above(scene.half(), flight.stray);
  flight.vehicle = scene.vehicle().half;
  flight.flown = flown.trajectory;
  return flight;
}

ShowCheck check_show(std::span<const ShowFlight> flights, const Spacing& spacing, Parked parked,
                     const geom::Execution& run) {
  std::vector<TimedFlight> timed;
  Vec3 stray = Vec3::Zero();
  ShowCheck out;
  VehiclesInZone vehicles(spacing.zone);
  for (const ShowFlight& one : flights) {
    vehicles.add(one.id, one.vehicle);
    timed.push_back({&one.flown, one.time.starts(), one.room});
    stray = stray.cwiseMax(one.stray);
    out.task.ids.push_back(one.id);
  }
  out.task.rule.spacing = with_stray(spacing, stray);
  out.task.rule.parked = parked;
  out.result = check_together(timed, out.task.rule, run);
  return out;
}

std::string show_yaml(std::span<const ShowFlight> flights, const ShowClaim& claim) {
  std::vector<const ShowFlight*> order;
  for (const ShowFlight& one : flights) order.push_back(&one);
  std::stable_sort(order.begin(), order.end(), [](const ShowFlight* a, const ShowFlight* b) {
    return a->time.starts() < b->time.starts();
  });
  std::string out = head_of(claim, flights.front().time.epoch) + "flights:\n";
  for (const ShowFlight* one : order) {
    const auto& segments = one->planned.segments;
    out +=
        fmt::format("  - id: {}\n    file: {}\n    start: {}\n    duration: {}\n", quoted(one->id),
                    quoted(one->file), number(one->time.starts()), number(duration(one->planned)));
    out += fmt::format("    initial_position: {}\n    final_position: {}\n",
                       point(segments.front().point.front()), point(segments.back().point.back()));
  }
  return out;
}

}  // namespace traj
