#include "search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "chain_path.h"
#include "link_path.h"
#include "path/taut.h"

namespace plan {
namespace {

constexpr int kLevels = 16;    // at most, each of parts half as long
constexpr double kAgain = 10;  // metres that a label may become less before its links are made anew
// From this level on the search ends where the target is further away than so many times what the
// last two levels gained.
constexpr int kTried = 9;
constexpr double kHope = 4;
constexpr double kWorth = 1e-3;  // metres that a path must be shorter to be taken
// Slacks that the target is above the bound wanted. Whoever follows the proof may round otherwise.
constexpr double kSpare = 4;
constexpr std::size_t kShare = 20;  // of all steps: what one look for a shorter path may take
constexpr std::size_t kKeep = 4;    // steps that a link counts: they take memory
constexpr std::size_t kLook = 4;    // steps that looking for an occluder counts

// A label with a line put into it: what is left is below both, or is `floor`, which holds anyway.
LineLabel lowered(const LineLabel& label, const LineLabel& by, const LineLabel& floor) {
  const LineLabel now{std::min(label.low, by.low), std::min(label.high, by.high)};
  return floor.covers(now) ? floor : now;
}

Sight sight_of(View view) {
  if (view == View::hidden) return Sight::hidden;
  return view == View::clear ? Sight::clear : Sight::open;
}

// Of a link between pieces.
Sight inherited(Sight sight, bool halved) {
  if (!halved) return sight;
  return sight == Sight::clear ? Sight::open : Sight::unknown;
}

// What may be left of a label on a piece of its part.
LineLabel within(const LineLabel& label, const EdgePart& part, const EdgePart& piece,
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

}  // namespace

double bound_for(double length, double gap) {
  double target = length / (1 + gap);
  while (length / target - 1 > gap) {
    target = std::nextafter(target, std::numeric_limits<double>::infinity());
  }
  return target;
}

BoundSearch::BoundSearch(const geom::CollisionScene& scene, const Occluders& occluders,
                         const BoundOptions& options, double length, double slack)
    : scene_(scene),
      occluders_(occluders),
      options_(options),
      shortest_(length),
      wanted_(bound_for(length, options.gap)),
      target_(wanted_ + kSpare * slack),
      slack_(slack) {
  if (options.keep_proof) log_.emplace();
}

bool BoundSearch::closes(const LineLabel& label, LengthBound& result) const {
  const double found = label.is_set() ? label.low : wanted_;
  result.bound = std::max(result.bound, std::min(found, wanted_));
  result.closed = result.bound >= wanted_;
  return result.closed;
}

LengthBound BoundSearch::bound(const PartTree& parts, const Vec3& from, const Vec3& to) {
  LengthBound result = levels(first_level(parts, from, to, target_, slack_));
  result.steps = steps_;
  if (log_) result.proof = std::move(*log_).take(occluders_);
  return result;
}

LengthBound BoundSearch::levels(Level level) {
  LengthBound result;
  std::vector<double> reached;
  for (int n = 0; n < kLevels; ++n) {
    if (log_) log_->begin(level);
    const auto g = forward(level);
    if (spent()) break;
    if (log_) log_->come(g);
    ++result.levels;
    if (closes(g[2 * kGoal], result)) break;
    shorten_by_chain(level, result);
    if (closes(g[2 * kGoal], result)) break;
    const auto h = backward(level, g);
    if (spent()) break;
    if (log_) log_->go(h);
    if (closes(h[2 * kStart], result)) break;
    shorten_by_links(level, h, result);
    if (closes(h[2 * kStart], result)) break;
    reached.push_back(result.bound);
    if (n >= kTried &&
        wanted_ - result.bound > kHope * (result.bound - reached[reached.size() - 3])) {
      break;
    }
    level = finer(level, g, h, std::ldexp(kPart, -n - 1));
    if (spent()) break;
  }
  return result;
}

BoundSearch::Pass BoundSearch::pass(bool forward, const Level& level,
                                    const std::vector<LineLabel>& ahead) {
  const State begin = 2 * (forward ? kStart : kGoal);
  Pass out{.forward = forward,
           .floors = forward ? level.come : level.go,
           .ahead = ahead,
           .labels = {},
           .waits = {},
           .queue = {}};
  out.labels.resize(2 * level.parts.size());
  out.waits.assign(out.labels.size(), 0);
  out.labels[begin] = {0, 0};
  out.waits[begin] = 1;
  out.queue.push({0, begin});
  return out;
}

std::optional<State> BoundSearch::next(Pass& pass) {
  while (!pass.queue.empty()) {
    const State state = pass.queue.top().second;
    pass.queue.pop();
    if (!pass.waits[state]) continue;
    pass.waits[state] = 0;
    return state;
  }
  return std::nullopt;
}

std::vector<LineLabel> BoundSearch::forward(Level& level) {
  Pass all = pass(true, level, level.go);
  before_.assign(all.labels.size(), 2 * kStart);
  while (const auto state = next(all)) {
    const std::uint32_t i = *state / 2;
    if (!level.linked.empty()) link(level, i, all.labels[*state].least());
    if (spent()) break;
    for (Link& link : level.links[i]) carry(level, all, *state, i, link);
  }
  return std::move(all.labels);
}

std::vector<LineLabel> BoundSearch::backward(Level& level, const std::vector<LineLabel>& come) {
  std::vector<std::vector<std::pair<std::uint32_t, Link*>>> into(level.parts.size());
  for (std::uint32_t i = 0; i < level.parts.size(); ++i) {
    for (Link& link : level.links[i]) into[link.to].push_back({i, &link});
  }
  Pass all = pass(false, level, come);
  while (const auto state = next(all)) {
    if (spent()) break;
    for (const auto& [i, link] : into[*state / 2]) carry(level, all, *state, i, *link);
  }
  return std::move(all.labels);
}

void BoundSearch::carry(Level& level, Pass& pass, State state, std::uint32_t owner, Link& link) {
  if (link.sight == Sight::hidden) return;
  const bool forward = pass.forward;
  const std::uint32_t to = forward ? link.to : owner;
  const EdgePart& part = level.parts[state / 2];
  const std::uint8_t from_sides = forward ? link.here : link.there;
  const std::uint8_t to_sides = forward ? link.there : link.here;
  const bool departs =
      part.is_corner() || (from_sides >> (forward ? 1 - (state & 1) : state & 1) & 1);
  if (!departs) return;
  const LineLabel label = pass.labels[state];
  const LineLabel roughly = forward ? link.tangent.forward(label) : link.tangent.backward(label);
  const EdgePart& other = level.parts[to];
  ++steps_;
  std::optional<LineLabel> by;
  for (State side = 0; side < sides_of(other); ++side) {
    const State next = 2 * to + side;
    const bool arrives = other.is_corner() || (to_sides >> (forward ? side : 1 - side) & 1);
    if (!arrives || !lowers(pass, next, roughly)) continue;
    if (!by) by = carried(part, label, other, least_distance(part, other), slack_);
    if (!lowers(pass, next, *by)) continue;
    if (!in_sight(level, owner, link)) return;
    pass.labels[next] = lowered(pass.labels[next], *by, pass.floors[next]);
    if (forward) before_[next] = state;
    if (to == (forward ? kGoal : kStart)) continue;
    if ((pass.labels[next] + pass.ahead[next]).least() >= target_) continue;
    pass.waits[next] = 1;
    pass.queue.push({pass.labels[next].least(), next});
  }
}

// Whether a line put into the label of a state makes a difference.
bool BoundSearch::lowers(const Pass& pass, State next, const LineLabel& by) const {
  const LineLabel& label = pass.labels[next];
  if (by.covers(label) || label == pass.floors[next]) return false;
  const LineLabel& ahead = pass.ahead[next];
  return ahead.is_set() && (by + ahead).least() < target_;
}

bool BoundSearch::in_sight(Level& level, std::uint32_t owner, Link& link) {
  if (link.sight == Sight::unknown) {
    steps_ += kLook;
    Hints& hints = level.hints[owner];
    const View view = occluders_.between(level.parts[owner], level.parts[link.to], hints);
    link.sight = sight_of(view);
    if (view == View::hidden && log_) log_->hide(owner, link.to, hints.front());
  }
  return link.sight != Sight::hidden;
}

bool BoundSearch::is_hinted(Level& level, std::uint32_t i, std::uint32_t j) {
  Hints& hints = level.hints[i];
  if (!occluders_.hinted(level.parts[i], level.parts[j], hints)) return false;
  if (log_) log_->hide(i, j, hints.front());
  return true;
}

// All links of a part that a path shorter than wanted may have which comes to it in `come` metres
// at least: made anew where that is less than before.
void BoundSearch::link(Level& level, std::uint32_t i, double come) {
  if (come >= level.linked[i]) return;
  come = std::max(least(level.come, i), come - kAgain);
  level.linked[i] = come;
  level.links[i].clear();
  borrow_hints(level, i);
  std::uint32_t begin = 0;
  for (const PartGroup& group : level.groups) {
    link_group(level, i, come, begin, group);
    begin = group.end;
  }
}

void BoundSearch::link_group(Level& level, std::uint32_t i, double come, std::uint32_t begin,
                             const PartGroup& group) {
  const EdgePart& part = level.parts[i];
  const EdgePart around{group.box.min, group.box.max, kCorner, {}};
  ++steps_;
  if (come + least_distance(part, around) + group.go >= target_) return;
  if (sides(part, around) == 0) return;
  const bool hidden = occluders_.hinted(part, group.box, level.hints[i]);
  if (hidden && !log_) return;
  for (std::uint32_t j = begin; j < group.end; ++j) {
    const double d = least_distance(part, level.parts[j]);
    if (j == i || come + d + least(level.go, j) >= target_) continue;
    auto between = unseen_link(level.parts, i, j);
    if (!between) continue;
    if (hidden) log_->hide(i, j, level.hints[i].front());
    if (hidden || is_hinted(level, i, j)) continue;
    between->tangent = tangent(part, level.parts[j], slack_);
    steps_ += kKeep;
    level.links[i].push_back(*between);
  }
}

// What hid others from the next part of an edge, or from where a label came from.
void BoundSearch::borrow_hints(Level& level, std::uint32_t i) const {
  if (level.hints[i] != kNoHints) return;
  for (const std::uint32_t near : {i - 1, i + 1, before_[2 * i] / 2}) {
    if (near >= level.hints.size() || level.hints[near] == kNoHints) continue;
    level.hints[i] = level.hints[near];
    return;
  }
}

// With the sides that the parts allow; none where there are none.
std::optional<Link> BoundSearch::unseen_link(const std::vector<EdgePart>& parts, std::uint32_t i,
                                             std::uint32_t j) {
  const int here = sides(parts[i], parts[j]);
  if (here == 0) return std::nullopt;
  const int there = sides(parts[j], parts[i]);
  if (there == 0) return std::nullopt;
  return Link{
      j, static_cast<std::uint8_t>(here), static_cast<std::uint8_t>(there), Sight::unknown, {}};
}

// The parts that the goal's label came over, without the ends; empty where that is not a chain.
std::vector<EdgePart> BoundSearch::chain(const Level& level) const {
  std::vector<EdgePart> out;
  for (State s = before_[2 * kGoal]; s != 2 * kStart; s = before_[s]) {
    if (out.size() > level.parts.size()) return {};
    out.push_back(level.parts[s / 2]);
  }
  std::reverse(out.begin(), out.end());
  return out;
}

void BoundSearch::shorten_by_chain(const Level& level, LengthBound& result) {
  geom::Polyline path = chain_path(chain(level), level.parts[kStart].low, level.parts[kGoal].low);
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!scene_.free(path[i - 1], path[i])) return;
  }
  take(std::move(path), result);
}

void BoundSearch::shorten_by_links(const Level& level, const std::vector<LineLabel>& go,
                                   LengthBound& result) {
  geom::Polyline path = link_path(scene_, level, go, shortest_, options_.most / kShare, steps_);
  if (!path.empty()) take(std::move(path), result);
}

// A free path is pulled taut: a shorter one takes the target down.
void BoundSearch::take(geom::Polyline path, LengthBound& result) {
  path = taut(scene_, path);
  const double length = geom::length(path);
  if (!(length < shortest_ - kWorth)) return;
  result.path = std::move(path);
  shortest_ = length;
  wanted_ = bound_for(length, options_.gap);
  target_ = wanted_ + kSpare * slack_;
}

// Takes away the labels of states that no path shorter than wanted uses.
void BoundSearch::drop_long(std::vector<LineLabel>& g, std::vector<LineLabel>& h) const {
  for (State s = 0; s < g.size(); ++s) {
    if (s == 2 * kStart || s == 2 * kGoal) continue;
    if (!g[s].is_set() || !h[s].is_set() || (g[s] + h[s]).least() >= target_) g[s] = h[s] = {};
  }
}

Level BoundSearch::finer(Level& level, std::vector<LineLabel> g, std::vector<LineLabel> h,
                         double most) {
  drop_long(g, h);
  const auto count = static_cast<std::uint32_t>(level.parts.size());
  Level out;
  std::vector<std::uint32_t> first(count + 1);  // of each part: the first of its pieces
  for (std::uint32_t i = 0; i < count; ++i) {
    first[i] = static_cast<std::uint32_t>(out.parts.size());
    if (!g[2 * i].is_set() && !g[2 * i + 1].is_set()) continue;
    const EdgePart& part = level.parts[i];
    cut(part, part.length() > most ? 2 : 1, out.parts);
    for (std::size_t piece = first[i]; piece < out.parts.size(); ++piece) {
      for (const State s : {2 * i, 2 * i + 1}) {
        out.come.push_back(within(g[s], part, out.parts[piece], slack_));
        out.go.push_back(within(h[s], part, out.parts[piece], slack_));
      }
      out.parents.push_back(i);
      out.hints.push_back(level.hints[i]);
    }
  }
  first[count] = static_cast<std::uint32_t>(out.parts.size());
  out.links.resize(out.parts.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const Link& link : level.links[i]) {
      if (spent()) return out;
      const auto pieces = [&](std::uint32_t of) { return first[of + 1] - first[of]; };
      if (pieces(i) == 0 || pieces(link.to) == 0 || link.sight == Sight::hidden) continue;
      ++steps_;
      if (!may_use(level.parts, g, h, i, link)) continue;
      const Sight sight = inherited(link.sight, pieces(i) > 1 || pieces(link.to) > 1);
      for (std::uint32_t a = first[i]; a < first[i + 1]; ++a) {
        for (std::uint32_t b = first[link.to]; b < first[link.to + 1]; ++b) {
          ++steps_;
          auto between = unseen_link(out.parts, a, b);
          if (!between) continue;
          between->sight = sight;
          between->tangent = tangent(out.parts[a], out.parts[b], slack_);
          if (!may_use(out.parts, out.come, out.go, a, *between)) continue;
          steps_ += kKeep;
          out.links[a].push_back(*between);
        }
      }
    }
  }
  return out;
}

// Whether a path shorter than wanted may have the link, by what is known of the way to one end and
// from the other.
bool BoundSearch::may_use(const std::vector<EdgePart>& parts, const std::vector<LineLabel>& come,
                          const std::vector<LineLabel>& go, std::uint32_t i,
                          const Link& link) const {
  const EdgePart& part = parts[i];
  const EdgePart& other = parts[link.to];
  for (State side = 0; side < sides_of(part); ++side) {
    const LineLabel& label = come[2 * i + side];
    if (!label.is_set() || !leaves(part, side, link.here)) continue;
    const LineLabel by = link.tangent.forward(label);
    for (State to = 0; to < sides_of(other); ++to) {
      const LineLabel& left = go[2 * link.to + to];
      if ((link.there >> to & 1) && left.is_set() && (by + left).least() < target_) return true;
    }
  }
  return false;
}

}  // namespace plan
