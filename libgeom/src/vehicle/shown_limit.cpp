#include "geom/vehicle/shown_limit.h"

#include <fmt/format.h>

namespace geom {

std::string shown(const LimitKind& kind, double value) {
  return fmt::format("{:.10g} {}", value * (1 / kind.in_unit), kind.unit);
}

}  // namespace geom
