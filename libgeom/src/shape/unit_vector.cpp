#include "unit_vector.h"

#include <cmath>

namespace geom {
namespace {

constexpr long double kPi = 3.14159265358979323846264338327950288L;
// A quarter turn is the sum of both, to 1e-34 or so.
constexpr long double kQuarter = 1.57079632679489661923132169163975144L;
constexpr long double kQuarterRest = -2.508278806334166e-20L;

// |angle| of at most an eighth of a turn or so.
struct Extended {
  long double cosine;
  long double sine;
};

Extended series(long double angle) {
  const long double square = angle * angle;
  long double sine = 1;
  long double cosine = 1;
  for (int k = 26; k >= 2; k -= 2) {
    cosine = 1 - square / static_cast<long double>((k - 1) * k) * cosine;
    sine = 1 - square / static_cast<long double>(k * (k + 1)) * sine;
  }
  return {cosine, angle * sine};
}

UnitVector after_quarters(long double quarters, long double rest) {
  const Extended v = series(rest);
  const long quarter = std::lrint(static_cast<double>(quarters - 4 * std::floor(quarters / 4)));
  const auto c = static_cast<double>(v.cosine);
  const auto s = static_cast<double>(v.sine);
  switch (quarter & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

}  // namespace

UnitVector unit_vector(double radians) {
  const long double quarters = std::round(radians / kQuarter);
  return after_quarters(quarters, radians - quarters * kQuarter - quarters * kQuarterRest);
}

UnitVector unit_vector_of_degrees(double degrees) {
  const double quarters = std::round(degrees / 90);
  return after_quarters(quarters, (degrees - quarters * 90) * (kPi / 180));
}

std::vector<UnitVector> round_half_turn(std::size_t n) {
  std::vector<UnitVector> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    const long double share = static_cast<long double>(i) / static_cast<long double>(n);
    const long double quarters = std::round(2 * share);
    out[i] = after_quarters(quarters, (share - quarters / 2) * kPi);
  }
  return out;
}

}  // namespace geom
