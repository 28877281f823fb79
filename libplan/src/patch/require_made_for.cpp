#include "require_made_for.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "geom/record/made_for_another.h"

namespace plan {

void require_made_for(const geom::Provenance& made_for, const geom::CollisionScene& scene,
                      const char* kind) {
  geom::Provenance ours = geom::provenance_of(scene);
  ours.map = made_for.map;  // of an older map, as patches are
  if (const auto another = geom::made_for_another(made_for, ours)) {
    throw geom::InputError(
        kind, {.says = fmt::format("it was {}", *another), .advice = "make it again for this one"});
  }
}

}  // namespace plan
