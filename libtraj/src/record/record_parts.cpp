#include "traj/record/record_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "traj/curve/to_enu.h"

namespace traj {
namespace {

using Colour = std::array<std::uint8_t, 3>;
using Edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// Okabe and Ito: vermilion, bluish green, reddish purple, yellow.
constexpr Colour kPath{213, 94, 0};
constexpr Colour kTrajectory{0, 158, 115};
constexpr Colour kFlight{204, 121, 167};
constexpr Colour kCorridor{240, 228, 66};  // as in the page
constexpr double kCorridorOpacity = 0.3;
constexpr double kStep = 0.1;       // seconds between the points of a curve,
constexpr double kMostSteps = 1e5;  // but no more of them than that

// A line through points, as thick at its joints as between them.
geom::MeshPart way(std::string name, Colour colour, std::vector<Vec3> points, double radius) {
  Edges edges;
  for (std::uint32_t i = 1; i < points.size(); ++i) edges.push_back({i - 1, i});
  return geom::rod_part(
      {std::move(name), colour, std::move(points), std::move(edges), radius, radius});
}

std::vector<Vec3> curve(const Trajectory& trajectory) {
  const double end = duration(trajectory);
  const double count = std::clamp(std::ceil(end / kStep), 1.0, kMostSteps);
  std::vector<Vec3> points;
  for (double k = 0; k <= count; ++k) {
    points.push_back(evaluate(trajectory, end * (k / count)).position);
  }
  return points;
}

// Of a flight log, a row each kStep.
std::vector<Vec3> flown(const FlightLog& flight) {
  std::vector<Vec3> points;
  double next = flight.samples.front().time;
  for (const FlightSample& s : flight.samples) {
    if (s.time < next && &s != &flight.samples.back()) continue;
    points.push_back(s.position);
    next = s.time + kStep;
  }
  return points;
}

}  // namespace

geom::MeshPart path_part(const geom::PathRecord& path, geom::Axes axes, double radius) {
  return way("path " + path.id, kPath, to_enu(axes, path.points), radius);
}

geom::MeshPart trajectory_part(const TrajectoryRecord& record, geom::Axes axes, double radius) {
  return way("trajectory " + record.id, kTrajectory, to_enu(axes, curve(record.trajectory)),
             radius);
}

geom::MeshPart flight_part(const FlightLog& flight, double radius) {
  return way("flight " + flight.id, kFlight, flown(flight), radius);
}

geom::MeshPart corridor_part(const CorridorShape& corridor, geom::Axes axes) {
  std::vector<geom::Polytope> regions;
  for (const auto& piece : corridor.pieces) regions.push_back({piece.vertices, piece.faces});
  geom::MeshPart part = geom::polytope_part("corridor " + corridor.id, kCorridor, axes, regions);
  part.opacity = kCorridorOpacity;
  return part;
}

}  // namespace traj
