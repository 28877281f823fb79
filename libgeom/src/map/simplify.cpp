#include "geom/map/simplify.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "geom/base/parallel.h"
#include "geom/map/box_index.h"
#include "geom/map/merge.h"

namespace geom {
namespace {

constexpr std::size_t kMostWork = 200000;  // boxes looked at before a hull counts as too large

double volume(const Aabb& box) { return (box.max - box.min).prod(); }

double common_volume(const Aabb& a, const Aabb& b) {
  return (a.max.cwiseMin(b.max) - a.min.cwiseMax(b.min)).cwiseMax(0).prod();
}

// What lies within `slack` of a set of boxes.
class Surroundings {
 public:
  // `slack` is taken a little smaller, which covers the rounding of what is compared with it: sums
  // of squares of rounded differences, each within a few units in the last place.
  Surroundings(const BoxTable& table, double slack)
      : boxes_(table.boxes),
        times_(table.times),
        slack_(slack),
        most_(slack * slack * (1 - 1e-14)),
        index_(index_cell(boxes_) + slack) {
    times_.resize(times_.empty() ? 0 : boxes_.size());
    for (std::size_t i = 0; i < boxes_.size(); ++i) index_.add(i, boxes_[i]);
  }

  // Whether those that are there all that time hold all of `hull`: never wrongly yes; no where it
  // would take too long to tell.
  bool hold(const Aabb& hull, const TimeSpan& time) const {
    const Aabb around = grow(hull, Vec3::Constant(slack_));
    std::vector<Aabb> near;
    for (const std::size_t i : index_.near(around)) {
      if (!times_.empty() && !times_[i].contains(time)) continue;
      if (overlap(boxes_[i], around)) near.push_back(boxes_[i]);
    }
    std::size_t work = 0;
    return hold(hull, near, work);
  }

 private:
  // A piece is held when all of it is near one box. Of one that is not, two corners tell whether
  // cutting it can help.
  bool hold(const Aabb& piece, const std::vector<Aabb>& boxes, std::size_t& work) const {
    if ((work += boxes.size() + 1) > kMostWork) return false;
    double low = most_ + 1;
    double high = low;
    for (const Aabb& box : boxes) {
      const Vec3 below = (box.min - piece.min).cwiseMax(0);
      const Vec3 above = (piece.max - box.max).cwiseMax(0);
      if (below.cwiseMax(above).squaredNorm() <= most_) return true;
      low = std::min(low, below.cwiseMax(piece.min - box.max).squaredNorm());
      high = std::min(high, above.cwiseMax(box.min - piece.max).squaredNorm());
    }
    if (low > most_ || high > most_) return false;
    int axis = 0;
    const double side = (piece.max - piece.min).maxCoeff(&axis);
    if (side < 0.02 * slack_ || side == 0) return false;
    const double cut = cut_of(piece, axis, boxes);
    if (cut <= piece.min[axis] || cut >= piece.max[axis]) return false;
    for (const bool upper : {false, true}) {
      Aabb part = piece;
      (upper ? part.min[axis] : part.max[axis]) = cut;
      const Aabb around = grow(part, Vec3::Constant(slack_));
      std::vector<Aabb> near;
      for (const Aabb& box : boxes) {
        if (overlap(box, around)) near.push_back(box);
      }
      if (!hold(part, near, work)) return false;
    }
    return true;
  }

  // Where to cut: as far up as one box holds the lower part, or in the middle.
  double cut_of(const Aabb& piece, int axis, const std::vector<Aabb>& boxes) const {
    const double side = piece.max[axis] - piece.min[axis];
    double cut = piece.min[axis];
    for (const Aabb& box : boxes) {
      Vec3 beyond = (box.min - piece.min).cwiseMax(piece.max - box.max).cwiseMax(0);
      beyond[axis] = 0;
      const double left = most_ - beyond.squaredNorm();
      const double below = box.min[axis] - piece.min[axis];
      if (left < 0 || (below > 0 && below * below > left)) continue;
      cut = std::max(cut, box.max[axis] + std::sqrt(left) * (1 - 1e-9));
    }
    const bool useful = cut > piece.min[axis] + 0.1 * side && cut < piece.max[axis];
    return useful ? cut : piece.min[axis] + 0.5 * side;
  }

  std::vector<Aabb> boxes_;
  std::vector<TimeSpan> times_;  // empty where all are always there
  double slack_;
  double most_;
  BoxIndex index_;
};

struct Choice {
  double waste;
  std::size_t other;
};

// A round's view of the boxes: which were not there, or not chosen, in the round before.
struct Round {
  const BoxTable& table;
  const std::vector<char>& fresh;
  const BoxIndex& index;
  const Surroundings& room;
  double slack;

  // The neighbour of box i that adds least volume, of those that fit.
  std::optional<Choice> best(std::size_t i, std::size_t& tried) const {
    const Aabb& box = table.boxes[i];
    const Aabb around = grow(box, Vec3::Constant(2 * slack));
    std::vector<Choice> choices;
    for (const std::size_t k : index.near(around)) {
      const Aabb& other = table.boxes[k];
      if (k == i || !(fresh[i] || fresh[k]) || table.label[k] != table.label[i] ||
          table.time(k) != table.time(i) || !overlap(other, around)) {
        continue;
      }
      choices.push_back(
          {volume(merged(box, other)) - volume(box) - volume(other) + common_volume(box, other),
           k});
    }
    std::sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) {
      return a.waste != b.waste ? a.waste < b.waste : a.other < b.other;
    });
    for (const Choice& choice : choices) {
      ++tried;
      if (room.hold(merged(box, table.boxes[choice.other]), table.time(i))) return choice;
    }
    return std::nullopt;
  }
};

// Joins the best pairs, each box once; marks what is new or was left over. How many were joined.
std::size_t join_pairs(BoxTable& table, std::vector<char>& fresh,
                       const std::vector<std::optional<Choice>>& best) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < best.size(); ++i) {
    fresh[i] = best[i].has_value();
    if (best[i]) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return best[a]->waste < best[b]->waste; });
  enum State : char { free, grown, gone };
  std::vector<State> state(best.size(), free);
  for (const std::size_t i : order) {
    const std::size_t k = best[i]->other;
    if (state[i] != free || state[k] != free) continue;
    table.boxes[i] = merged(table.boxes[i], table.boxes[k]);
    table.ids[i] = std::min(table.ids[i], table.ids[k]);
    state[i] = grown;
    state[k] = gone;
  }
  std::size_t n = 0;
  for (std::size_t i = 0; i < best.size(); ++i) {
    if (state[i] != gone) fresh[n++] = fresh[i];
  }
  fresh.resize(n);
  table.keep_if([&](std::size_t i) { return state[i] != gone; });
  return best.size() - n;
}

}  // namespace

Simplified simplify(BoxTable input, double slack, const Execution& run) {
  Simplified out{merge(std::move(input)).table, 0, 0};
  BoxTable& table = out.table;
  const Surroundings room(table, slack);
  std::vector<char> fresh(table.boxes.size(), 1);
  std::size_t joined = 1;
  while (joined > 0) {
    BoxIndex index(index_cell(table.boxes) + slack);
    for (std::size_t i = 0; i < table.boxes.size(); ++i) index.add(i, table.boxes[i]);
    const Round round{table, fresh, index, room, slack};
    std::vector<std::optional<Choice>> best(table.boxes.size());
    std::vector<std::size_t> tried(table.boxes.size());
    parallel_for(best.size(), run, [&](std::size_t i) { best[i] = round.best(i, tried[i]); });
    out.tried += std::accumulate(tried.begin(), tried.end(), std::size_t{0});
    joined = join_pairs(table, fresh, best);
    ++out.rounds;
  }
  table = merge(std::move(table)).table;
  return out;
}

}  // namespace geom
