#pragma once

// Sums of a few doubles, rounded once, down or up.

#include <array>
#include <cassert>
#include <cstddef>

namespace geom {

// Up to 12 terms, all finite and of a sum far from overflow.
class ExactSum {
 public:
  static constexpr std::size_t kMost = 12;  // terms

  // Zeros are not kept. Precondition: there is room for it.
  void add(double term) {
    if (term == 0) return;
    assert(count_ < kMost);
    terms_[count_++] = term;
  }
  std::size_t count() const { return count_; }
  const double* begin() const { return terms_.data(); }
  const double* end() const { return terms_.data() + count_; }

  // The largest double that is not above the sum in real arithmetic, and the smallest not below.
  double down() const;
  double up() const;

  int sign() const;  // of the sum in real arithmetic: -1, 0 or 1

 private:
  double leading() const;  // of the terms made few: 0 only where the sum is
  ExactSum minus(double term) const;

  std::array<double, kMost + 1> terms_{};
  std::size_t count_ = 0;
};

}  // namespace geom
