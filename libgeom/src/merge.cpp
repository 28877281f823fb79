#include "geom/merge.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "geom/box_index.h"

namespace geom {
namespace {

bool inside(const Aabb& inner, const Aabb& outer) {
  return contains(outer, inner.min) && contains(outer, inner.max);
}

// Keeps the boxes whose flag is set, in their order.
void keep(BoxTable& table, const std::vector<char>& flag) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < flag.size(); ++i) {
    if (!flag[i]) continue;
    table.boxes[n] = table.boxes[i];
    table.ids[n] = table.ids[i];
    table.label[n] = table.label[i];
    ++n;
  }
  table.boxes.resize(n);
  table.ids.resize(n);
  table.label.resize(n);
}

std::size_t drop_contained(BoxTable& table) {
  BoxIndex index(index_cell(table.boxes));
  for (std::size_t i = 0; i < table.boxes.size(); ++i) index.add(i, table.boxes[i]);
  std::vector<char> flag(table.boxes.size(), 1);
  for (std::size_t i = 0; i < table.boxes.size(); ++i) {
    const Aabb& box = table.boxes[i];
    for (const std::size_t k : index.near({box.min, box.min})) {
      if (k == i || !flag[k] || !inside(box, table.boxes[k])) continue;
      if (table.boxes[k] == box && k > i) continue;  // of equal ones the first stays
      flag[i] = 0;
      break;
    }
  }
  const auto dropped =
      static_cast<std::size_t>(std::count(flag.begin(), flag.end(), static_cast<char>(0)));
  keep(table, flag);
  return dropped;
}

std::size_t join_along(BoxTable& table, int axis) {
  const int b = (axis + 1) % 3;
  const int c = (axis + 2) % 3;
  const auto key = [&](std::size_t i) {
    const Aabb& box = table.boxes[i];
    return std::array{static_cast<double>(table.label[i]), box.min[b], box.max[b], box.min[c],
                      box.max[c]};
  };
  std::vector<std::size_t> order(table.boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) {
    const auto ki = key(i);
    const auto kk = key(k);
    if (ki != kk) return ki < kk;
    if (table.boxes[i].min[axis] != table.boxes[k].min[axis]) {
      return table.boxes[i].min[axis] < table.boxes[k].min[axis];
    }
    return i < k;
  });
  std::vector<char> flag(table.boxes.size(), 1);
  std::size_t joined = 0;
  for (std::size_t n = 1, open = 0; n < order.size(); ++n) {
    Aabb& box = table.boxes[order[open]];
    const Aabb& next = table.boxes[order[n]];
    if (key(order[open]) != key(order[n]) || next.min[axis] > box.max[axis]) {
      open = n;
      continue;
    }
    box.max[axis] = std::max(box.max[axis], next.max[axis]);
    table.ids[order[open]] = std::min(table.ids[order[open]], table.ids[order[n]]);
    flag[order[n]] = 0;
    ++joined;
  }
  keep(table, flag);
  return joined;
}

// The furthest any point of `hull` can be from the boxes is at most `slack`: distance grows no
// faster than one goes, so a piece near enough at its centre for its corners is settled.
bool within(const Aabb& hull, std::span<const Aabb> boxes, double slack) {
  const Vec3 centre = 0.5 * (hull.min + hull.max);
  const double radius = 0.5 * (hull.max - hull.min).norm() * (1 + 1e-12);
  double nearest = 2 * slack;
  for (const Aabb& box : boxes) {
    if (inside(hull, box)) return true;
    nearest = std::min(nearest, distance(centre, box));
  }
  if (nearest + radius <= slack) return true;
  if (nearest > slack || radius < 0.05 * slack) return false;
  int axis = 0;
  (hull.max - hull.min).maxCoeff(&axis);
  Aabb low = hull;
  Aabb high = hull;
  low.max[axis] = high.min[axis] = centre[axis];
  // Only boxes near the piece matter to it.
  const auto near = [&](const Aabb& piece) {
    std::vector<Aabb> some;
    const Aabb around = grow(piece, Vec3::Constant(slack));
    for (const Aabb& box : boxes) {
      if (overlap(box, around)) some.push_back(box);
    }
    return some;
  };
  return within(low, near(low), slack) && within(high, near(high), slack);
}

}  // namespace

Merged merge(BoxTable table) {
  Merged out;
  for (;;) {
    const std::size_t contained = drop_contained(table);
    std::size_t joined = 0;
    for (int axis = 2; axis >= 0; --axis) joined += join_along(table, axis);
    out.contained += contained;
    out.joined += joined;
    if (joined == 0) break;
  }
  out.table = std::move(table);
  return out;
}

Simplified simplify(BoxTable input, double slack) {
  Simplified out{merge(std::move(input)).table, 0};
  BoxTable& table = out.table;
  const std::vector<Aabb> original = table.boxes;
  const double cell = index_cell(original) + slack;
  BoxIndex originals(cell);
  for (std::size_t i = 0; i < original.size(); ++i) originals.add(i, original[i]);
  BoxIndex index(cell);
  for (std::size_t i = 0; i < table.boxes.size(); ++i) index.add(i, table.boxes[i]);
  std::vector<char> flag(table.boxes.size(), 1);
  const auto fits = [&](const Aabb& hull) {
    ++out.tried;
    std::vector<Aabb> near;
    for (const std::size_t i : originals.near(grow(hull, Vec3::Constant(slack)))) {
      near.push_back(original[i]);
    }
    return within(hull, near, slack);
  };
  for (std::size_t i = 0; i < table.boxes.size(); ++i) {
    while (flag[i]) {
      struct Choice {
        double waste;
        std::size_t other;
        Aabb hull;
      };
      std::vector<Choice> choices;
      const Aabb around = grow(table.boxes[i], Vec3::Constant(2 * slack));
      for (const std::size_t k : index.near(around)) {
        if (k == i || !flag[k] || table.label[k] != table.label[i] ||
            !overlap(table.boxes[k], around)) {
          continue;
        }
        const Aabb hull = merged(table.boxes[i], table.boxes[k]);
        const auto volume = [](const Aabb& box) { return (box.max - box.min).prod(); };
        choices.push_back(
            {volume(hull) - volume(table.boxes[i]) - volume(table.boxes[k]), k, hull});
      }
      std::sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) {
        return a.waste != b.waste ? a.waste < b.waste : a.other < b.other;
      });
      const auto chosen = std::find_if(choices.begin(), choices.end(),
                                       [&](const Choice& choice) { return fits(choice.hull); });
      if (chosen == choices.end()) break;
      table.boxes[i] = chosen->hull;
      table.ids[i] = std::min(table.ids[i], table.ids[chosen->other]);
      flag[chosen->other] = 0;
      index.add(i, chosen->hull);
    }
  }
  keep(table, flag);
  return out;
}

}  // namespace geom
