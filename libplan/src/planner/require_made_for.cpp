#include "require_made_for.h"

#include <fmt/format.h>

#include "geom/base/error.h"

namespace plan {

void require_made_for(const geom::Provenance& made_for, const geom::CollisionScene& scene,
                      const char* kind) {
  const auto refuse = [&](const char* what) {
    throw geom::InputError(kind, fmt::format("was made for another {}", what));
  };
  if (made_for.frame != scene.map().spec().frame.axes) refuse("frame");
  if (!made_for.vehicle || made_for.vehicle->half != scene.vehicle().half) refuse("vehicle");
  if (made_for.margin != scene.margin()) refuse("margin");
}

}  // namespace plan
