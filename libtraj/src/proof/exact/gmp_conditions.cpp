#include "gmp_conditions.h"

#include <algorithm>
#include <array>
#include <limits>

namespace traj::exact {
namespace {

Whole choose(std::size_t n, std::size_t k) {
  Whole out;
  mpz_bin_uiui(out.get_mpz_t(), n, k);
  return out;
}

// A positive factor that makes the Bernstein coefficients of a product of that degree whole.
Whole common_factor(std::size_t degree) {
  Whole out = 1;
  for (std::size_t k = 0; k <= degree; ++k) out = lcm(out, choose(degree, k));
  return out;
}

// A common power of 2 of the coefficients; 0 where all of them are 0.
mp_bitcnt_t zeros_of(const Polynomial& p) {
  mp_bitcnt_t zeros = std::numeric_limits<mp_bitcnt_t>::max();
  for (const Whole& c : p) {
    if (c != 0) zeros = std::min(zeros, mpz_scan1(c.get_mpz_t(), 0));
  }
  return zeros == std::numeric_limits<mp_bitcnt_t>::max() ? 0 : zeros;
}

// Each coefficient times its binomial, without their common power of 2: in the unit 2^-1074 that is
// all but some fifty of its bits.
Polynomial weighted(const Polynomial& p, mp_bitcnt_t zeros) {
  Polynomial out;
  for (std::size_t i = 0; i < p.size(); ++i) {
    out.push_back(choose(p.size() - 1, i) * Whole(p[i] >> zeros));
  }
  return out;
}

// common_factor(the degree of the product) times the product.
Polynomial product(const Polynomial& a, const Polynomial& b) {
  const std::size_t degree = a.size() + b.size() - 2;
  const mp_bitcnt_t of_a = zeros_of(a);
  const mp_bitcnt_t of_b = zeros_of(b);
  const Polynomial left = weighted(a, of_a);
  const Polynomial right = weighted(b, of_b);
  Polynomial out(degree + 1);
  for (std::size_t i = 0; i < left.size(); ++i) {
    for (std::size_t j = 0; j < right.size(); ++j) out[i + j] += left[i] * right[j];
  }
  const Whole factor = common_factor(degree);
  for (std::size_t k = 0; k <= degree; ++k) {
    out[k] *= factor / choose(degree, k);
    out[k] <<= of_a + of_b;
  }
  return out;
}

Polynomial squared(const Polynomial& p) { return product(p, p); }

// The sum of the squares.
Polynomial squared_norm(std::span<const Polynomial> axes) {
  Polynomial out = squared(axes[0]);
  for (const Polynomial& axis : axes.subspan(1)) {
    const Polynomial square = squared(axis);
    for (std::size_t k = 0; k < out.size(); ++k) out[k] += square[k];
  }
  return out;
}

// The same sign with fewer digits.
void drop_zeros(Polynomial& p) {
  const mp_bitcnt_t zeros = zeros_of(p);
  for (Whole& c : p) c >>= zeros;
}

Whole power(const Whole& base, int exponent) {
  Whole out = 1;
  for (int i = 0; i < exponent; ++i) out *= base;
  return out;
}

// limit^2 - |derivative|^2 times duration^(2 order), in 2^-1074 to the power of 2 order + 2.
Polynomial norm_condition_whole(const Segment& s, int order, double limit,
                                std::span<const int> axes) {
  const std::size_t n = static_cast<std::size_t>(kDegree - order);
  const Whole most = whole(limit) * power(whole(s.duration), order);
  Polynomial q(2 * n + 1, common_factor(2 * n) * most * most);
  for (const int axis : axes) {
    const Polynomial square = squared(derivative(s, axis, order));
    for (std::size_t k = 0; k < q.size(); ++k) q[k] -= square[k] << (2 * order * kUnit);
  }
  return q;
}

// The vertical part of a + g times duration^2, in 2^-3222.
Polynomial thrust_height(const Segment& s) {
  Polynomial height = derivative(s, 2, 2);
  const Whole gravity = whole(kGravity) * power(whole(s.duration), 2);
  for (Whole& c : height) c = (c << (2 * kUnit)) + gravity;
  return height;
}

}  // namespace

// The Taylor sums of sine up to the power 39 (the last term negative) over cosine up to 40 (the
// last positive), rounded down.
Whole tangent_below(double angle) {
  const mpq_class x(angle);
  mpq_class term = 1;
  mpq_class sine = 0;
  mpq_class cosine = 0;
  for (int k = 0; k <= 40; ++k) {
    if (k) term *= x / k;
    const mpq_class signed_term = k % 4 < 2 ? term : mpq_class(-term);
    (k % 2 ? sine : cosine) += signed_term;
  }
  const mpq_class scaled = sine / cosine * mpq_class(Whole(1) << 64);
  return scaled.get_num() / scaled.get_den();
}

std::pair<Conditions, Conditions> halves(const Conditions& conditions) {
  std::pair<Conditions, Conditions> out;
  for (const Polynomial& q : conditions.all) {
    auto [left, right] = halves(q);
    out.first.all.push_back(std::move(left));
    out.second.all.push_back(std::move(right));
  }
  return out;
}

Verdict not_negative(const Conditions& conditions, std::size_t) {
  bool holds = true;
  for (const Polynomial& q : conditions.all) {
    if (q.front() < 0) return Verdict::fails_at_begin;
    if (q.back() < 0) return Verdict::fails_at_end;
    holds = holds && std::all_of(q.begin(), q.end(), [](const Whole& c) { return c >= 0; });
  }
  return holds ? Verdict::holds : Verdict::unknown;
}

Polynomial derivative(const Segment& s, int axis, int order) {
  Polynomial q;
  for (const Vec3& p : s.point) q.push_back(whole(p[axis]));
  for (int r = 0; r < order; ++r) {
    const unsigned degree = static_cast<unsigned>(q.size()) - 1;
    for (std::size_t i = 0; i + 1 < q.size(); ++i) q[i] = degree * (q[i + 1] - q[i]);
    q.pop_back();
  }
  return q;
}

Conditions norm_condition(const Segment& s, int order, double limit, std::span<const int> axes) {
  Polynomial q = norm_condition_whole(s, order, limit, axes);
  drop_zeros(q);
  return {{q}};
}

Conditions tilt_condition(const Segment& s, const Whole& tangent) {
  Polynomial height = thrust_height(s);
  Polynomial cone = squared(height);
  for (Whole& c : cone) c *= tangent * tangent;
  for (int axis = 0; axis < 2; ++axis) {
    const Polynomial square = squared(derivative(s, axis, 2));
    for (std::size_t k = 0; k < cone.size(); ++k) cone[k] -= square[k] << (4 * kUnit + 128);
  }
  drop_zeros(height);
  drop_zeros(cone);
  return {{height, cone}};
}

Conditions thrust_condition(const Segment& s, double limit) {
  Polynomial q = norm_condition_whole(s, 2, limit, std::array{0, 1});
  const Polynomial square = squared(thrust_height(s));
  for (std::size_t k = 0; k < q.size(); ++k) q[k] -= square[k];
  drop_zeros(q);
  return {{q}};
}

Conditions body_rate_condition(const Segment& s, double limit) {
  // In 2^-3222 and 2^-1074: f times duration^2, j times duration^3.
  std::array<Polynomial, 3> f{derivative(s, 0, 2), derivative(s, 1, 2), thrust_height(s)};
  for (int axis = 0; axis < 2; ++axis) {
    for (Whole& c : f[axis]) c <<= 2 * kUnit;
  }
  const std::array<Polynomial, 3> j{derivative(s, 0, 3), derivative(s, 1, 3), derivative(s, 2, 3)};
  std::array<Polynomial, 3> cross;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    const std::size_t l = (i + 2) % 3;
    cross[i] = product(f[k], j[l]);
    const Polynomial other = product(f[l], j[k]);
    for (std::size_t n = 0; n < other.size(); ++n) cross[i][n] -= other[n];
  }
  // (limit duration)^2 |f|^4 - |f x j|^2: of degree 20, the latter raised by two degrees.
  Polynomial q = squared(squared_norm(f));
  const Polynomial turn = product(squared_norm(cross), Polynomial(3, 1));
  const Whole most = whole(limit) * whole(s.duration);
  const Whole of_turn = most * most * common_factor(9) * common_factor(9) * common_factor(18);
  const Whole of_norm = common_factor(10) * common_factor(10);
  for (std::size_t k = 0; k < q.size(); ++k) {
    q[k] = q[k] * of_turn - ((turn[k] * of_norm) << (8 * kUnit));
  }
  drop_zeros(q);
  return {{q}};
}

Conditions yaw_rate_condition(const Segment& s, double limit) {
  Polynomial rate;
  for (std::size_t i = 0; i < kDegree; ++i) {
    rate.push_back(kDegree * (whole((*s.yaw)[i + 1]) - whole((*s.yaw)[i])));
  }
  const Whole most = whole(limit) * whole(s.duration);
  Polynomial q(2 * kDegree - 1, common_factor(2 * (kDegree - 1)) * most * most);
  const Polynomial square = squared(rate);
  for (std::size_t k = 0; k < q.size(); ++k) q[k] -= square[k] << (2 * kUnit);
  drop_zeros(q);
  return {{q}};
}

}  // namespace traj::exact
