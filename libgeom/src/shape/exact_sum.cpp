#include "exact_sum.h"

#include "geom/base/rounding.h"

namespace geom {

// Passes of TwoSum until none changes anything (Ogita, Rump and Oishi, "Accurate sum and dot
// product", 2005): then each term is at most half an ulp of the next that is not 0, so the last of
// those has the sign of all, and is the nearest double to their sum or its neighbour.
double ExactSum::leading() const {
  auto t = terms_;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 1; i < count_; ++i) {
      const double sum = t[i] + t[i - 1];
      const double error = sum_error(t[i], t[i - 1], sum);
      changed |= sum != t[i];
      t[i] = sum;
      t[i - 1] = error;
    }
  }
  for (std::size_t i = count_; i > 0; --i) {
    if (t[i - 1] != 0) return t[i - 1];
  }
  return 0;
}

int ExactSum::sign() const {
  const double all = leading();
  return all > 0 ? 1 : all < 0 ? -1 : 0;
}

ExactSum ExactSum::minus(double term) const {
  ExactSum out = *this;
  out.terms_[out.count_++] = -term;  // there is room for one more than add() allows
  return out;
}

double ExactSum::down() const {
  double sum = leading();
  while (minus(sum).sign() < 0) sum = next_down(sum);
  for (double next = next_up(sum); minus(next).sign() >= 0; next = next_up(sum)) sum = next;
  return sum;
}

double ExactSum::up() const {
  ExactSum negative;
  for (const double term : *this) negative.add(-term);
  const double sum = -negative.down();
  return sum == 0 ? 0 : sum;  // no -0
}

}  // namespace geom
