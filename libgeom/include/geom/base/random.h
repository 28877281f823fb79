#pragma once

// Random numbers that are the same on every machine.
//
// Example:
//   geom::SplitMix64 random(7);  // the seed
//   const double height = random.uniform(10, 80);
//   const bool has_tower = random.chance(0.1);
//   const int storeys = random.whole(1, 20);  // 1 to 20

#include <cstdint>

namespace geom {

// SplitMix64 (Steele, Lea and Flood 2014). The same seed gives the same numbers everywhere, unlike
// the distributions of <random>.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

  // 2^53 values evenly over [low, high); rounding may give `high` itself.
  double uniform(double low, double high) {
    state_ += 0x9e3779b97f4a7c15ull;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return low + (high - low) * (static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53);
  }
  bool chance(double p) { return uniform(0, 1) < p; }
  int whole(int low, int high) { return static_cast<int>(uniform(low, high + 1)); }

 private:
  std::uint64_t state_;
};

}  // namespace geom
