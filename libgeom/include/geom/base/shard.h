#pragma once

// One of several equal shares of some work, for processes that know nothing of each other.
//
// Example:
//   const geom::Shard second{.index = 1, .count = 3};
//   assert((second.items(8) == std::vector<std::size_t>{1, 4, 7}));  // spread
//   assert(second.begin(9) == 3 && second.end(9) == 6);              // or a run of neighbours

#include <cstddef>
#include <vector>

namespace geom {

// Share `index` of `count`: either every count-th item (takes), which spreads costly items, or a
// run of neighbours (begin, end), which stays in one place. Both give each item to one share.
struct Shard {
  std::size_t index = 0;  // below count
  std::size_t count = 1;

  bool takes(std::size_t item) const { return item % count == index; }
  std::size_t begin(std::size_t items) const { return before(items, index); }
  std::size_t end(std::size_t items) const { return before(items, index + 1); }

  // How many of the items [0, all) this share takes.
  std::size_t taken(std::size_t all) const { return all / count + (index < all % count ? 1 : 0); }

  // The items of [0, all) that this share takes, ascending.
  std::vector<std::size_t> items(std::size_t all) const {
    std::vector<std::size_t> out;
    for (std::size_t i = index; i < all; i += count) out.push_back(i);
    return out;
  }

  friend bool operator==(const Shard&, const Shard&) = default;

 private:
  // Items in the shares before `share`, without overflow.
  std::size_t before(std::size_t items, std::size_t share) const {
    return items / count * share + items % count * share / count;
  }
};

}  // namespace geom
