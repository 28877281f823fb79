#include "fleet/forbidden_between.h"

#include <algorithm>
#include <limits>

#include "fleet/meeting_times.h"
#include "geom/base/rounding.h"

namespace traj {
namespace {

constexpr double kStraight = 1.0 / 200;  // of a zone's reach
constexpr double kBlur = 1e-6;           // seconds

class Search {
 public:
  Search(const Course& first, const Course& second, const Zone& zone, const DepartureSpan& window)
      : first_(first),
        second_(second),
        zone_(zone),
        window_(window),
        blur_(kBlur + first.blur + second.blur) {
    // As the boxes are single precision, so is what is compared with them.
    for (std::size_t i = 0; i < 3; ++i) {
      reach_[i] = geom::float_up(zone.reach[static_cast<int>(i)]);
    }
  }

  void run(std::vector<DepartureSpan>& out) { descend(0, 0, out); }

 private:
  // Whether the boxes are so near as the zone's own box; in doubles the differences of floats of
  // these sizes are rounded by less than they are padded here.
  bool near(const CourseBox& a, const CourseBox& b) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const double below = static_cast<double>(a.low[i]) - b.high[i];
      const double above = static_cast<double>(b.low[i]) - a.high[i];
      if (below > reach_[i] || above > reach_[i]) return false;
    }
    return true;
  }

  bool in_window(const CourseBox& a, const CourseBox& b) const {
    return difference(a.begin, b.end) - blur_ <= window_.high &&
           difference(a.end, b.begin) + blur_ >= window_.low;
  }

  static double difference(double t, double s) { return t - s; }

  void descend(std::uint32_t a, std::uint32_t b, std::vector<DepartureSpan>& out) const {
    const CourseNode& one = first_.nodes[a];
    const CourseNode& other = second_.nodes[b];
    if (!near(one.box, other.box) || !in_window(one.box, other.box)) return;
    if (one.left == 0 && other.left == 0) return meet(one.piece, other.piece, out);
    if (other.left == 0 || (one.left != 0 && longer(one.box, other.box))) {
      descend(one.left, b, out);
      descend(one.right, b, out);
    } else {
      descend(a, other.left, out);
      descend(a, other.right, out);
    }
  }

  static bool longer(const CourseBox& a, const CourseBox& b) {
    float most = 0;
    float least = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      most = std::max(most, a.high[i] - a.low[i]);
      least = std::max(least, b.high[i] - b.low[i]);
    }
    return most >= least;
  }

  void meet(std::uint32_t a, std::uint32_t b, std::vector<DepartureSpan>& out) const {
    const auto span = meeting_times(first_.pieces[a], second_.pieces[b], zone_);
    if (!span) return;
    const DepartureSpan wide{std::max(span->low - blur_, window_.low),
                             std::min(span->high + blur_, window_.high)};
    if (wide.low <= wide.high) out.push_back(wide);
  }

  const Course& first_;
  const Course& second_;
  const Zone& zone_;
  DepartureSpan window_;
  double blur_;
  std::array<double, 3> reach_{};
};

}  // namespace

Bend bend_for(std::span<const Zone> zones) {
  Bend bend{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const Zone& zone : zones) {
    bend.across = std::min({bend.across, kStraight * zone.reach.x(), kStraight * zone.reach.y()});
    bend.up = std::min(bend.up, kStraight * zone.reach.z());
  }
  return bend;
}

std::vector<DepartureSpan> forbidden_between(const Course& first, const Course& second,
                                             std::span<const Zone> zones,
                                             const DepartureSpan& window) {
  std::vector<DepartureSpan> out;
  for (const Zone& zone : zones) Search(first, second, zone, window).run(out);
  return united(std::move(out));
}

}  // namespace traj
