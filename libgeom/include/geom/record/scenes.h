#pragma once

// The scenes of a map for what records ask, one after the other.
//
// Example:
//   geom::Scenes scenes(map, {.vehicle = vehicle, .margin = 0.2}, geom::Differences::refused,
//                       geom::CollisionOptions().budget);
//   const geom::CollisionScene& same =
//       scenes.scene_for(geom::provenance_of(scene), "paths.jsonl", 1);
//   assert(same.margin() == scene.margin());

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "geom/collision/collision.h"
#include "geom/record/agreed_room.h"
#include "geom/record/named_map.h"

namespace geom {

// The last scene is kept.
class Scenes {
 public:
  // `budget`: of CollisionOptions.
  Scenes(BoxMap map, AskedRoom asked, Differences differences, std::size_t budget)
      : map_(std::move(map)),
        asked_(std::move(asked)),
        differences_(differences),
        budget_(budget) {}

  // Of agreed_room(). Throws InputError(source, line, …) where the record is of another map or
  // frame too (named_map.h).
  const CollisionScene& scene_for(const Provenance& record, std::string_view source,
                                  std::size_t line);

  // By the run alone. Throws UsageError where it names no vehicle.
  const CollisionScene& scene();

  // For what looks at several records in the last scene: InputError(source, line, …) where that is
  // not of this one's room.
  void require_same_room(const Provenance& record, std::string_view source, std::size_t line) const;

  const BoxMap& map() const { return map_.map(); }
  const AskedRoom& asked() const { return asked_; }
  std::size_t budget() const { return budget_; }
  CollisionCounts counts() const;  // of the last scene

 private:
  const CollisionScene& build(const Room& room);

  NamedMap map_;
  AskedRoom asked_;
  Differences differences_;
  std::size_t budget_;
  std::optional<CollisionScene> scene_;
};

// A lattice or roadmap (`kind`) serves one map, frame, vehicle and margin: throws
// InputError(source, …) where these are not the scene's.
void require_same(const Provenance& made_for, const CollisionScene& scene,
                  const std::string& source, const char* kind);

}  // namespace geom
