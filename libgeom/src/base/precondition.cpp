#include "geom/base/precondition.h"

#include <fmt/format.h>

#include "geom/base/error.h"

namespace geom {

void refuse_point(std::string_view what, const Vec3& p) {
  throw InputError(what, fmt::format("expected coordinates within {:g} m, found [{}, {}, {}]",
                                     kFarthest, p[0], p[1], p[2]));
}

void refuse_length(std::string_view what, double value, double most) {
  throw InputError(what, fmt::format("expected metres from 0 to {:g}, found {}", most, value));
}

}  // namespace geom
