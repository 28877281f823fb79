#pragma once

// Items sorted by a number that is spread about evenly over its range.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace geom {

// Sorts items that have a finite number `x` by `less`, which puts none before one of lower x. Puts
// each into one of as many bins as there are items, and sorts within bins: time in proportion to
// the items where few share a bin or those of a bin are in order, and that of std::sort at worst.
template <class Item, class Less>
void spread_sort(std::vector<Item>& items, const Less& less) {
  constexpr std::size_t kFew = 32;
  const std::size_t n = items.size();
  const auto by_x = [](const Item& a, const Item& b) { return a.x < b.x; };
  if (n < kFew) return std::sort(items.begin(), items.end(), less);
  const auto [low, high] = std::minmax_element(items.begin(), items.end(), by_x);
  const double first = low->x;
  const double scale = static_cast<double>(n - 1) / (high->x - first);
  if (!std::isfinite(scale)) {  // all are equal, or too near to each other
    if (!std::is_sorted(items.begin(), items.end(), less)) {
      std::sort(items.begin(), items.end(), less);
    }
    return;
  }
  // Rounding never lets a larger x come into an earlier bin.
  const auto bin_of = [&](const Item& item) {
    return static_cast<std::size_t>((item.x - first) * scale);
  };
  std::vector<std::size_t> ends(n + 1);  // of the bin before; then, as they fill, of each bin
  for (const Item& item : items) ++ends[bin_of(item) + 1];
  for (std::size_t bin = 1; bin <= n; ++bin) ends[bin] += ends[bin - 1];
  std::vector<Item> binned(n);
  for (const Item& item : items) binned[ends[bin_of(item)]++] = item;
  std::size_t begin = 0;
  for (std::size_t bin = 0; bin < n; ++bin) {
    const auto from = binned.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto to = binned.begin() + static_cast<std::ptrdiff_t>(ends[bin]);
    if (to - from > 1 && !std::is_sorted(from, to, less)) std::sort(from, to, less);
    begin = ends[bin];
  }
  items = std::move(binned);
}

}  // namespace geom
