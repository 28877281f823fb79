#pragma once

// The scenes of a map for what records ask: one for each vehicle and margin, shared by all threads.
//
// Example:
//   geom::Scenes scenes(map, {.vehicle = vehicle, .margin = 0.2}, geom::Differences::refused,
//                       geom::CollisionOptions().budget);
//   const geom::CollisionScene& same =
//       scenes.scene_for(geom::provenance_of(scene), "paths.jsonl", 1);
//   assert(same.margin() == scene.margin());

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/record/agreed_room.h"
#include "geom/record/named_map.h"

namespace geom {

// Keeps the scenes that were asked for last: at most kMostScenes, and no more than fit the budget.
// Their trees share it, so that a scene gets an n-th of it where n are kept (n: a power of two),
// and kScenesOfLargeMap are kept where the trees of one may take more than that. Those before them
// are made anew when they are asked for again. What a caller still holds stays beside these.
class Scenes {
 public:
  static constexpr std::size_t kMostScenes = 64;
  static constexpr std::size_t kScenesOfLargeMap = 8;

  // `budget`: of CollisionOptions, for all scenes together.
  Scenes(BoxMap map, AskedRoom asked, Differences differences, std::size_t budget)
      : map_(std::move(map)),
        asked_(std::move(asked)),
        differences_(differences),
        budget_(budget) {}

  // Of agreed_room(). Throws InputError(source, line, …) where the record is of another map or
  // frame too (named_map.h). Threads may call at once, also with one that calls what follows.
  std::shared_ptr<const CollisionScene> shared_scene_for(const Provenance& record,
                                                         std::string_view source, std::size_t line);

  // The same for one thread: the scene stays until the next call of this, or of scene().
  const CollisionScene& scene_for(const Provenance& record, std::string_view source,
                                  std::size_t line);

  // By the run alone. Throws UsageError where it names no vehicle.
  const CollisionScene& scene();

  // For what looks at several records in the last scene of scene_for(): InputError(source, line, …)
  // where that is not of this one's room.
  void require_same_room(const Provenance& record, std::string_view source, std::size_t line) const;

  const BoxMap& map() const { return map_.map(); }
  const AskedRoom& asked() const { return asked_; }
  std::size_t budget() const { return budget_; }
  // Of all scenes that were made, in sum; `most_bytes` of the one that took most.
  CollisionCounts counts() const;

 private:
  using Shared = std::shared_ptr<const CollisionScene>;
  struct Kept {
    Shared scene;
    std::size_t most_bytes;  // that its trees may take
  };

  Shared built(const Room& room);
  Kept made(const Room& room, std::size_t share) const;
  std::size_t make_room();
  void drop(std::size_t i);

  NamedMap map_;
  AskedRoom asked_;
  Differences differences_;
  std::size_t budget_;
  Shared last_;

  mutable std::mutex mutex_;  // guards whether a record is of the map, and what follows
  std::vector<Kept> kept_;    // the one that was asked for last at the end
  CollisionCounts dropped_;   // of those that are no longer kept
};

// A lattice or roadmap (`kind`) serves one map, frame, vehicle and margin: throws
// InputError(source, …) where these are not the scene's.
void require_same(const Provenance& made_for, const CollisionScene& scene,
                  const std::string& source, const char* kind);

}  // namespace geom
