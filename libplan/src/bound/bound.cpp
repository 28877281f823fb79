#include "plan/bound/bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "convex_edges.h"
#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "line_label.h"
#include "occluders.h"
#include "plan/planner/taut.h"

namespace plan {
namespace {

constexpr double kPart = 10;   // metres: the longest part of the first level
constexpr int kLevels = 16;    // at most, each of parts half as long
constexpr double kAgain = 10;  // metres that a label may become less before its links are made anew
// From this level on the search ends where the target is further away than so many times what the
// last two levels gained.
constexpr int kTried = 9;
constexpr double kHope = 4;
constexpr double kOff = 1e-3;     // metres that a path tried keeps from the edges
constexpr int kSlides = 20;       // rounds of moving its bends along them
constexpr std::size_t kKeep = 8;  // steps that a link counts: they take memory
constexpr std::size_t kLook = 4;  // steps that looking for an occluder counts
constexpr std::uint32_t kStart = 0;
constexpr std::uint32_t kGoal = 1;

enum class Sight : std::uint8_t { unknown, open, hidden };

// What a bound must be for a path of `length` to have the gap.
double target_of(double length, double gap) {
  double target = length / (1 + gap);
  while (length / target - 1 > gap) {
    target = std::nextafter(target, std::numeric_limits<double>::infinity());
  }
  return target;
}

// A short path over the parts in turn, a little outside of each.
geom::Polyline over(const std::vector<EdgePart>& parts, const Vec3& from, const Vec3& to) {
  geom::Polyline path{from};
  for (const EdgePart& part : parts) path.push_back(0.5 * (part.low + part.high));
  path.push_back(to);
  const auto off_line = [](const EdgePart& part, const Vec3& p) {
    const int a = (part.axis + 1) % 3;
    const int b = (part.axis + 2) % 3;
    return std::hypot(p[a] - part.low[a], p[b] - part.low[b]);
  };
  for (int round = 0; round < kSlides; ++round) {
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const EdgePart& part = parts[i - 1];
      if (part.is_corner()) continue;
      // As a straight line once both legs lie in a plane.
      const double before = off_line(part, path[i - 1]);
      const double after = off_line(part, path[i + 1]);
      if (!(before + after > 0)) continue;
      const int k = part.axis;
      const double at = (path[i - 1][k] * after + path[i + 1][k] * before) / (before + after);
      path[i][k] = std::clamp(at, part.low[k], part.high[k]);
    }
  }
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const EdgePart& part = parts[i - 1];
    if (part.is_corner()) continue;
    path[i][(part.axis + 1) % 3] += kOff * part.outward[0];
    path[i][(part.axis + 2) % 3] += kOff * part.outward[1];
  }
  return path;
}

// From a part to another: which of their sides the two lie on, as sides() says.
struct Link {
  std::uint32_t to;
  std::uint8_t here;   // sides of the part that this starts from
  std::uint8_t there;  // of `to`
  Sight sight;         // hidden: an occluder is in between; looked at where it matters
  double distance;     // at least
};

// A state is a part and the side that a path comes from: 2 part + side. It leaves to the other.
using State = std::uint32_t;

// The parts of one size that a path shorter than wanted may use.
struct Level {
  std::vector<EdgePart> parts;  // the start, the goal, then the others
  std::vector<LineLabel> come;  // of each state: known lower bounds of the way from the start
  std::vector<LineLabel> go;    // … and to the goal; not set: no path uses it
  std::vector<std::vector<Link>> links;  // of each part
  std::vector<double> linked;            // of each part of the first level: for which label
  std::vector<std::uint32_t> hints;      // of each part: an occluder that hid another from it
};

class Search {
 public:
  Search(const geom::CollisionScene& scene, const Occluders& occluders, const BoundOptions& options,
         double length, double slack)
      : scene_(scene),
        occluders_(occluders),
        options_(options),
        shortest_(length),
        target_(target_of(length, options.gap)),
        slack_(slack) {}

  LengthBound bound(Level level) {
    LengthBound result;
    std::vector<double> reached;
    bool lists = false;  // whether the level has its links
    for (int n = 0; n < kLevels; ++n) {
      const auto g =
          lists ? forward(level, [](std::uint32_t, double) {})
                : forward(level, [&](std::uint32_t i, double come) { link(level, i, come); });
      if (spent()) break;
      ++result.levels;
      const LineLabel& end = g[2 * kGoal];
      if (!end.is_set() || end.low >= target_) {
        result.bound = target_;
        result.closed = true;
        break;
      }
      result.bound = std::max(result.bound, end.low);
      shorten(level, result);
      if (result.bound >= target_) {
        result.closed = true;
        break;
      }
      const auto h = backward(level, g);
      if (spent()) break;
      const LineLabel& begin = h[2 * kStart];
      if (!begin.is_set()) {
        result.bound = target_;
        result.closed = true;
        break;
      }
      result.bound = std::max(result.bound, begin.low);
      reached.push_back(result.bound);
      if (n >= kTried &&
          target_ - result.bound > kHope * (result.bound - reached[reached.size() - 3]))
        break;
      level = finer(level, g, h, std::ldexp(kPart, -n - 1));
      if (spent()) break;
      lists = true;
    }
    result.steps = steps_;
    return result;
  }

 private:
  using Queued = std::pair<double, State>;
  using Queue = std::priority_queue<Queued, std::vector<Queued>, std::greater<>>;

  bool spent() const { return steps_ > options_.most; }

  static bool leaves(const EdgePart& part, int side, std::uint8_t here) {
    return part.is_corner() || (here >> (1 - side) & 1);
  }
  static int sides_of(const EdgePart& part) { return part.is_corner() ? 1 : 2; }

  // A label with a line put into it: what is left is below both, or is `floor`, which holds anyway.
  static LineLabel lowered(const LineLabel& label, const LineLabel& by, const LineLabel& floor) {
    const LineLabel now{std::min(label.low, by.low), std::min(label.high, by.high)};
    return floor.covers(now) ? floor : now;
  }

  // Whether no label of a part can become lower by a line that is carried over `d` metres to
  // `least` or more, less what a distance can sag.
  bool is_idle(const std::vector<LineLabel>& labels, const std::vector<LineLabel>& floors,
               std::uint32_t j, const EdgePart& part, double least, double d) const {
    const double length = part.length();
    const double by = least - length * length / (8 * d) - slack_;
    for (const State s : {2 * j, 2 * j + 1}) {
      const bool idle = labels[s] == floors[s] || std::max(labels[s].low, labels[s].high) <= by;
      if (!idle) return false;
    }
    return true;
  }

  bool in_sight(Level& level, std::uint32_t i, Link& link) {
    if (link.sight == Sight::unknown) {
      steps_ += kLook;
      const bool hidden = occluders_.between(level.parts[i], level.parts[link.to], level.hints[i]);
      link.sight = hidden ? Sight::hidden : Sight::open;
    }
    return link.sight == Sight::open;
  }

  // All links of a part that a path shorter than wanted may have which comes to it in `come` metres
  // at least: made anew where that is less than before.
  void link(Level& level, std::uint32_t i, double come) {
    if (come >= level.linked[i]) return;
    come = std::max(least(level.come, i), come - kAgain);
    level.linked[i] = come;
    auto& links = level.links[i];
    links.clear();
    const EdgePart& part = level.parts[i];
    for (std::uint32_t j = 0; j < level.parts.size(); ++j) {
      if (j != i) consider(level, {part, come}, j, Sight::unknown, links);
    }
  }

  static double least(const std::vector<LineLabel>& labels, std::uint32_t part) {
    return std::min(labels[2 * part].least(), labels[2 * part + 1].least());
  }

  struct From {
    const EdgePart& part;
    double come;
  };

  void consider(const Level& level, const From& from, std::uint32_t j, Sight sight,
                std::vector<Link>& links) {
    ++steps_;
    const EdgePart& part = level.parts[j];
    const double d = least_distance(from.part, part);
    if (from.come + d + least(level.go, j) >= target_) return;
    const int here = sides(from.part, part);
    if (here == 0) return;
    const int there = sides(part, from.part);
    if (there == 0) return;
    steps_ += kKeep;
    links.push_back(
        {j, static_cast<std::uint8_t>(here), static_cast<std::uint8_t>(there), sight, d});
  }

  // Lower bounds of the way to each state, where it is short enough.
  template <class Prepare>
  std::vector<LineLabel> forward(Level& level, const Prepare& prepare) {
    std::vector<LineLabel> g(2 * level.parts.size());
    std::vector<char> waits(g.size(), 0);
    Queue queue;
    g[2 * kStart] = {0, 0};
    before_.assign(g.size(), 2 * kStart);
    queue.push({0, 2 * kStart});
    waits[2 * kStart] = 1;
    while (!queue.empty()) {
      const State state = queue.top().second;
      queue.pop();
      if (!waits[state]) continue;
      waits[state] = 0;
      const std::uint32_t i = state / 2;
      prepare(i, g[state].least());
      if (spent()) return g;
      const EdgePart& part = level.parts[i];
      for (Link& link : level.links[i]) {
        if (link.sight == Sight::hidden || !leaves(part, state & 1, link.here)) continue;
        const EdgePart& other = level.parts[link.to];
        if (g[state].least() + link.distance + least(level.go, link.to) >= target_) continue;
        ++steps_;
        if (is_idle(g, level.come, link.to, other, g[state].least() + link.distance, link.distance))
          continue;
        const LineLabel by = carried(part, g[state], other, link.distance, slack_);
        for (int side = 0; side < sides_of(other); ++side) {
          if (!(link.there >> side & 1)) continue;
          const State next = 2 * link.to + static_cast<State>(side);
          if (!level.go[next].is_set()) continue;
          if ((by + level.go[next]).least() >= target_) continue;
          const LineLabel now = lowered(g[next], by, level.come[next]);
          if (now == g[next]) continue;
          if (!in_sight(level, i, link)) break;
          g[next] = now;
          before_[next] = state;
          if (link.to == kGoal) continue;
          const double key = (g[next] + level.go[next]).least();
          if (key >= target_) continue;
          waits[next] = 1;
          queue.push({key, next});
        }
      }
    }
    return g;
  }

  // Lower bounds of the way from each state to the goal, of states that `g` reaches.
  std::vector<LineLabel> backward(Level& level, const std::vector<LineLabel>& g) {
    std::vector<std::vector<std::pair<std::uint32_t, Link*>>> into(level.parts.size());
    for (std::uint32_t i = 0; i < level.parts.size(); ++i) {
      for (Link& link : level.links[i]) into[link.to].push_back({i, &link});
    }
    std::vector<LineLabel> h(g.size());
    std::vector<char> waits(g.size(), 0);
    Queue queue;
    h[2 * kGoal] = {0, 0};
    queue.push({0, 2 * kGoal});
    waits[2 * kGoal] = 1;
    while (!queue.empty()) {
      const State state = queue.top().second;
      queue.pop();
      if (!waits[state]) continue;
      waits[state] = 0;
      if (spent()) return h;
      const std::uint32_t j = state / 2;
      const EdgePart& part = level.parts[j];
      for (const auto& [i, link] : into[j]) {
        if (link->sight == Sight::hidden) continue;
        if (!part.is_corner() && !(link->there >> (state & 1) & 1)) continue;
        const EdgePart& other = level.parts[i];
        if (least(g, i) + link->distance + h[state].least() >= target_) continue;
        ++steps_;
        if (is_idle(h, level.go, i, other, h[state].least() + link->distance, link->distance))
          continue;
        const LineLabel by = carried(part, h[state], other, link->distance, slack_);
        for (int side = 0; side < sides_of(other); ++side) {
          const State next = 2 * i + static_cast<State>(side);
          if (!leaves(other, side, link->here) || !g[next].is_set()) continue;
          if ((by + g[next]).least() >= target_) continue;
          const LineLabel now = lowered(h[next], by, level.go[next]);
          if (now == h[next]) continue;
          if (!in_sight(level, i, *link)) break;
          h[next] = now;
          if (i == kStart) continue;
          const double key = (h[next] + g[next]).least();
          if (key >= target_) continue;
          waits[next] = 1;
          queue.push({key, next});
        }
      }
    }
    return h;
  }

  // The parts that the goal's label came over, without the ends; empty where that is not a chain.
  std::vector<EdgePart> chain(const Level& level) const {
    std::vector<EdgePart> out;
    for (State s = before_[2 * kGoal]; s != 2 * kStart; s = before_[s]) {
      if (out.size() > level.parts.size()) return {};
      out.push_back(level.parts[s / 2]);
    }
    std::reverse(out.begin(), out.end());
    return out;
  }

  // Where labels show that a path could run, it is pulled taut: a shorter one takes the target
  // down.
  void shorten(const Level& level, LengthBound& result) {
    geom::Polyline path = over(chain(level), level.parts[kStart].low, level.parts[kGoal].low);
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (!scene_.free(path[i - 1], path[i])) return;
    }
    path = taut(scene_, path);
    const double length = geom::length(path);
    if (!(length < shortest_ - kOff)) return;
    result.path = std::move(path);
    shortest_ = length;
    target_ = target_of(length, options_.gap);
  }

  // What may be left of a label on a part of its part.
  static LineLabel within(const LineLabel& label, const EdgePart& part, const EdgePart& piece,
                          double slack) {
    if (!label.is_set() || part.is_corner()) return label;
    const int k = part.axis;
    const double length = part.high[k] - part.low[k];
    if (!(length > 0)) return label;
    const auto at = [&](double x) {
      const double t = (x - part.low[k]) / length;
      return label.low * (1 - t) + label.high * t - slack;
    };
    return {at(piece.low[k]), at(piece.high[k])};
  }

  // What is left, its parts of more than `most` metres halved.
  Level finer(Level& level, const std::vector<LineLabel>& g, const std::vector<LineLabel>& h,
              double most) {
    const std::size_t count = level.parts.size();
    std::vector<char> kept(2 * count, 0);
    for (State s = 0; s < 2 * count; ++s) {
      kept[s] = g[s].is_set() && h[s].is_set() && (g[s] + h[s]).least() < target_;
    }
    kept[2 * kStart] = kept[2 * kGoal] = 1;
    Level out;
    std::vector<std::uint32_t> first(count + 1);
    for (std::uint32_t i = 0; i < count; ++i) {
      first[i] = static_cast<std::uint32_t>(out.parts.size());
      if (!kept[2 * i] && !kept[2 * i + 1]) continue;
      const EdgePart& part = level.parts[i];
      cut(part, part.length() > most ? 2 : 1, out.parts);
      for (std::size_t piece = first[i]; piece < out.parts.size(); ++piece) {
        for (const State s : {2 * i, 2 * i + 1}) {
          out.come.push_back(kept[s] ? within(g[s], part, out.parts[piece], slack_) : LineLabel{});
          out.go.push_back(kept[s] ? within(h[s], part, out.parts[piece], slack_) : LineLabel{});
        }
      }
    }
    first[count] = static_cast<std::uint32_t>(out.parts.size());
    out.links.resize(out.parts.size());
    out.hints.resize(out.parts.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t a = first[i]; a < first[i + 1]; ++a) out.hints[a] = level.hints[i];
      for (Link& link : level.links[i]) {
        if (spent()) return out;
        if (first[i] == first[i + 1] || first[link.to] == first[link.to + 1]) continue;
        if (link.sight == Sight::hidden || !may_use(level, g, h, kept, i, link)) continue;
        if (!in_sight(level, i, link)) continue;
        const bool halved = first[i] + 1 < first[i + 1] || first[link.to] + 1 < first[link.to + 1];
        for (std::uint32_t a = first[i]; a < first[i + 1]; ++a) {
          for (std::uint32_t b = first[link.to]; b < first[link.to + 1]; ++b) {
            consider(out, {out.parts[a], least(out.come, a)}, b,
                     halved ? Sight::unknown : Sight::open, out.links[a]);
          }
        }
      }
    }
    return out;
  }

  // Whether a path shorter than wanted may have the link.
  bool may_use(const Level& level, const std::vector<LineLabel>& g, const std::vector<LineLabel>& h,
               const std::vector<char>& kept, std::uint32_t i, const Link& link) {
    const EdgePart& part = level.parts[i];
    const EdgePart& other = level.parts[link.to];
    for (int side = 0; side < sides_of(part); ++side) {
      const State s = 2 * i + static_cast<State>(side);
      if (!kept[s] || !leaves(part, side, link.here)) continue;
      const LineLabel by = carried(part, g[s], other, link.distance, slack_);
      ++steps_;
      for (int to = 0; to < sides_of(other); ++to) {
        const State t = 2 * link.to + static_cast<State>(to);
        if ((link.there >> to & 1) && kept[t] && (by + h[t]).least() < target_) return true;
      }
    }
    return false;
  }

  const geom::CollisionScene& scene_;
  const Occluders& occluders_;
  const BoundOptions& options_;
  double shortest_;  // metres: of a path that is known
  double target_;    // falls with it
  const double slack_;
  std::vector<State> before_;  // of each state: the one that its label came from last
  std::size_t steps_ = 0;
};

EdgePart place(const Vec3& p) { return {p, p, kCorner, {}}; }

}  // namespace

struct Bounder::Impl {
  explicit Impl(const geom::CollisionScene& of) : scene(of) {}

  void prepare() {
    std::call_once(once, [&] {
      parts = parts_of(convex_edges(scene), kPart);
      occluders.emplace(scene);
    });
  }

  // The parts that a path of `target` metres can reach, with what the straight line says of them.
  Level first_level(const Vec3& from, const Vec3& to, double target, double slack) const {
    Level level;
    const EdgePart start = place(from);
    const EdgePart goal = place(to);
    const auto add = [&](const EdgePart& part, double come, double go) {
      const LineLabel g = carried(start, {0, 0}, part, come, slack);
      const LineLabel h = carried(goal, {0, 0}, part, go, slack);
      level.parts.push_back(part);
      for (int side = 0; side < 2; ++side) {
        const bool used = side == 0 || !part.is_corner();
        level.come.push_back(used ? g : LineLabel{});
        level.go.push_back(used ? h : LineLabel{});
      }
    };
    const double straight = (to - from).norm();
    add(start, 0, straight);
    add(goal, straight, 0);
    level.come[2 * kStart] = level.go[2 * kGoal] = {0, 0};
    for (const EdgePart& part : parts) {
      const double come = least_distance(start, part);
      const double go = least_distance(part, goal);
      if (come + go < target) add(part, come, go);
    }
    level.links.resize(level.parts.size());
    level.hints.resize(level.parts.size());
    level.linked.assign(level.parts.size(), std::numeric_limits<double>::infinity());
    return level;
  }

  const geom::CollisionScene& scene;
  std::once_flag once;
  std::vector<EdgePart> parts;
  std::optional<Occluders> occluders;
};

Bounder::Bounder(const geom::CollisionScene& scene) : impl_(std::make_unique<Impl>(scene)) {}
Bounder::~Bounder() = default;

LengthBound Bounder::ask(const Vec3& from, const Vec3& to, double length,
                         const BoundOptions& options) {
  geom::require_point("start", from);
  geom::require_point("goal", to);
  geom::require_length("length", length, std::numeric_limits<double>::max());
  if (!(options.gap > 0 && options.gap <= 1)) {
    throw geom::InputError(
        "gap", fmt::format("expected a share above 0 and up to 1, found {}", options.gap));
  }
  const auto& bounds = impl_->scene.free_bounds();
  const double straight = (to - from).norm() * (1 - 0x1p-50);
  const double target = target_of(length, options.gap);
  LengthBound result;
  result.bound = straight;
  result.closed = straight >= target;
  if (result.closed || !bounds || (bounds->max.array() <= bounds->min.array()).any()) return result;
  const Vec3 size = bounds->min.cwiseAbs().cwiseMax(bounds->max.cwiseAbs());
  const double slack = std::ldexp(size.sum() + length, -43);
  impl_->prepare();
  Search search(impl_->scene, *impl_->occluders, options, length, slack);
  result = search.bound(impl_->first_level(from, to, target, slack));
  result.bound = std::max(result.bound, straight);
  return result;
}

}  // namespace plan
