#include "radix_sort.h"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "geom/base/parallel.h"

namespace geom {
namespace {

constexpr unsigned kMostBits = 11;  // of a digit: as many places are written at once as fit a cache

// The digits of keys, the lowest first, all of as many bits.
struct Digit {
  unsigned shift;
  unsigned bits;

  std::size_t of(std::uint64_t key) const {
    return key >> shift & ((std::uint64_t{1} << bits) - 1);
  }
};

// Items in stretches, one after the other; a thread works on one at a time.
class Stretches {
 public:
  Stretches(std::size_t items, unsigned threads)
      : items_(items), count_(std::clamp<std::size_t>(items / kLeast, 1, threads)) {}

  std::size_t count() const { return count_; }
  std::size_t begin(std::size_t stretch) const { return items_ * stretch / count_; }

 private:
  static constexpr std::size_t kLeast = std::size_t{1} << 15;
  std::size_t items_;
  std::size_t count_;
};

// From how often each stretch has each digit to where its first of that digit goes.
void to_places(std::vector<std::vector<std::size_t>>& counts) {
  std::size_t next = 0;
  for (std::size_t digit = 0; digit < counts.front().size(); ++digit) {
    for (auto& stretch : counts) next += std::exchange(stretch[digit], next);
  }
}

template <class Number>
void sort_by(const Digit& digit, std::span<const Keyed<Number>> from, std::span<Keyed<Number>> to,
             const Execution& run) {
  const Stretches stretches(from.size(), run.threads);
  std::vector<std::vector<std::size_t>> places(stretches.count());
  const auto of_stretch = [&](std::size_t s) {
    return from.subspan(stretches.begin(s), stretches.begin(s + 1) - stretches.begin(s));
  };
  parallel_for(stretches.count(), {run.threads, {}}, [&](std::size_t s) {
    std::vector<std::size_t> counts(std::size_t{1} << digit.bits);
    for (const Keyed<Number>& item : of_stretch(s)) ++counts[digit.of(item.key)];
    places[s] = std::move(counts);
  });
  to_places(places);
  parallel_for(stretches.count(), {run.threads, {}}, [&](std::size_t s) {
    for (const Keyed<Number>& item : of_stretch(s)) to[places[s][digit.of(item.key)]++] = item;
  });
}

}  // namespace

template <class Number>
LargeArray<Keyed<Number>> radix_sorted(LargeArray<Keyed<Number>> items, std::uint64_t largest,
                                       const Execution& run) {
  const auto width = static_cast<unsigned>(std::bit_width(largest));
  const unsigned digits = (width + kMostBits - 1) / kMostBits;
  if (digits == 0) return items;
  const unsigned bits = (width + digits - 1) / digits;
  LargeArray<Keyed<Number>> room(items.all().size());
  for (unsigned d = 0; d < digits; ++d) {
    sort_by<Number>({d * bits, bits}, items.all(), room.all(), run);
    std::swap(items, room);
  }
  return items;
}

template LargeArray<Keyed<std::uint32_t>> radix_sorted(LargeArray<Keyed<std::uint32_t>>,
                                                       std::uint64_t, const Execution&);
template LargeArray<Keyed<std::uint64_t>> radix_sorted(LargeArray<Keyed<std::uint64_t>>,
                                                       std::uint64_t, const Execution&);

}  // namespace geom
