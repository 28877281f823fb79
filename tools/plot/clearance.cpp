#include "plot/clearance.h"

#include <fmt/format.h>

#include <algorithm>

#include "plot/figure.h"
#include "plot/palette.h"

namespace plot {
namespace {

constexpr double kFar = 50;  // metres

Panel panel_of(const geom::CollisionScene& scene, const ClearanceTrack& track) {
  Series series{track.id, colour(0), {}};
  for (std::size_t i = 0; i < track.points.size(); ++i) {
    const auto nearest = scene.nearest(track.points[i], kFar);
    series.points.push_back({track.x[i], nearest ? nearest->distance : kFar});
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
