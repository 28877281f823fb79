#include "geom/record/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "collision/tree_bytes.h"
#include "geom/base/error.h"
#include "geom/base/usage_error.h"
#include "geom/record/made_for_another.h"

namespace geom {

namespace {

bool is_of(const CollisionScene& scene, const Room& room) {
  return scene.vehicle() == room.vehicle && scene.margin() == room.margin;
}

std::size_t bytes_of_whole(const CollisionScene& scene) {
  return most_tree_bytes(scene.map().size(), scene.counts().groups);
}

void add(const CollisionCounts& counts, CollisionCounts& sum) {
  sum.groups += counts.groups;
  sum.built += counts.built;
  sum.built_again += counts.built_again;
  sum.most_bytes = std::max(sum.most_bytes, counts.most_bytes);
}

}  // namespace

void Scenes::drop(std::size_t i) {
  add(kept_[i].scene->counts(), dropped_);
  kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(i));
}

// For one more. Returns its share of the budget, which none of the others may exceed.
std::size_t Scenes::make_room() {
  if (!kept_.empty()) {
    const std::size_t whole = std::max<std::size_t>(bytes_of_whole(*kept_.back().scene), 1);
    const std::size_t most =
        std::bit_floor(std::clamp(budget_ / whole, kScenesOfLargeMap, kMostScenes));
    while (kept_.size() >= most) drop(0);
  }
  const std::size_t share = budget_ / std::bit_ceil(kept_.size() + 1);
  for (std::size_t i = kept_.size(); i-- > 0;) {
    if (kept_[i].most_bytes > share) drop(i);
  }
  return share;
}

Scenes::Kept Scenes::made(const Room& room, std::size_t share) const {
  CollisionOptions collision;
  collision.budget = share;
  Shared scene =
      std::make_shared<const CollisionScene>(map(), room.vehicle, room.margin, collision);
  const std::size_t most = std::min(share, bytes_of_whole(*scene));
  return {std::move(scene), most};
}

Scenes::Shared Scenes::built(const Room& room) {
  const auto known = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const Kept& kept) { return is_of(*kept.scene, room); });
  if (known == kept_.end()) {
    const std::size_t share = make_room();
    kept_.push_back(made(room, share));
  } else {
    std::rotate(known, known + 1, kept_.end());
  }
  return kept_.back().scene;
}

const CollisionScene& Scenes::scene() {
  if (!asked_.vehicle) {
    throw UsageError(
        "no vehicle: give --vehicle, such as tello or box:0.5,0.5,0.3 (there is no default)");
  }
  if (asked_.spare > 0) {
    throw UsageError("--spare: expected records, whose margin it takes from: give --margin alone");
  }
  const std::lock_guard lock(mutex_);
  last_ = built({*asked_.vehicle, asked_.margin.value_or(0)});
  return *last_;
}

std::shared_ptr<const CollisionScene> Scenes::shared_scene_for(const Provenance& record,
                                                               std::string_view source,
                                                               std::size_t line) {
  const std::lock_guard lock(mutex_);
  map_.require(record, source, line);
  return built(agreed_room(record, asked_, differences_, source, line));
}

const CollisionScene& Scenes::scene_for(const Provenance& record, std::string_view source,
                                        std::size_t line) {
  last_ = shared_scene_for(record, source, line);
  return *last_;
}

void Scenes::require_same_room(const Provenance& record, std::string_view source,
                               std::size_t line) const {
  const Room room = agreed_room(record, asked_, differences_, source, line);
  if (last_ && is_of(*last_, room)) return;
  throw InputError(source, line,
                   {.expected = "the vehicle and margin of the records before",
                    .found = "others",
                    .advice = "draw them apart, or name one for all with --vehicle and --margin"});
}

CollisionCounts Scenes::counts() const {
  const std::lock_guard lock(mutex_);
  CollisionCounts sum = dropped_;
  for (const Kept& kept : kept_) add(kept.scene->counts(), sum);
  return sum;
}

void require_same(const Provenance& made_for, const CollisionScene& scene,
                  const std::string& source, const char* kind) {
  if (const auto another = made_for_another(made_for, provenance_of(scene))) {
    throw InputError(source,
                     {.says = fmt::format("the {} was {}", kind, *another),
                      .advice = fmt::format("ask for that one, or make the {} anew", kind)});
  }
}

}  // namespace geom
