#pragma once

// The median of the last numbers of a sequence, as LAZ predicts differences by it.

#include <array>
#include <cstdint>

namespace geom {

// Five numbers in order, at first 0. Each new one drives out the largest or the smallest: the
// largest until a number came that was not below the median, then the smallest until one came that
// was not above it (Isenburg 2013, "median of five").
class StreamingMedian {
 public:
  std::int32_t get() const { return sorted_[2]; }

  void add(std::int32_t v) {
    if (drops_largest_) {
      drops_largest_ = v < sorted_[2];
      std::size_t i = 4;
      for (; i > 0 && v < sorted_[i - 1]; --i) sorted_[i] = sorted_[i - 1];
      sorted_[i] = v;
    } else {
      drops_largest_ = v <= sorted_[2];
      std::size_t i = 0;
      for (; i < 4 && sorted_[i + 1] < v; ++i) sorted_[i] = sorted_[i + 1];
      sorted_[i] = v;
    }
  }

 private:
  std::array<std::int32_t, 5> sorted_{};
  bool drops_largest_ = true;
};

}  // namespace geom
