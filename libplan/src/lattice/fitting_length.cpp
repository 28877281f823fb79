#include "plan/lattice/fitting_length.h"

namespace plan {

double fitting_length(const geom::Aabb& free_bounds, double in_a_city) {
  const double longest = (free_bounds.max - free_bounds.min).maxCoeff();
  return longest > 0 && longest < kCity ? in_a_city * (longest / kCity) : in_a_city;
}

}  // namespace plan
