#include "box_times.h"

#include "geom/base/rounding.h"

namespace traj {

// A sum of n durations is off by n ulps of the whole, and each halving by one more.
BoxTimes::BoxTimes(const geom::BoxMap& map, const std::optional<double>& start, std::size_t pieces,
                   double duration) {
  if (!start || map.timed().empty()) return;
  map_ = &map;
  start_ = *start;
  slack_ = (static_cast<double>(pieces) + 64) * 0x1p-52 * duration;
}

geom::TimeSpan BoxTimes::of(std::size_t box) const {
  if (!map_) return {};
  const geom::TimeSpan time = map_->time(box);
  return {geom::next_down(geom::next_down(time.from - start_) - slack_),
          geom::next_up(geom::next_up(time.until - start_) + slack_)};
}

}  // namespace traj
