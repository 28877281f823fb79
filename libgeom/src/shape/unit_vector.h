#pragma once

// Sines and cosines by additions, multiplications and divisions alone, so that every x86-64 finds
// the same ones.

#include <cstddef>
#include <vector>

namespace geom {

struct UnitVector {
  double cosine = 1;
  double sine = 0;
};

// Of an angle in radians, |angle| <= 1000, or in degrees, |degrees| <= 1e5: each to 2e-16; of
// degrees exact at all quarters of a turn. Taylor's series in extended precision after taking away
// quarter turns.
UnitVector unit_vector(double radians);
UnitVector unit_vector_of_degrees(double degrees);

// Of the angles i * pi / n, i < n.
std::vector<UnitVector> round_half_turn(std::size_t n);

}  // namespace geom
