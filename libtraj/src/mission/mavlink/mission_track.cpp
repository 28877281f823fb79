#include "mission_track.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace traj {

void FlownTrack::go(const Vec3& p, double hold, const FlightPart& part, Turn turn) {
  if (!path_.empty() && p != path_.back()) unsaid_speed_ = unsaid_speed_ || own_;
  if (!leaving_.empty()) {
    Hull hull = std::exchange(leaving_, {});
    if (turn.radius > 0) turn.from = hull;
    hull.push_back(p);
    sweep(std::move(hull), part);
  }
  path_.push_back(p);
  hold_.push_back(hold);
  legs_.push_back(part);
  turns_.push_back(std::move(turn));
  speeds_.push_back(now_);
}

void FlownTrack::sweep(Hull hull, const FlightPart& part, std::optional<double> stands_on) {
  sweeps_.push_back({std::move(hull), part, stands_on});
}

Hull FlownTrack::reached() const {
  const std::size_t last = path_.size() - 1;
  Hull hull = begin_of_turn(last);
  hull.push_back(path_[last]);
  for (std::size_t i = last; i-- > 0;) {
    if (turns_[i].kind == Turn::rest) break;
    if ((path_[last] - path_[i]).norm() > turns_[i].radius + turns_[last].radius) break;
    const Hull before = begin_of_turn(i);
    hull.insert(hull.end(), before.begin(), before.end());
    hull.push_back(path_[i]);
  }
  return hull;
}

Hull FlownTrack::begin_of_turn(std::size_t i) const {
  Hull hull;
  const auto add = [&](const Vec3& from) {
    hull.push_back(before_corner(from, path_[i], turns_[i].radius));
  };
  if (i > 0) add(path_[i - 1]);
  for (const Vec3& from : turns_[i].from) add(from);
  return hull;
}

void FlownTrack::leave_when_reached() {
  if (turns_.back().radius > 0 && leaving_.empty()) leaving_ = reached();
}

Hull FlownTrack::from_where() {
  if (leaving_.empty()) return reached();
  return std::exchange(leaving_, {});
}

void FlownTrack::say_speed(double speed) {
  speed_ = std::max(speed_.value_or(0), speed);
  now_ = speed;
  own_ = false;
}

void FlownTrack::may_fly_at(double speed, double own) {
  speed_ = std::max(speed_.value_or(0), speed);
  now_ = std::max(now_.value_or(own), speed);
}

void FlownTrack::may_fly_at_own(double own) {
  if (now_) now_ = std::max(*now_, own);
  own_ = true;
}

double FlownTrack::most_speed(double unsaid) const {
  const double said = speed_.value_or(0);
  return unsaid_speed_ || !speed_ ? std::max(said, unsaid) : said;
}

std::size_t FlownTrack::tight_radii(const Autopilot& autopilot) const {
  if (!autopilot.heeds_item_radius) return 0;
  return static_cast<std::size_t>(std::count_if(turns_.begin(), turns_.end(), [&](const Turn& one) {
    return one.said > 0 && one.said < autopilot.least_radius;
  }));
}

std::vector<Drift> FlownTrack::drift(std::span<const Autopilot> autopilots,
                                     const FlightPart& landing, double return_height,
                                     const FlownMission& out) const {
  std::vector<Drift> all;
  for (const Autopilot& autopilot : autopilots) {
    const DriftTask task{path_,   hold_,   legs_,    turns_,    speeds_,
                         sweeps_, landing, out.ends, out.rally, return_height};
    all.push_back(drift_of(autopilot, task));
  }
  return all;
}

void FlownTrack::finish(const FlightPart& landing, double braking_way, FlownMission& out) {
  Corners corners = corners_of(path_, turns_, legs_, braking_way);
  out.corners = corners.count;
  out.acceptance = corners.most_radius;
  std::move(corners.sweeps.begin(), corners.sweeps.end(), std::back_inserter(sweeps_));
  legs_.push_back(landing);
  out.path = std::move(path_);
  out.hold = std::move(hold_);
  out.legs = std::move(legs_);
  out.sweeps = std::move(sweeps_);
  if (!unsaid_speed_) out.speed = speed_;
}

}  // namespace traj
