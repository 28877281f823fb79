#include "traj/fleet/forbidden_by_map.h"

#include <algorithm>

#include "curve/curve_piece.h"
#include "geom/base/rounding.h"

namespace traj {
namespace {

constexpr double kBrief = 0.01;  // seconds: pieces that are not halved any more
constexpr int kDeepest = 20;     // halvings: hours along a face would else be millions of pieces
constexpr double kBlur = 1e-6;   // seconds: more than the check of a departure rounds

class Search {
 public:
  // Times of pieces are sums of durations, and halves of these: rounded by `slack` at most.
  Search(const geom::CollisionScene& scene, double slack) : scene_(scene), slack_(slack) {}

  void look(const Piece& piece, int depth = 0) {
    const geom::Aabb region = sure_box(piece, depth);
    const bool last = piece.end - piece.begin <= kBrief || depth == kDeepest;
    bool in_part = false;
    for (const std::size_t i : scene_.boxes_meeting(region)) {
      const geom::TimeSpan time = scene_.map().time(i);
      if (time.always()) continue;
      // What holds all of a piece is met as long as that lasts, which no halving changes.
      if (last || holds(scene_.grown(i), region)) {
        forbid(time, time_of(piece));
      } else {
        in_part = true;
      }
    }
    if (!in_part) return;
    const auto [left, right] = piece.halved();
    look(left, depth + 1);
    look(right, depth + 1);
  }

  // Of a point at which it stands all that time.
  void stand(const Vec3& p, const geom::TimeSpan& then) {
    for (const std::size_t i :
         scene_.boxes_meeting(sure_box({{p, p, p, p, p, p, p, p}, 0, 0}, 0))) {
      const geom::TimeSpan time = scene_.map().time(i);
      if (!time.always()) forbid(time, then);
    }
  }

  std::vector<DepartureSpan> forbidden() { return united(std::move(found_)); }

 private:
  static geom::TimeSpan time_of(const Piece& piece) { return {piece.begin, piece.end}; }

  static bool holds(const geom::Aabb& box, const geom::Aabb& region) {
    return geom::contains(box, region.min) && geom::contains(box, region.max);
  }

  // Holds the curve, of which each halving rounds the control points by an ulp.
  static geom::Aabb sure_box(const Piece& piece, int depth) {
    const geom::Aabb hull = hull_box(piece.q);
    const double far = std::max(hull.min.cwiseAbs().maxCoeff(), hull.max.cwiseAbs().maxCoeff());
    const Vec3 pad = Vec3::Constant(1e-15 * (depth + 4) * far + 1e-300);
    return {hull.min - pad, hull.max + pad};
  }

  void forbid(const geom::TimeSpan& box, const geom::TimeSpan& flight) {
    found_.push_back({geom::next_down(geom::next_down(box.from - flight.until) - slack_),
                      geom::next_up(geom::next_up(box.until - flight.from) + slack_)});
  }

  const geom::CollisionScene& scene_;
  double slack_;
  std::vector<DepartureSpan> found_;
};

}  // namespace

std::vector<DepartureSpan> forbidden_by_map(const geom::CollisionScene& scene,
                                            const Trajectory& trajectory, Parked parked) {
  if (scene.map().timed().empty()) return {};
  const std::vector<Piece> pieces = pieces_of(trajectory);
  const double duration = pieces.back().end;
  const double slack = (static_cast<double>(pieces.size()) + 64) * 0x1p-52 * duration;
  Search search(scene, kBlur + slack);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    search.look(pieces[i]);
    if (i == 0) continue;
    const Vec3& a = pieces[i - 1].q[kDegree];  // the step to the next, which counts as flown
    const Vec3& b = pieces[i].q[0];
    if (a != b) search.look({{a, a, a, a, b, b, b, b}, pieces[i].begin, pieces[i].begin});
  }
  if (parked == Parked::pad) {
    search.stand(pieces.front().q[0], {-kInfinity, 0});
    search.stand(pieces.back().q[kDegree], {duration, kInfinity});
  }
  return search.forbidden();
}

}  // namespace traj
