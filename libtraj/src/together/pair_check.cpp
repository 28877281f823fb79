#include "traj/together/pair_check.h"

#include <algorithm>
#include <cmath>

#include "judgeable.h"
#include "pair_search.h"
#include "timeline.h"
#include "zone_side.h"

namespace traj {
namespace {

constexpr int kDeepest = 60;
constexpr double kSmallest = 1e-10;            // metres: a piece this small is not halved
constexpr std::size_t kMostPieces = 1u << 18;  // of a pair and zone
constexpr double kFine = 1e-3;                 // s: spans of conflict are found to this
constexpr int kMostCuts = 24;                  // halvings for them
constexpr std::size_t kMostBad = 20000;        // pieces that spans are made of

// A stretch as a curve, and when it is.
struct Course {
  RelativeCurve curve;
  TimeSpan time;
  bool still = false;  // both are parked
};

class PairSearch {
 public:
  PairSearch(const Timeline& a, const Timeline& b, Parked parked)
      : a_(a), b_(b), gap_(a.gap + b.gap) {
    for (const CommonStretch& stretch : stretches(a_, b_, parked)) {
      Course course{relative_curve(a_, b_, stretch), {}, !stretch.segment && !stretch.other};
      if (stretch.begin) course.time.begin = seconds_of(*stretch.begin);
      if (stretch.end) course.time.end = seconds_of(*stretch.end);
      courses_.push_back(course);
    }
  }

  PairResult decide(std::span<const Zone> zones) {
    PairResult result;
    result.apart = true;
    std::vector<std::size_t> bad;  // zones
    for (std::size_t i = 0; i < zones.size(); ++i) {
      budget_ = kMostPieces;
      for (const Course& course : courses_) {
        if (apart(zones[i], course, course.curve.q, 0)) continue;
        bad.push_back(i);
        break;
      }
      result.pieces += kMostPieces - budget_;
    }
    if (bad.empty()) return result;
    result.apart = false;
    measure(zones, bad, result);
    return result;
  }

 private:
  // Rounded up by far more than the two sums.
  double pad(const Course& course, int halvings) const {
    return (rounding_after(course.curve, halvings) + gap_) * (1 + 0x1p-50);
  }

  static bool too_small(const Points<kPoints>& q, double pad, int depth) {
    const geom::Aabb box = hull_box(q);
    return depth >= kDeepest || (box.max - box.min).maxCoeff() < std::max(kSmallest, pad);
  }

  // Whether every point of the curve is shown to be outside of the zone. False as soon as one is
  // known that cannot be.
  bool apart(const Zone& zone, const Course& course, const Points<kPoints>& q, int depth) {
    if (budget_ == 0) return false;
    --budget_;
    const double off = pad(course, depth);
    if (beyond(zone, q, off)) return true;
    if (within(zone, q.front(), off) || within(zone, q.back(), off)) return false;
    if (too_small(q, off, depth)) return false;
    const auto [left, right] = halves(q);
    return apart(zone, course, left, depth + 1) && apart(zone, course, right, depth + 1);
  }

  // A part that is not shown to be outside of the zone.
  struct Bad {
    Piece piece;
    std::size_t course;
  };

  // Those of a course, no longer than kFine, in order.
  void collect(const Zone& zone, std::size_t at, const Piece& piece, int depth,
               std::vector<Bad>& out) const {
    const Course& course = courses_[at];
    const double off = pad(course, depth);
    if (beyond(zone, piece.q, off)) return;
    const bool inside = std::all_of(piece.q.begin(), piece.q.end(),
                                    [&](const Vec3& p) { return within(zone, p, off); });
    const bool cut = !inside && !course.still && depth < kMostCuts &&
                     piece.end - piece.begin > kFine && out.size() < kMostBad &&
                     !too_small(piece.q, off, depth);
    if (!cut) {
      out.push_back({piece, at});
      return;
    }
    const auto [left, right] = piece.halved();
    collect(zone, at, left, depth + 1, out);
    collect(zone, at, right, depth + 1, out);
  }

  void measure(std::span<const Zone> zones, const std::vector<std::size_t>& bad_zones,
               PairResult& result) const {
    double best = kInfinity;
    bool shown = false;
    for (const std::size_t i : bad_zones) {
      std::vector<Bad> bad;
      for (std::size_t at = 0; at < courses_.size(); ++at) {
        const Course& course = courses_[at];
        collect(zones[i], at, {course.curve.q, course.time.begin, course.time.end}, 0, bad);
      }
      if (bad.empty()) all_of(bad);  // the halvings came to an end before, and not here
      for (const Bad& part : bad) result.when.push_back({part.piece.begin, part.piece.end});
      const Largest nearest = nearest_of(zones[i], bad);
      const double share = -nearest.value;
      if (share >= best) continue;
      best = share;
      tell(zones[i], i, nearest, result);
      const double off = pad(largest_course(), kDeepest);
      shown = shown || within(zones[i], nearest.place, off);
    }
    result.undecided = !shown;
    join(result.when);
  }

  void all_of(std::vector<Bad>& bad) const {
    for (std::size_t at = 0; at < courses_.size(); ++at) {
      const Course& course = courses_[at];
      bad.push_back({{course.curve.q, course.time.begin, course.time.end}, at});
    }
  }

  const Course& largest_course() const {
    return *std::max_element(
        courses_.begin(), courses_.end(),
        [](const Course& a, const Course& b) { return a.curve.scale < b.curve.scale; });
  }

  // Where a piece is nearest in the norm of the zone: the value is less that.
  static Largest nearest_of(const Zone& zone, const std::vector<Bad>& bad) {
    std::vector<Piece> pieces;
    for (const Bad& part : bad) {
      pieces.push_back(part.piece);
      Piece& piece = pieces.back();
      if (std::isfinite(piece.begin) && std::isfinite(piece.end)) continue;
      // At rest: any instant stands for all.
      const double instant = std::isfinite(piece.begin) ? piece.begin : piece.end;
      piece.begin = piece.end = std::isfinite(instant) ? instant : 0;
    }
    Largest best;
    search_largest(
        pieces, 1e-6,
        [&](const Piece& piece, const Vec3& middle) {
          return Estimate{-share_of(zone, middle), -least_share(zone, hull_box(piece.q))};
        },
        best);
    return best;
  }

  void tell(const Zone& zone, std::size_t index, const Largest& nearest, PairResult& result) const {
    result.zone = index;
    result.time = nearest.time;
    result.share = -nearest.value;
    result.place = position(a_, nearest.time);
    result.other = result.place - nearest.place;
    result.depth = depth_in(zone, nearest.place);
  }

  static Vec3 position(const Timeline& line, double time) {
    const Ticks at = std::clamp(whole_ticks(time), line.joint.front(), line.joint.back());
    const auto next = std::upper_bound(line.joint.begin() + 1, line.joint.end() - 1, at);
    const auto i = static_cast<std::size_t>(next - line.joint.begin()) - 1;
    const Segment& segment = (*line.segments)[i];
    return evaluate(segment, std::clamp(seconds_of(at - line.joint[i]), 0.0, segment.duration))
        .position;
  }

  // To the nearest below 2e9 s: what a report says, never what decides.
  static Ticks whole_ticks(double time) { return std::abs(time) < kLeastTick ? 0 : ticks_of(time); }

  static void join(std::vector<TimeSpan>& spans) {
    std::sort(spans.begin(), spans.end(), [](const TimeSpan& a, const TimeSpan& b) {
      return a.begin != b.begin ? a.begin < b.begin : a.end < b.end;
    });
    std::vector<TimeSpan> out;
    for (const TimeSpan& span : spans) {
      if (!out.empty() && span.begin <= out.back().end) {
        out.back().end = std::max(out.back().end, span.end);
      } else {
        out.push_back(span);
      }
    }
    spans = std::move(out);
  }

  static constexpr double kLeastTick = 1e-9;

  const Timeline& a_;
  const Timeline& b_;
  double gap_;
  std::vector<Course> courses_;
  std::size_t budget_ = 0;
};

}  // namespace

PairResult check_pair(const TimedFlight& a, const TimedFlight& b, std::span<const Zone> zones,
                      Parked parked) {
  require_judgeable(a);
  require_judgeable(b);
  for (const Zone& zone : zones) require_judgeable(zone);
  return check_pair(Timeline(a), Timeline(b), zones, parked);
}

PairResult check_pair(const Timeline& a, const Timeline& b, std::span<const Zone> zones,
                      Parked parked) {
  return PairSearch(a, b, parked).decide(zones);
}

}  // namespace traj
