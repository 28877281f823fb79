#include "traj/figure/clearance.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/text/excerpt.h"
#include "geom/text/rounded.h"
#include "shapes.h"
#include "way_points.h"

namespace traj::figure {
namespace {

constexpr double kFar = 50;             // metres
constexpr double kNear = 1;             // metres that are shown at large, or twice the margin
constexpr double kExact = 1e-3;         // metres: how well the clearance is known
constexpr double kHeight = 220;         // pixels
constexpr double kMetresBetween = 0.5;  // along a path

// What is nearer than the margin, and for how long in all.
struct TooNear {
  std::vector<Span> spans;
  double length = 0;
};

TooNear too_near(const ClearanceTrack& track, double margin) {
  TooNear out;
  for (const ClearanceSpan& span : track.spans) {
    if (span.clearance >= margin - kExact) continue;
    out.spans.push_back({{span.begin, span.clearance}, {span.end, margin}});
    out.length += span.end - span.begin;
  }
  return out;
}

Panel panel_of(const geom::CollisionScene& scene, const ClearanceTrack& track,
               std::string_view unit) {
  Series series{"", colour(0), {}};
  for (const ClearanceSpan& span : track.spans) {
    const double least = std::min(span.clearance, kFar);
    series.points.push_back({span.begin, least});
    series.points.push_back({span.end, least});
  }
  const Point least = *std::min_element(series.points.begin(), series.points.end(),
                                        [](const Point& a, const Point& b) { return a.y < b.y; });
  Panel panel{"clearance, m", {std::move(series)}};
  panel.height = kHeight;
  panel.near = std::max(kNear, 2 * scene.margin());
  panel.marks = {{least, ""}};
  panel.note = fmt::format("{}: least {:.4g} m at {:.4g} {}", track.id, geom::rounded_down(least.y),
                           least.x, unit);
  if (scene.margin() > 0) {
    panel.levels = {{fmt::format("margin {:g} m", scene.margin()), scene.margin()}};
    TooNear near = too_near(track, scene.margin());
    if (!near.spans.empty()) {
      panel.note += fmt::format("; less than the margin for {:.3g} {}", near.length, unit);
    }
    panel.shaded = std::move(near.spans);
  }
  return panel;
}

// In the axes of the map.
std::vector<Vec3> points_of(const FlightLog& flight, geom::Axes axes) {
  std::vector<Vec3> out;
  for (const FlightSample& s : flight.samples) out.push_back(geom::to_enu(axes, s.position));
  return out;
}

}  // namespace

ClearanceTrack clearance_track(const geom::CollisionScene& scene, const TrajectoryRecord& record) {
  const double step = step_of(duration(record.trajectory), kSecondsBetween);
  return {"trajectory " + geom::excerpt(record.id),
          clearance_profile(scene, record.trajectory, step)};
}

ClearanceTrack clearance_track(const geom::CollisionScene& scene, const FlightLog& flight) {
  std::vector<double> times;
  for (const FlightSample& s : flight.samples) times.push_back(s.time);
  const auto points = points_of(flight, scene.map().spec().frame.axes);
  return {"flight " + geom::excerpt(flight.id), clearance_profile(scene, points, times)};
}

std::vector<ClearanceSpan> clearance_of(const geom::CollisionScene& scene, const FlightLog& flight,
                                        std::span<const std::size_t> rows) {
  std::vector<double> times;
  for (const FlightSample& s : flight.samples) {
    times.push_back(s.time - flight.samples.front().time);
  }
  const auto points = points_of(flight, scene.map().spec().frame.axes);
  const auto legs = clearance_profile(scene, points, times);
  std::vector<ClearanceSpan> out;
  for (std::size_t k = 1; k < rows.size() && !legs.empty(); ++k) {
    ClearanceSpan span = legs[rows[k - 1]];
    span.end = times[rows[k]];
    for (std::size_t i = rows[k - 1]; i < rows[k]; ++i) {
      span.clearance = std::min(span.clearance, legs[i].clearance);
    }
    out.push_back(span);
  }
  return out;
}

ClearanceTrack clearance_track(const geom::CollisionScene& scene, const geom::PathRecord& path) {
  const double step = step_of(geom::length(path.points), kMetresBetween);
  return {"path " + geom::excerpt(path.id), clearance_profile(scene, path.points, step)};
}

std::string clearance(const geom::CollisionScene& scene, std::span<const ClearanceTrack> tracks,
                      std::string_view x_label, std::string_view note) {
  Figure figure;
  figure.title = fmt::format("Clearance of {}{}", scene.vehicle().name, note);
  if (!scene.map().timed().empty()) {
    figure.title += " (boxes with a time count as always there)";
  }
  figure.x_label = x_label;
  const std::string_view unit = x_label.substr(x_label.rfind(' ') + 1);
  for (const ClearanceTrack& track : tracks) {
    figure.panels.push_back(panel_of(scene, track, unit));
  }
  return drawn(figure);
}

}  // namespace traj::figure
