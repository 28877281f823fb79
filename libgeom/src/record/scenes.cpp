#include "geom/record/scenes.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "geom/base/usage_error.h"
#include "geom/record/made_for_another.h"

namespace geom {

const CollisionScene& Scenes::build(const Room& room) {
  if (!scene_ || !(scene_->vehicle() == room.vehicle) || scene_->margin() != room.margin) {
    CollisionOptions collision;
    collision.budget = budget_;
    scene_.emplace(map(), room.vehicle, room.margin, collision);
  }
  return *scene_;
}

const CollisionScene& Scenes::scene() {
  if (!asked_.vehicle) {
    throw UsageError(
        "no vehicle: give --vehicle, such as tello or box:0.5,0.5,0.3 (there is no default)");
  }
  if (asked_.spare > 0) {
    throw UsageError("--spare: expected records, whose margin it takes from: give --margin alone");
  }
  return build({*asked_.vehicle, asked_.margin.value_or(0)});
}

const CollisionScene& Scenes::scene_for(const Provenance& record, std::string_view source,
                                        std::size_t line) {
  map_.require(record, source, line);
  return build(agreed_room(record, asked_, differences_, source, line));
}

void Scenes::require_same_room(const Provenance& record, std::string_view source,
                               std::size_t line) const {
  const Room room = agreed_room(record, asked_, differences_, source, line);
  if (scene_ && scene_->vehicle() == room.vehicle && scene_->margin() == room.margin) return;
  throw InputError(source, line,
                   {.expected = "the vehicle and margin of the records before",
                    .found = "others",
                    .advice = "draw them apart, or name one for all with --vehicle and --margin"});
}

CollisionCounts Scenes::counts() const { return scene_ ? scene_->counts() : CollisionCounts(); }

void require_same(const Provenance& made_for, const CollisionScene& scene,
                  const std::string& source, const char* kind) {
  if (const auto another = made_for_another(made_for, provenance_of(scene))) {
    throw InputError(source,
                     {.says = fmt::format("the {} was {}", kind, *another),
                      .advice = fmt::format("ask for that one, or make the {} anew", kind)});
  }
}

}  // namespace geom
