#include "traj/fleet/forbidden_by_moving.h"

#include <cassert>

#include "fleet/course.h"
#include "fleet/meeting_times.h"
#include "geom/base/rounding.h"

namespace traj {
namespace {

constexpr Bend kBend{0.01, 0.01};
constexpr double kBlur = 1e-6;  // seconds: more than the check of a departure rounds

// A box on its way, for the reference point of a flight: larger by its room.
class OnItsWay {
 public:
  OnItsWay(const MovingBox& box, const Vec3& room) {
    const double seconds = geom::add_up(box.until, -box.from);
    piece_.from = 0.5 * (box.box.min + box.box.max);
    piece_.way = box.velocity * seconds;
    piece_.begin = box.from;
    piece_.end = box.until;
    zone_.reach = 0.5 * (box.box.max - box.box.min) + room;
    growth_ = box.growth * seconds;
    const Vec3 to = piece_.from + piece_.way;
    const Vec3 size = piece_.from.cwiseAbs() + to.cwiseAbs() + zone_.reach + growth_;
    const Vec3 reach = zone_.reach + growth_ + 1e-12 * size + Vec3::Constant(1e-9);
    all_ = {piece_.from.cwiseMin(to) - reach, piece_.from.cwiseMax(to) + reach};
  }

  bool may_meet(const CourseBox& box) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<int>(i);
      if (box.low[i] > all_.max[axis] || box.high[i] < all_.min[axis]) return false;
    }
    return true;
  }

  // Departures of a flight with this piece.
  std::optional<DepartureSpan> meeting(const StraightPiece& piece) const {
    return meeting_times(piece_, piece, zone_, growth_);
  }

 private:
  StraightPiece piece_;  // of its middle
  Zone zone_;
  Vec3 growth_;
  geom::Aabb all_;  // everywhere that it is
};

void collect(const Course& course, const OnItsWay& box, std::uint32_t at,
             std::vector<DepartureSpan>& out) {
  const CourseNode& node = course.nodes[at];
  if (!box.may_meet(node.box)) return;
  if (node.left != 0) {
    collect(course, box, node.left, out);
    collect(course, box, node.right, out);
    return;
  }
  const auto span = box.meeting(course.pieces[node.piece]);
  if (!span) return;
  const double blur = kBlur + course.blur;
  out.push_back({geom::next_down(span->low - blur), geom::next_up(span->high + blur)});
}

}  // namespace

std::vector<std::vector<DepartureSpan>> forbidden_by_moving(const Trajectory& trajectory,
                                                            const Vec3& room,
                                                            std::span<const MovingBox> boxes,
                                                            Parked parked) {
  std::vector<std::vector<DepartureSpan>> out(boxes.size());
  if (boxes.empty()) return out;
  const Course course = course_of(trajectory, parked, kBend);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    assert(!moving_box_fault(boxes[i]));
    collect(course, OnItsWay(boxes[i], room), 0, out[i]);
    out[i] = united(std::move(out[i]));
  }
  return out;
}

}  // namespace traj
