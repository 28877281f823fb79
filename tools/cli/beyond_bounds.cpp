#include "cli/beyond_bounds.h"

#include <fmt/format.h>

#include "cli/tell.h"

namespace cli {

void BeyondBounds::add(const geom::Provenance& made_for, const geom::Vec3& place, double out) {
  const geom::Vec3 half =
      made_for.vehicle ? made_for.vehicle->half : geom::Vec3(geom::Vec3::Zero());
  wider_.add(place, half + geom::Vec3::Constant(made_for.margin.value_or(0)), out);
}

void BeyondBounds::tell(const Common& common, std::string_view tool) const {
  if (!wider_.any()) return;
  cli::tell(common, tool,
            fmt::format("the bounds are left, at most {}: {}", wider_.in_words(), wider_.advice()));
}

}  // namespace cli
