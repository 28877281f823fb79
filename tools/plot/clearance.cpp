#include "clearance.h"

#include <fmt/format.h>

#include <algorithm>

#include "figure.h"
#include "palette.h"

namespace plot {
namespace {

constexpr double kFar = 50;  // metres

Panel panel_of(const geom::CollisionScene& scene, const ClearanceTrack& track) {
  Series series{track.id, colour(0), {}};
  for (const traj::ClearanceSpan& span : track.spans) {
    const double least = std::min(span.clearance, kFar);
    series.points.push_back({span.begin, least});
    series.points.push_back({span.end, least});
  }
  const Point least = *std::min_element(series.points.begin(), series.points.end(),
                                        [](const Point& a, const Point& b) { return a.y < b.y; });
  Panel panel{"clearance, m", {std::move(series)}};
  panel.marks = {{least, fmt::format("{:.3g} m", least.y)}};
  if (scene.margin() > 0) {
    panel.levels = {{fmt::format("margin {:g}", scene.margin()), scene.margin()}};
  }
  return panel;
}

}  // namespace

std::string clearance(const geom::CollisionScene& scene, std::span<const ClearanceTrack> tracks,
                      std::string_view x_label) {
  Figure figure;
  figure.title = fmt::format("Clearance of {}", scene.vehicle().name);
  figure.x_label = x_label;
  for (const ClearanceTrack& track : tracks) figure.panels.push_back(panel_of(scene, track));
  return drawn(figure);
}

}  // namespace plot
