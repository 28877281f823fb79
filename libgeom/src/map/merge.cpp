#include "geom/map/merge.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "geom/map/box_index.h"

namespace geom {
namespace {

bool inside(const Aabb& inner, const Aabb& outer) {
  return contains(outer, inner.min) && contains(outer, inner.max);
}

std::size_t drop_contained(BoxTable& table) {
  BoxIndex index(index_cell(table.boxes));
  for (std::size_t i = 0; i < table.boxes.size(); ++i) index.add(i, table.boxes[i]);
  std::vector<char> flag(table.boxes.size(), 1);
  for (std::size_t i = 0; i < table.boxes.size(); ++i) {
    const Aabb& box = table.boxes[i];
    for (const std::size_t k : index.near({box.min, box.min})) {
      if (k == i || !flag[k] || !inside(box, table.boxes[k])) continue;
      if (!table.time(k).contains(table.time(i))) continue;
      // Of equal ones the first stays.
      if (table.boxes[k] == box && table.time(k) == table.time(i) && k > i) continue;
      flag[i] = 0;
      break;
    }
  }
  const auto dropped =
      static_cast<std::size_t>(std::count(flag.begin(), flag.end(), static_cast<char>(0)));
  table.keep_if([&](std::size_t i) { return flag[i] != 0; });
  return dropped;
}

std::size_t join_along(BoxTable& table, int axis) {
  const int b = (axis + 1) % 3;
  const int c = (axis + 2) % 3;
  const auto key = [&](std::size_t i) {
    const Aabb& box = table.boxes[i];
    const TimeSpan time = table.time(i);
    return std::array{static_cast<double>(table.label[i]),
                      box.min[b],
                      box.max[b],
                      box.min[c],
                      box.max[c],
                      time.from,
                      time.until};
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
  table.keep_if([&](std::size_t i) { return flag[i] != 0; });
  return joined;
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

}  // namespace geom
