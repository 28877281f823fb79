#pragma once

// What a search of a roadmap has found and not yet looked at, in a total order: what is far from
// its turn is only put aside.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lattice/heap.h"

namespace plan {

// Ties of the bound go to the larger cost, then by kind, then to the lowest index, or as a Frontier
// has it.
struct Open {
  double bound;  // no path through it is shorter
  double cost;   // from the start
  std::uint32_t index;
  enum Kind : std::uint8_t { reached, unlinked, node } kind;

  template <class Ties>
  bool before(const Open& other, const Ties& ties) const {
    if (bound != other.bound) return bound < other.bound;
    if (cost != other.cost) return cost > other.cost;
    return kind != other.kind ? kind < other.kind : ties(*this, other);
  }
  bool before(const Open& other) const;  // by index
};

struct LowestIndex {
  bool operator()(const Open& a, const Open& b) const { return a.index < b.index; }
};

inline bool Open::before(const Open& other) const { return before(other, LowestIndex{}); }

// A queue of buckets (Dial 1969), the foremost of which is a heap. Most of what a search with a
// good heuristic pushes is never taken, and costs an append. `Ties` says which of two that tie
// comes first.
template <class Ties = LowestIndex>
class Frontier {
 public:
  explicit Frontier(Ties ties = {}) : before_{ties} {}

  // Empties it. Most bounds will be at least `least`; buckets are `width` > 0 wide at first.
  void start(double least, double width) {
    heap_.clear();
    for (auto& bucket : buckets_) bucket.clear();
    later_.clear();
    least_ = least;
    per_bound_ = 1 / width;
    at_ = 0;
  }

  void push(const Open& open) {
    const double place = (open.bound - least_) * per_bound_;
    if (place < static_cast<double>(at_ + 1)) {
      heap_push(heap_, open, before_);
    } else if (place < kBuckets) {
      buckets_[static_cast<std::size_t>(place)].push_back(open);
    } else {
      later_.push_back(open);
    }
  }

  // To be asked before first() and pop().
  bool empty() {
    while (heap_.empty()) {
      if (!advance()) return true;
    }
    return false;
  }

  const Open& first() const { return heap_.front(); }
  Open pop() { return heap_pop(heap_, before_); }

 private:
  static constexpr std::size_t kBuckets = 256;

  struct Before {
    Ties ties;
    bool operator()(const Open& a, const Open& b) const { return a.before(b, ties); }
  };

  // The next bucket that has something becomes the heap.
  bool advance() {
    while (++at_ < kBuckets) {
      if (buckets_[at_].empty()) continue;
      for (const Open& open : buckets_[at_]) heap_push(heap_, open, before_);
      buckets_[at_].clear();
      return true;
    }
    return spread_later();
  }

  // Wider buckets, for what was beyond the last.
  bool spread_later() {
    at_ = 0;
    if (later_.empty()) return false;
    constexpr double kWider = 4;
    const auto least = std::min_element(later_.begin(), later_.end(), before_);
    least_ = least->bound;
    per_bound_ /= kWider;
    std::vector<Open> all;
    all.swap(later_);
    for (const Open& open : all) push(open);
    return true;
  }

  Before before_;
  std::vector<Open> heap_;  // bounds before the end of bucket at_
  std::array<std::vector<Open>, kBuckets> buckets_;
  std::vector<Open> later_;
  double least_ = 0;
  double per_bound_ = 1;
  std::size_t at_ = 0;
};

}  // namespace plan
