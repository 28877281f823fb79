#include "geom/shape/cover.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "few_rectangles.h"
#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "slack_gauge.h"

namespace geom {
namespace {

constexpr double kLeastSlack = 1e-6;  // metres

constexpr double kFew = 32;  // rectangles: all covers are tried

constexpr std::size_t kManyLevels = 4096;

constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Of the few that lie beside each other in a slab, quicker than std::sort.
template <class T, class Less>
void sort_few(std::vector<T>& list, const Less& less) {
  if (list.size() > 24) return std::sort(list.begin(), list.end(), less);
  for (std::size_t i = 1; i < list.size(); ++i) {
    const T one = list[i];
    std::size_t k = i;
    for (; k > 0 && less(one, list[k - 1]); --k) list[k] = list[k - 1];
    list[k] = one;
  }
}

// Those that touch become one; ascending.
void merge(std::vector<Interval>& list) {
  sort_few(list, [](const Interval& a, const Interval& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  std::size_t count = 0;
  for (const Interval& i : list) {
    if (count > 0 && i.low <= list[count - 1].high) {
      list[count - 1].high = std::max(list[count - 1].high, i.high);
    } else {
      list[count++] = i;
    }
  }
  list.resize(count);
}

// The polygon cut by slabs [y0, y1], from the lowest up: what only later slabs meet is not looked
// at.
class Slabs {
 public:
  Slabs(const Polygon& polygon, double slack)
      : slack_(slack), gauge_(slack, polygon.holes.size() + 1), winding_(polygon.holes.size() + 1) {
    std::size_t corners = polygon.outer.size();
    for (const auto& hole : polygon.holes) corners += hole.size();
    edges_.reserve(corners);
    add_edges(polygon.outer, 0, edges_);
    for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
      add_edges(polygon.holes[i], static_cast<int>(i) + 1, edges_);
    }
    std::stable_sort(edges_.begin(), edges_.end(),
                     [](const CoverEdge& a, const CoverEdge& b) { return a.low.y() < b.low.y(); });
    levels_.reserve(2 * corners);
    for (const CoverEdge& edge : edges_) {
      levels_.push_back(edge.low.y());
      levels_.push_back(edge.high.y());
    }
    std::sort(levels_.begin(), levels_.end());
    levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
    const std::size_t few = std::min<std::size_t>(corners, 16);  // beside each other in a slab
    begun_.reserve(few);
    ranges_.reserve(2 * few);
    across_.reserve(few);
    rectangles_.reserve(few);
  }

  // About how many rectangles a cover has. Between two levels, the edge that is most level limits
  // the height of slabs. If there are many levels, only some of them are looked at.
  double expected() {
    double out = 0;
    std::size_t next = 0;
    begun_.clear();
    if (levels_.empty()) return 0;
    const bool many = levels_.size() > kManyLevels;
    const double step = many ? (levels_.back() - levels_.front()) / kManyLevels : 0;
    for (std::size_t level = 0; level + 1 < levels_.size();) {
      const double y0 = levels_[level++];
      while (level + 1 < levels_.size() && levels_[level] - y0 < step) ++level;
      while (next < edges_.size() && edges_[next].low.y() <= y0) begun_.push_back(&edges_[next++]);
      std::erase_if(begun_, [&](const CoverEdge* edge) { return edge->high.y() <= y0; });
      const double slacks = (levels_[level] - y0) / slack_;
      double slabs = std::min(slacks, 1.0);
      for (const CoverEdge* edge : begun_) {
        slabs = std::max(slabs, slacks * edge->run_over_length);
      }
      out += slabs * 0.5 * static_cast<double>(begun_.size());
    }
    return out;
  }

  // Slabs that each reach as far as they may. Nothing where they have `most` rectangles or more.
  std::optional<std::vector<Rectangle>> cover_far(std::size_t most) {
    to_corners_ = false;
    fork_.reset();
    return cover_from({levels_.empty() ? 0 : levels_.front(), {}, {}}, most);
  }

  // After cover_far(): slabs that end at a corner's level where they reach one. Nothing where they
  // have `most` rectangles or more, and where both covers are the same.
  std::optional<std::vector<Rectangle>> cover_to_corners(std::size_t most) {
    to_corners_ = true;
    return fork_ ? cover_from(*fork_, most) : std::nullopt;
  }

 private:
  // Where a slab begins.
  struct Begin {
    double y0;
    std::vector<Rectangle> below;
    SlackGauge::Refusal refusal;
  };

  std::optional<std::vector<Rectangle>> cover_from(Begin first, std::size_t most) {
    next_ = 0;
    level_ = 0;
    begun_.clear();
    gauge_.set_refusal(first.refusal);
    std::vector<Rectangle> out = std::move(first.below);
    for (double y0 = first.y0; !edges_.empty() && y0 < levels_.back();) {
      begin(y0);
      const SlackGauge::Refusal refusal = gauge_.refusal();
      const double y1 = furthest(y0);
      if (passes_corner_ && !fork_) fork_ = {y0, out, refusal};
      for (const Rectangle& r : rectangles(y0, y1)) out.push_back(r);
      if (out.size() >= most) return std::nullopt;
      y0 = is_straight_ ? cover_straight(y0, y1, out) : y1;
      if (out.size() >= most) return std::nullopt;
    }
    add_flat_edges(out);
    if (out.size() >= most) return std::nullopt;
    return out;
  }

  // Edges along the slabs bound them and are covered with what they bound; spurs are not.
  void add_flat_edges(std::vector<Rectangle>& out) const {
    for (const CoverEdge& edge : edges_) {
      if (edge.low.y() < edge.high.y()) continue;
      const Interval x = edge.range(edge.low.y(), edge.low.y());
      std::vector<Interval> list;
      for (const Rectangle& r : out) {
        if (r.min.y() <= edge.low.y() && r.max.y() >= edge.low.y()) {
          list.push_back({r.min.x(), r.max.x()});
        }
      }
      merge(list);
      if (std::any_of(list.begin(), list.end(),
                      [&](const Interval& i) { return i.low <= x.low && i.high >= x.high; })) {
        continue;
      }
      out.push_back({{outward(x.low, -1), outward(edge.low.y(), -1)},
                     {outward(x.high, 1), outward(edge.low.y(), 1)}});
    }
  }

  // A slab from y0: forgets the edges that end so far below that no slab from there on asks for
  // them, and gives the gauge those that begin below or near.
  void begin(double y0) {
    while (next_ < edges_.size() && edges_[next_].low.y() <= y0) begun_.push_back(&edges_[next_++]);
    while (level_ + 1 < levels_.size() && levels_[level_] <= y0) ++level_;
    std::erase_if(begun_,
                  [&](const CoverEdge* edge) { return edge->high.y() < y0 - 1.5 * slack_; });
    gauge_.begin(y0, begun_);
    given_ = next_;
  }

  // A slab up to y1: gives the gauge what else may be near, and takes back what is further up.
  void reach_to(double y1) {
    const double far = y1 + 1.5 * slack_;
    for (; given_ > next_ && edges_[given_ - 1].low.y() > far; --given_) gauge_.take_back();
    for (; given_ < edges_.size() && edges_[given_].low.y() <= far; ++given_) {
      gauge_.add(edges_[given_]);
    }
    gauge_.reach_to(y1);
  }

  // Of what lies inside the open slab, and its closure: the edges' own ranges of x, and the gaps
  // between them that lie inside. An upright line through a gap meets no edge in the slab, so it is
  // inside as a whole or outside as a whole, and its middle tells; edges may cross as they like.
  const std::vector<Rectangle>& rectangles(double y0, double y1) {
    reach_to(y1);
    const double middle = 0.5 * (y0 + y1);
    ranges_.clear();
    across_.clear();
    for (const CoverEdge* edge : gauge_.edges()) {
      if (!(edge->high.y() > y0 && edge->low.y() < y1)) continue;
      ranges_.push_back(edge->range(y0, y1));
      if (edge->low.y() <= middle && edge->high.y() > middle) {
        across_.emplace_back(edge->x_at(middle), edge);
      }
    }
    sort_few(across_, std::less<>());
    winding_.clear();
    for (std::size_t i = 0; i + 1 < across_.size(); ++i) {
      winding_.count(*across_[i].second);
      if (i % 2 != 0 && !winding_.inside()) continue;
      ranges_.push_back({across_[i].first, across_[i + 1].first});
    }
    merge(ranges_);
    rectangles_.clear();
    for (const Interval& i : ranges_) {
      rectangles_.push_back(
          {{outward(i.low, -1), outward(y0, -1)}, {outward(i.high, 1), outward(y1, 1)}});
    }
    return rectangles_;
  }

  // The highest slab from y0 that is surely valid without a look. Each x of its rectangles is that
  // of a point of the polygon in the slab, so one no higher than the slack is always right.
  double surely_valid(double y0) const {
    return std::min(levels_.back(), y0 + slack_ - 4e-9 - 1e-14 * std::abs(y0));
  }

  // How much more than the highest slab between two corners is surely too much.
  double too_much() const { return slack_ / 8; }

  // How far the slab from y0 may reach.
  double furthest(double y0) {
    const double top = levels_.back();
    const double sure = surely_valid(y0);
    // Between corners nothing has to be tried, but that a little more is too far.
    height_ = height_between_corners(y0);
    const double straight = std::max(sure, y0 + height_);
    const double more = straight + too_much();
    is_straight_ = more < levels_[level_] && !valid(y0, more);
    passes_corner_ = false;
    if (is_straight_) return straight;
    double good = sure;
    double bad = kInfinity;
    std::size_t level = level_;  // the first above `sure`
    while (level < levels_.size() && levels_[level] <= sure) ++level;
    for (; level < levels_.size(); ++level) {
      if (!valid(y0, levels_[level])) {
        bad = levels_[level];
        break;
      }
      good = levels_[level];
    }
    if (good >= top) return good;
    passes_corner_ = good > sure;
    if (to_corners_ && passes_corner_) return good;
    const double most = good + 8 * slack_;
    if (bad <= most) return between(y0, good, bad);
    return valid(y0, most) ? most : between(y0, good, most);
  }

  // Halves six times between a slab that is valid, or surely would be, and one that is not. Every
  // slab within a valid one is valid. So the halvings first ask one corner alone, the one that
  // refused a slab last. The slab where they end is looked at as a whole.
  double between(double y0, double good, double bad) {
    bool guess = true;
    for (double least_bad = bad;;) {
      double low = good;
      double high = bad;
      if (guess) follow_corner(good, bad);
      for (int i = 0; i < 6; ++i) {
        const double middle = 0.5 * (low + high);
        const bool refused =
            middle >= least_bad || (guess ? gauge_.corner_refuses(middle) : !valid(y0, middle));
        (refused ? high : low) = middle;
      }
      if (!guess || low == good || valid(y0, low)) return low;
      least_bad = low;
      guess = gauge_.refuses_again();  // else something that corners do not tell
    }
  }

  // Slabs like that from y0 to y1, which is the highest between two corners, as long as a look at
  // each would find the same. Returns where the last one ends.
  double cover_straight(double y0, double y1, std::vector<Rectangle>& out) {
    const double level = levels_[level_];
    const double more = y1 + too_much();
    reach_to(level);
    gauge_.reach_to(more);
    if (!gauge_.refuses_further(level - more)) return y1;
    for (y0 = y1;; y0 = y1) {
      y1 = std::max(surely_valid(y0), y0 + height_);
      if (!(y1 + too_much() < level)) return y0;
      if (!add_straight(y0, y1, out)) {
        for (const Rectangle& r : rectangles(y0, y1)) out.push_back(r);
      }
    }
  }

  // The rectangles of a slab in which no edge ends, where the edges' own ranges of x do not meet.
  bool add_straight(double y0, double y1, std::vector<Rectangle>& out) {
    spans_.clear();
    for (const CoverEdge* edge : begun_) {
      if (edge->high.y() > y0) spans_.push_back({edge->range(y0, y1), edge});
    }
    sort_few(spans_, [](const Span& a, const Span& b) { return a.x.low < b.x.low; });
    for (std::size_t i = 0; i + 1 < spans_.size(); ++i) {
      if (spans_[i].x.high >= spans_[i + 1].x.low) return false;
    }
    winding_.clear();
    const double low = outward(y0, -1);
    const double high = outward(y1, 1);
    for (std::size_t i = 0, first = 0; i < spans_.size(); ++i) {
      winding_.count(*spans_[i].edge);
      if (i + 1 < spans_.size() && (i % 2 == 0 || winding_.inside())) continue;
      out.push_back(
          {{outward(spans_[first].x.low, -1), low}, {outward(spans_[i].x.high, 1), high}});
      first = i + 1;
    }
    return true;
  }

  // How high a slab from y0 may be in which no edge ends. What an edge bounds there has it as its
  // diagonal, and the two other corners are furthest from it: height times run over length.
  double height_between_corners(double y0) const {
    double out = kInfinity;
    for (const CoverEdge* edge : begun_) {
      if (edge->high.y() > y0) out = std::min(out, edge->length_over_run);
    }
    return SlackGauge::surely_near(slack_) * out;
  }

  // Prepares the gauge to ask the corner that refused the last slab about slabs between these.
  void follow_corner(double good, double bad) {
    reach_to(bad);
    gauge_.follow_corner(good);
  }

  // Whether the slab's rectangles stay within the slack.
  bool valid(double y0, double y1) {
    reach_to(y1);
    if (const auto clear = gauge_.clear_case()) return *clear;
    for (const Rectangle& r : rectangles(y0, y1)) {
      if (!gauge_.allows(r)) return false;
    }
    return true;
  }

  struct Span {
    Interval x;
    const CoverEdge* edge;
  };

  double slack_;
  bool to_corners_ = false;
  SlackGauge gauge_;
  Winding winding_;
  std::vector<CoverEdge> edges_;  // by their lower end
  std::vector<double> levels_;    // the y of all corners, ascending
  // Of the slab that is looked at.
  std::size_t level_ = 0;                // the first above it, or the last
  std::size_t next_ = 0;                 // the first edge that begins above the slab's lower end
  std::size_t given_ = 0;                // the first that the gauge does not know
  std::vector<const CoverEdge*> begun_;  // those before it that are still near
  std::optional<Begin> fork_;            // the first that reaches further than to a corner
  bool passes_corner_ = false;           // or might
  bool is_straight_ = false;             // between two corners, and as high as it may be there
  double height_ = 0;                    // that one may have between two corners
  std::vector<Span> spans_;
  std::vector<Interval> ranges_;
  std::vector<std::pair<double, const CoverEdge*>> across_;
  std::vector<Rectangle> rectangles_;
};

// Takes a cover of the slabs where it has fewer than `most` rectangles. Returns whether it has.
bool improve(std::vector<Rectangle>& best, std::size_t& most, Slabs& slabs, bool to_corners_too) {
  bool improved = false;
  const auto take = [&](std::optional<std::vector<Rectangle>> fewer) {
    if (!fewer) return;
    best = std::move(*fewer);
    most = best.size();
    improved = true;
  };
  take(slabs.cover_far(most));
  // A cover whose slabs end at corners is taken also where it has as many.
  if (to_corners_too) take(slabs.cover_to_corners(improved ? most + 1 : most));
  return improved;
}

Polygon transposed(const Polygon& polygon) {
  const auto swap = [](std::vector<Vec2> ring) {
    for (Vec2& p : ring) std::swap(p.x(), p.y());
    return ring;
  };
  Polygon out{swap(polygon.outer), {}};
  for (const auto& hole : polygon.holes) out.holes.push_back(swap(hole));
  return out;
}

void require(const Polygon& polygon, double slack) {
  double largest = 0;
  const auto look_at = [&](const std::vector<Vec2>& ring) {
    for (const Vec2& p : ring) {
      require_point("polygon", {p.x(), p.y(), 0});
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
  };
  look_at(polygon.outer);
  for (const auto& hole : polygon.holes) look_at(hole);
  const double least = std::max(kLeastSlack, 0.999 * 1e-9 * largest);  // a product may be rounded
  if (slack >= least && slack <= kLargestCoordinate) return;
  throw InputError("slack",
                   {.expected = fmt::format("metres from {} to {}", least, kLargestCoordinate),
                    .found = fmt::to_string(slack)});
}

}  // namespace

std::vector<Rectangle> cover(const Polygon& polygon, double slack) {
  require(polygon, slack);
  if (const auto one = one_rectangle(polygon, slack)) return {*one};
  const Polygon turned = transposed(polygon);
  if (auto pieces = long_pieces(polygon, turned, slack); !pieces.empty()) return pieces;
  std::vector<Rectangle> best;
  std::size_t most = kAny;
  bool is_turned = false;
  Slabs upright(polygon, slack);
  const double expected = upright.expected();
  if (expected < kFew) {
    improve(best, most, upright, true);
    if (most > 1) {
      Slabs level(turned, slack);
      is_turned = improve(best, most, level, true);
    }
  } else {
    Slabs level(turned, slack);
    const double expected_turned = level.expected();
    // An expected count is wrong by about its square root.
    const bool both =
        std::abs(expected - expected_turned) <= std::sqrt(std::min(expected, expected_turned));
    if (both || expected <= expected_turned) improve(best, most, upright, false);
    if (both || expected > expected_turned) is_turned = improve(best, most, level, false);
  }
  if (is_turned) {
    for (Rectangle& r : best) {
      std::swap(r.min.x(), r.min.y());
      std::swap(r.max.x(), r.max.y());
    }
  }
  return best;
}

}  // namespace geom
