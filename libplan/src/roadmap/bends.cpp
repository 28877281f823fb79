#include "bends.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "curve.h"
#include "path/boxes_within.h"
#include "uncovered.h"

namespace plan {
namespace {

constexpr double kOff = 1e-3;  // metres that bends keep from their box

// What covers lines just off an edge, kept so that its memory serves the next edge.
struct Cover {
  std::vector<Interval> outermost;  // the line off both faces: bends are on it
  std::vector<Interval> any;        // that one, and those off one face and inside the other
};

// One edge of a grown box: along `axis`, at the lower or upper ends of the next two.
class BoxEdge {
 public:
  BoxEdge(const geom::CollisionScene& scene, const geom::Aabb& box, int axis, int corner)
      : scene_(scene), box_(box), k_(axis), i1_((axis + 1) % 3), i2_((axis + 2) % 3) {
    outward_ = {static_cast<std::int8_t>(corner & 1 ? 1 : -1),
                static_cast<std::int8_t>(corner & 2 ? 1 : -1)};
  }

  // Whether it may have bends: some below a box that stands on the ground are out of bounds.
  bool may_have_bends(const std::optional<geom::Aabb>& square, const ShortWays* ways) const {
    const geom::Aabb on = line();
    if (square && !geom::overlap(*square, on)) return false;
    const auto& bounds = scene_.free_bounds();
    return bounds && geom::overlap(*bounds, on) && !(ways && !ways->may_meet(on));
  }

  // In the middle of what is exposed of each part, but for parts that are surely out of the square,
  // and bends that the ways do not hold. `near` are the other grown boxes that meet the box, or
  // come within kOff of it.
  void add_bends(std::span<const geom::Aabb> near, double part,
                 const std::optional<geom::Aabb>& square, const ShortWays* ways, Cover& cover,
                 std::vector<Bend>& out) const {
    if (!find(near, cover)) return;
    const double length = box_.max[k_] - box_.min[k_];
    const double parts = std::max(1.0, std::ceil(length / part));
    const auto [first, end] = parts_in(square, length, parts);
    const Interval whole[] = {{box_.min[k_], box_.max[k_]}};
    std::vector<Interval> some;
    if (!cover.any.empty()) some = uncovered(box_.min[k_], box_.max[k_], cover.any);
    const std::span<const Interval> open =
        cover.any.empty() ? std::span(whole) : std::span<const Interval>(some);
    for (double n = first; n < end; ++n) {
      const double from = box_.min[k_] + length * (n / parts);
      const double to = box_.min[k_] + length * ((n + 1) / parts);
      for (const auto& [low, high] : open) {
        if (high < from || low > to) continue;
        const double middle = 0.5 * (std::max(low, from) + std::min(high, to));
        const Bend bend{beside(1, 1, middle), static_cast<std::int8_t>(k_), outward_};
        if (ways && !ways->hold(bend.position)) continue;
        if (free(bend.position, cover.outermost)) out.push_back(bend);
      }
    }
  }

 private:
  Vec3 beside(double side1, double side2, double along) const {
    Vec3 p;
    p[k_] = along;
    p[i1_] = (outward_[0] > 0 ? box_.max[i1_] : box_.min[i1_]) + side1 * kOff * outward_[0];
    p[i2_] = (outward_[1] > 0 ? box_.max[i2_] : box_.min[i2_]) + side2 * kOff * outward_[1];
    return p;
  }

  // What holds all bends of the edge.
  geom::Aabb line() const { return {beside(1, 1, box_.min[k_]), beside(1, 1, box_.max[k_])}; }

  // The parts, of so many, that may have bends in the square: [first, end).
  std::pair<double, double> parts_in(const std::optional<geom::Aabb>& square, double length,
                                     double parts) const {
    if (!square || parts < 8) return {0, parts};
    const double low = (square->min[k_] - box_.min[k_]) / length * parts;
    const double high = (square->max[k_] - box_.min[k_]) / length * parts;
    return {std::max(0.0, std::floor(low) - 1), std::min(parts, std::ceil(high) + 1)};
  }

  // The edge is exposed where the three outer quadrants are free, each looked at along its line.
  // False where a single box hides all of it.
  bool find(std::span<const geom::Aabb> near, Cover& cover) const {
    cover.outermost.clear();
    cover.any.clear();
    const Vec3 out = beside(1, 1, 0);
    const Vec3 in = beside(-1, -1, 0);
    for (const geom::Aabb& other : near) {
      if (box_.max[k_] < other.min[k_] || box_.min[k_] > other.max[k_]) continue;
      const auto holds = [&](int i, const Vec3& p) {
        return p[i] >= other.min[i] && p[i] <= other.max[i];
      };
      const bool out1 = holds(i1_, out);
      const bool out2 = holds(i2_, out);
      const Interval along{other.min[k_], other.max[k_]};
      if (out1 && out2) cover.outermost.push_back(along);
      if (!(out1 && (out2 || holds(i2_, in))) && !(out2 && holds(i1_, in))) continue;
      if (along.first <= box_.min[k_] && along.second >= box_.max[k_]) return false;
      cover.any.push_back(along);
    }
    return true;
  }

  // scene.free() of a point of the line in the outermost quadrant, of which this is `blocked`.
  bool free(const Vec3& p, const std::vector<Interval>& blocked) const {
    for (const auto& [low, high] : blocked) {
      if (p[k_] >= low && p[k_] <= high) return false;
    }
    return scene_.inside_bounds(p);
  }

  const geom::CollisionScene& scene_;
  const geom::Aabb& box_;
  int k_;
  int i1_;
  int i2_;
  std::array<std::int8_t, 2> outward_{};
};

// The grown boxes that meet `beside`, but for `box`.
std::vector<geom::Aabb> others(const geom::CollisionScene& scene, const geom::Aabb& box,
                               const geom::Aabb& beside) {
  std::vector<geom::Aabb> out;
  for (const std::size_t i : scene.boxes_meeting(beside)) {
    const geom::Aabb other = scene.grown(i);
    if (!(other == box)) out.push_back(other);
  }
  return out;
}

// The grown boxes of these numbers, so that neighbours mostly follow each other.
std::vector<geom::Aabb> along_curve(const geom::CollisionScene& scene,
                                    const std::vector<std::size_t>& boxes, const Curve& curve) {
  std::vector<std::pair<std::uint64_t, std::size_t>> places;
  places.reserve(boxes.size());
  for (const std::size_t i : boxes) {
    const geom::Aabb& box = scene.map().box(i);
    places.emplace_back(curve.place(0.5 * (box.min + box.max)), i);
  }
  std::sort(places.begin(), places.end());
  std::vector<geom::Aabb> out;
  out.reserve(places.size());
  for (const auto& [place, i] : places) out.push_back(scene.grown(i));
  return out;
}

}  // namespace

std::optional<std::vector<Bend>> bends_within(const geom::CollisionScene& scene, double part,
                                              const ShortWays& ways, std::size_t most) {
  const auto boxes = boxes_within(scene, ways, most);
  if (!boxes) return std::nullopt;
  std::vector<Bend> bends;
  for (const geom::Aabb& box : along_curve(scene, *boxes, Curve(ways.around()))) {
    add_bends(scene, box, part, std::nullopt, bends, &ways);
  }
  return bends;
}

// Of the boxes beside a part of an edge only those matter that come near that part.
void add_bends(const geom::CollisionScene& scene, const geom::Aabb& box, double part,
               const std::optional<geom::Aabb>& square, std::vector<Bend>& out,
               const ShortWays* ways) {
  geom::Aabb beside = geom::grow(box, Vec3::Constant(2 * kOff));
  if (square) {
    const geom::Aabb wide = geom::grow(*square, Vec3::Constant(2 * part + 1));
    beside = {beside.min.cwiseMax(wide.min), beside.max.cwiseMin(wide.max)};
    if (!(beside.min.array() <= beside.max.array()).all()) return;
  }
  Cover cover;
  std::optional<std::vector<geom::Aabb>> near;
  for (int k = 0; k < 3; ++k) {
    for (int corner = 0; corner < 4; ++corner) {
      const BoxEdge edge(scene, box, k, corner);
      if (!edge.may_have_bends(square, ways)) continue;
      if (!near) near = others(scene, box, beside);
      edge.add_bends(*near, part, square, ways, cover, out);
    }
  }
}

bool operator<(const EdgeKey& a, const EdgeKey& b) {
  return std::tie(a.second, a.ratio, a.to) < std::tie(b.second, b.ratio, b.to);
}

EdgeKey edge_key(std::span<const Bend> bends, std::size_t from, std::uint32_t to) {
  const Across a = across(bends[from], bends[to].position - bends[from].position);
  return {a.second_side(), a.ratio(), to};
}

}  // namespace plan
