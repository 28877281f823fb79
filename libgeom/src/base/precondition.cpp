#include "geom/base/precondition.h"

#include <fmt/format.h>

#include "geom/base/error.h"

namespace geom {

void refuse_point(std::string_view what, const Vec3& p) {
  throw InputError(what, {.expected = fmt::format("coordinates within {:g} m", kFarthest),
                          .found = fmt::format("[{}, {}, {}]", p[0], p[1], p[2])});
}

void refuse_length(std::string_view what, double value, double most) {
  throw InputError(what, {.expected = fmt::format("metres from 0 to {:g}", most),
                          .found = fmt::to_string(value)});
}

}  // namespace geom
