#include "traj/flight/flown_tube.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "curve/bernstein.h"
#include "geom/shape/aabb.h"

namespace traj {
namespace {

constexpr double kChord = 0.01;  // s
constexpr std::size_t kGroup = 32;

struct Chord {
  Vec3 from;
  Vec3 to;
  double radius = -1;  // of the tube there, less what the curve is off the chord
};

// Neighbouring chords, and what holds them.
struct Group {
  std::size_t begin = 0;
  std::size_t end = 0;
  geom::Aabb box;
  double widest = -1;
};

double distance(const Vec3& p, const Chord& chord) {
  const Vec3 way = chord.to - chord.from;
  const double square = way.squaredNorm();
  const double share = square > 0 ? std::clamp((p - chord.from).dot(way) / square, 0.0, 1.0) : 0;
  return (p - (chord.from + share * way)).norm();
}

double radius_of(std::span<const double> radius, double period, double from, double to) {
  if (radius.empty()) return -1;
  const auto at = [&](double time) {
    return std::min(static_cast<std::size_t>(time / period), radius.size() - 1);
  };
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = at(from); k <= at(to); ++k) least = std::min(least, radius[k]);
  return least;
}

std::vector<Chord> chords_of(const Trajectory& plan, std::span<const double> radius,
                             double period) {
  std::vector<Chord> out;
  double begin = 0;
  for (const Segment& segment : plan.segments) {
    double most = 0;
    for (const Vec3& a : acceleration_points(segment)) most = std::max(most, a.norm());
    const double parts = std::max(1.0, std::ceil(segment.duration / kChord));
    const double length = segment.duration / parts;
    const double sagitta = most * length * length / 8;
    Vec3 from = segment.point.front();
    for (double i = 0; i < parts; ++i) {
      const Vec3 to = evaluate(segment, (i + 1) * length).position;
      const double room =
          radius_of(radius, period, begin + i * length, begin + (i + 1) * length) - sagitta;
      out.push_back({from, to, room});
      from = to;
    }
    begin += segment.duration;
  }
  return out;
}

std::vector<Group> groups_of(const std::vector<Chord>& chords) {
  std::vector<Group> out;
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const Chord& chord = chords[i];
    if (i % kGroup == 0) out.push_back({i, i, {chord.from, chord.from}, -1});
    Group& group = out.back();
    group.end = i + 1;
    for (const Vec3* p : {&chord.from, &chord.to}) {
      group.box.min = group.box.min.cwiseMin(*p);
      group.box.max = group.box.max.cwiseMax(*p);
    }
    group.widest = std::max(group.widest, chord.radius);
  }
  return out;
}

}  // namespace

FlownTube flown_tube(const Trajectory& plan, std::span<const double> radius, double period,
                     std::span<const Vec3> points, std::span<const double> times) {
  const std::vector<Chord> chords = chords_of(plan, radius, period);
  const std::vector<Group> groups = groups_of(chords);
  FlownTube out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = false;
    for (const Group& group : groups) {
      const double least = geom::distance(points[i], group.box);
      if (least >= nearest && (inside || least > group.widest)) continue;
      for (std::size_t k = group.begin; k < group.end; ++k) {
        const double d = distance(points[i], chords[k]);
        nearest = std::min(nearest, d);
        inside = inside || d <= chords[k].radius;
      }
    }
    if (i == 0 || nearest > out.furthest.value) out.furthest = {nearest, times[i]};
    if (!inside && out.inside == i) out.left = times[i];
    out.inside += inside;
  }
  return out;
}

}  // namespace traj
