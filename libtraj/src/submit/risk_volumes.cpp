#include "traj/submit/risk_volumes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geom/base/error.h"
#include "geom/map/geodetic_outline.h"
#include "geom/shape/convex_outline.h"
#include "geom/text/instant.h"
#include "traj/mission/airspace/volume_around.h"

namespace traj {
namespace {

using geom::Vec2;
using geom::Volume4d;

constexpr double kCentimetres = 100;
constexpr double kThick = 0.01;  // m that a buffer is high at least
// An outline may reach further than its formula says, to have fewer corners: by so many metres,
// plus this share of the distance by which the volume is larger.
constexpr double kSlack = 0.05;
constexpr double kSlackShare = 0.02;

// Corners of the regular 16-gon around the circle of radius 1: those at 22.5 degrees and its
// multiples, further out by 1 / cos(11.25 degrees), rounded up.
constexpr double kOut = 1.0195912;
constexpr double kCorners[4][2] = {
    {1, 0}, {0.92387954, 0.38268344}, {0.70710679, 0.70710679}, {0.38268344, 0.92387954}};

std::vector<Vec2> around_circle(double radius) {
  std::vector<Vec2> out;
  for (const auto& [x, y] : kCorners) {
    Vec2 corner = kOut * radius * Vec2(x, y);
    for (int quarter = 0; quarter < 4; ++quarter) {
      out.push_back(corner);
      corner = Vec2(-corner.y(), corner.x());
    }
  }
  return out;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Where the lines along the edges before and after an edge meet, beyond it; nothing where they do
// not, and how far from the edge that is.
std::optional<std::pair<Vec2, double>> beyond_edge(const std::vector<Vec2>& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const Vec2& a = ring[i];
  const Vec2& b = ring[(i + 1) % n];
  const Vec2 before = a - ring[(i + n - 1) % n];
  const Vec2 after = ring[(i + 2) % n] - b;
  const double turn = cross(before, after);
  if (!(turn > 1e-9 * before.norm() * after.norm())) return std::nullopt;
  const Vec2 corner = a + cross(b - a, after) / turn * before;
  return std::pair(corner, cross(b - a, corner - b) / (b - a).norm() * -1);
}

// A convex ring around this one with fewer corners: while an edge can be left out by a corner less
// than `slack` metres away, the one that takes least is.
std::vector<Vec2> fewer_corners(std::vector<Vec2> ring, double slack) {
  while (ring.size() > 4) {
    std::size_t best = ring.size();
    std::pair<Vec2, double> least(Vec2::Zero(), slack);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto corner = beyond_edge(ring, i);
      if (!corner || !(corner->second < least.second)) continue;
      least = *corner;
      best = i;
    }
    if (best == ring.size()) break;
    ring[best] = least.first;
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>((best + 1) % ring.size()));
  }
  return ring;
}

void require_altitudes(const Volume4d& volume, std::string_view source) {
  if (volume.lower && volume.upper && volume.start && volume.end) return;
  throw geom::InputError(
      source, {.expected = "volumes with both altitudes and both times", .found = "one without"});
}

// All places within `across` of the volume in plan, and within `vertical` of it up and down.
AirspacePrism grown(const Volume4d& volume, double across, double vertical, const RiskTask& task,
                    std::string_view source) {
  const geom::MapOutline outline = geom::outline_on_map(
      volume.outline, task.origin, geom::CircleSide::around, "a volume", source);
  std::vector<Vec2> points;
  for (const Vec2& corner : around_circle(across + outline.bulge)) {
    for (const Vec2& p : outline.ring) points.push_back(p + corner);
  }
  return {geom::convex_outline(std::move(points)), *volume.lower - task.origin.height - vertical,
          *volume.upper - task.origin.height + vertical};
}

Volume4d with_times(Volume4d volume, const Volume4d& of) {
  volume.start = of.start;
  volume.end = of.end;
  return volume;
}

double height_of(const Volume4d& contingency, const RiskTask& task) {
  const double height = *contingency.upper - task.origin.height - task.floor;
  return std::max(0.0, std::ceil(height * kCentimetres + 1e-6) / kCentimetres);
}

// From the floor up.
AirspacePrism buffer_prism(const Volume4d& contingency, double across, const RiskTask& task,
                           std::string_view source) {
  AirspacePrism out = grown(contingency, across, 0, task, source);
  out.low = std::min(out.low, task.floor);
  out.high = std::max(out.high, out.low + kThick);
  return out;
}

// The volumes of the intent around which contingency volumes are, and how these are made.
std::vector<Volume4d> inner(const geom::IntentVolumes& intent, const RiskTask& task,
                            std::string_view source) {
  std::vector<Volume4d> out = intent.nominal;
  if (task.rules.contingency == ContingencyRule::ways_home) {
    out.insert(out.end(), intent.off_nominal.begin(), intent.off_nominal.end());
  }
  for (const Volume4d& volume : out) require_altitudes(volume, source);
  return out;
}

bool lasts(const Volume4d& volume, const Volume4d& of) {
  return volume.start && volume.end && geom::seconds_between(*volume.start, *of.start).least >= 0 &&
         geom::seconds_between(*of.end, *volume.end).least >= 0;
}

// Heights of buffers count from the floor, so ground that is lower makes them too small.
std::optional<std::string> why_floor_too_high(const Volume4d& buffer, const RiskTask& task,
                                              std::string_view source) {
  if (!task.ground) return std::nullopt;
  const geom::MapOutline outline = geom::outline_on_map(
      buffer.outline, task.origin, geom::CircleSide::around, "a ground risk buffer", source);
  const Vec2 bulge = Vec2::Constant(outline.bulge);
  geom::Rectangle region{outline.ring.front() - bulge, outline.ring.front() + bulge};
  for (const Vec2& p : outline.ring) {
    region = {region.min.cwiseMin(p - bulge), region.max.cwiseMax(p + bulge)};
  }
  if (task.ground->axes != geom::Axes::enu) {
    std::swap(region.min.x(), region.min.y());
    std::swap(region.max.x(), region.max.y());
  }
  const geom::GroundRange ground = task.ground->ground->range(region);
  if (!ground.any_known || ground.low >= task.floor) return std::nullopt;
  return fmt::format(
      "the ground below is as low as z {:.1f} by the height model, and heights of ground risk "
      "buffers count from z {:g}: give --ground-level {:.1f}",
      ground.low, task.floor, std::floor(ground.low * 10) / 10);
}

// A volume around all of these places, with few corners.
Volume4d made(AirspacePrism prism, double across, const RiskTask& task, std::string_view source) {
  prism.outline = fewer_corners(std::move(prism.outline), kSlack + kSlackShare * across);
  return volume_around(prism, task.origin, source);
}

}  // namespace

RiskVolumes risk_volumes(const geom::IntentVolumes& intent, const RiskTask& task,
                         std::string_view source) {
  const ContingencySize size = contingency_size(task.rules, task.speed);
  const bool stops = task.rules.contingency == ContingencyRule::stop;
  RiskVolumes out;
  for (const Volume4d& volume : inner(intent, task, source)) {
    const Volume4d contingency =
        stops ? with_times(made(grown(volume, size.across, size.vertical, task, source),
                                size.across, task, source),
                           volume)
              : volume;
    RiskVolume buffer;
    buffer.height = height_of(contingency, task);
    buffer.across = ground_buffer(task.rules, task.speed, buffer.height);
    buffer.volume = with_times(
        made(buffer_prism(contingency, buffer.across, task, source), buffer.across, task, source),
        volume);
    out.contingency.push_back(contingency);
    out.buffers.push_back(std::move(buffer));
  }
  return out;
}

std::optional<std::string> why_risk_not_held(const geom::IntentVolumes& intent,
                                             const RiskVolumes& risk, const RiskTask& task,
                                             std::string_view source) {
  const std::vector<Volume4d> around = inner(intent, task, source);
  if (risk.contingency.size() != around.size() || risk.buffers.size() != around.size()) {
    return fmt::format("{} contingency volumes and {} ground risk buffers stand around {} volumes",
                       risk.contingency.size(), risk.buffers.size(), around.size());
  }
  const ContingencySize size = contingency_size(task.rules, task.speed);
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Volume4d& contingency = risk.contingency[i];
    require_altitudes(contingency, source);
    require_altitudes(risk.buffers[i].volume, source);
    const bool same = size.across == 0 && contingency.outline.ring == around[i].outline.ring &&
                      *contingency.lower <= *around[i].lower &&
                      *contingency.upper >= *around[i].upper;
    if (!lasts(contingency, around[i]) || !lasts(risk.buffers[i].volume, around[i])) {
      return fmt::format("volume {} lasts less long than the volume that it surrounds", i);
    }
    if (!same &&
        !holds_prism(contingency, grown(around[i], size.across, size.vertical, task, source),
                     task.origin, source)) {
      return fmt::format(
          "contingency volume {} does not reach {} m around its volume, and {} m up "
          "and down",
          i, size.across, size.vertical);
    }
    const double height = height_of(contingency, task);
    const double across = ground_buffer(task.rules, task.speed, height);
    if (risk.buffers[i].height != height || risk.buffers[i].across != across) {
      return fmt::format(
          "ground risk buffer {} says {} m for a height of {} m, expected {} m for "
          "{} m",
          i, risk.buffers[i].across, risk.buffers[i].height, across, height);
    }
    if (!holds_prism(risk.buffers[i].volume, buffer_prism(contingency, across, task, source),
                     task.origin, source)) {
      return fmt::format("ground risk buffer {} does not reach {} m around its volume", i, across);
    }
    if (auto why = why_floor_too_high(risk.buffers[i].volume, task, source)) return why;
  }
  return std::nullopt;
}

}  // namespace traj
