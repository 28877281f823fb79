#include "flown_regions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace traj {
namespace {

using std::numbers::pi;

constexpr double kSplineFactor = 4;        // of the leg: the most that velocities sum to
constexpr double kWidestArc = pi / 16;     // radians between two tangents
constexpr double kSureRadius = 1 + 1e-12;  // outside, whatever sines and cosines round to

// As long as it may be in a spline over a leg of this length.
Vec3 limited(const Vec3& velocity, double leg) {
  const double most = kSplineFactor * leg;
  const double length = velocity.norm();
  return length > most ? Vec3(velocity * (most / length)) : velocity;
}

}  // namespace

Vec3 before_corner(const Vec3& from, const Vec3& corner, double radius) {
  const double length = (corner - from).norm();
  return length > radius ? Vec3(corner + (from - corner) * (radius / length)) : from;
}

Hull corner_hull(const Vec3& from, const Vec3& corner, const Vec3& to, double radius,
                 double beyond) {
  Hull hull{before_corner(from, corner, radius), corner, before_corner(to, corner, radius)};
  const double length = (corner - from).norm();
  if (beyond > 0 && length > 0) hull.push_back(corner + (corner - from) * (beyond / length));
  return hull;
}

Hull spline_hull(const Vec3& a, const Vec3& b, const std::vector<Vec3>& leaving,
                 const std::vector<Vec3>& arriving) {
  const double leg = (b - a).norm();
  Hull hull{a, b};
  for (const Vec3& v : leaving) hull.push_back(a + limited(v, leg) / 3);
  for (const Vec3& v : arriving) hull.push_back(b - limited(v, leg) / 3);
  return hull;
}

Vec3 Circle::at(double angle) const {
  return centre + radius * Vec3(std::cos(angle), std::sin(angle), 0);
}

double Circle::angle_to(const Vec3& p) const {
  return std::atan2(p.y() - centre.y(), p.x() - centre.x());
}

Hull Circle::arc(double from, double wide) const {
  const double pieces = std::max(1.0, std::ceil(std::abs(wide) / kWidestArc));
  const double step = wide / pieces;
  const double out = radius / std::cos(step / 2) * kSureRadius;
  Hull hull{at(from)};
  for (double i = 0; i < pieces; ++i) {
    const double middle = from + (i + 0.5) * step;
    hull.push_back(centre + out * Vec3(std::cos(middle), std::sin(middle), 0));
  }
  hull.push_back(at(from + wide));
  return hull;
}

Hull Circle::disc() const {
  constexpr int kCorners = 32;
  const double out = radius / std::cos(pi / kCorners) * kSureRadius;
  Hull hull;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * pi * i / kCorners;
    hull.push_back(centre + out * Vec3(std::cos(angle), std::sin(angle), 0));
  }
  return hull;
}

CircleFlight fly_circle(const Circle& circle, const Hull& from) {
  constexpr int kArcs = 32;
  constexpr double kArc = 2 * pi / kArcs;
  constexpr double kRoom = 0.05;  // m
  const double start = circle.angle_to(from.back());
  double least = 0;
  double most = 0;
  for (const Vec3& p : from) {
    const double turn = std::remainder(circle.angle_to(p) - start, 2 * pi);
    least = std::min(least, turn);
    most = std::max(most, turn);
  }
  const double room = kRoom / circle.radius;
  CircleFlight flight;
  flight.leaving = circle.arc(start + least - room, most - least + 2 * room);
  flight.entry = flight.leaving;
  flight.entry.insert(flight.entry.end(), from.begin(), from.end());
  for (int i = 0; i < kArcs; ++i) {
    flight.arcs.push_back(circle.arc(start + i * kArc, kArc));
  }
  for (int i = 0; i <= kArcs; ++i) flight.points.push_back(circle.at(start + i * kArc));
  return flight;
}

std::vector<Hull> return_hulls(const Hull& low, const Vec3& above, double ground, double slope) {
  const auto raised = [](const Vec3& p, double z) { return Vec3(p.x(), p.y(), z); };
  Hull column = low;
  Hull across{above};
  double away = 0;
  for (const Vec3& p : low) {
    column.push_back(raised(p, above.z()));
    across.push_back(raised(p, above.z()));
    away = std::max(away, (p - above).head<2>().norm());
  }
  if (slope > 0 && away * slope < above.z() - ground) {
    for (const Vec3& p : low) {
      across.push_back(p);
      across.push_back(raised(above, p.z()));
    }
  }
  return {column, across};
}

}  // namespace traj
