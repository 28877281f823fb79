#include "column_filler.h"

#include <cmath>
#include <utility>

#include "geom/base/parallel.h"

namespace geom {
namespace {

// Points: so many that what a processor fetches of the columns is used for several of them. An
// eighth of it takes half as long again.
constexpr std::size_t kBatch = std::size_t{1} << 21;
constexpr std::size_t kBlock = std::size_t{1} << 14;  // that a thread looks at at once

// Points by square places of 16 cells: a shard has a part of the columns, not of each.
bool takes(const Shard& shard, const Vec3& p, double cell) {
  const auto place = [&](double v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v / (16 * cell))));
  };
  return shard.takes(place(p.x()) + 31 * place(p.y()));
}

}  // namespace

ColumnFiller::ColumnFiller(const CloudDraftOptions& options, const Shard& shard,
                           const GroundFilter* ground, const Execution& run)
    : options_(options),
      shard_(shard),
      ground_(ground),
      run_{run.threads, {}},
      columns_(options.columns),
      beside_(run.threads <= 1) {
  reserve();
}

void ColumnFiller::reserve() {
  next_.places.reserve(kBatch + kBlock);
  if (ground_) next_.classes.reserve(kBatch + kBlock);
}

void ColumnFiller::add(std::span<const CloudPoint> points) {
  std::size_t n = next_.places.size();
  next_.places.resize(n + points.size());
  for (const CloudPoint& p : points) next_.places[n++] = p.position;
  if (ground_) {
    for (const CloudPoint& p : points) next_.classes.push_back(p.cls);
  }
  if (next_.places.size() >= kBatch) hand_over();
}

void ColumnFiller::finish() {
  hand_over();
  beside_.finish();
}

void ColumnFiller::hand_over() {
  beside_.finish();
  std::swap(current_, next_);
  beside_.run([this] {
    if (shard_.count > 1 || ground_) drop(current_);
    kept_ += current_.places.size();
    columns_.add(current_.places, options_.resolution, run_);
  });
  if (run_.threads <= 1) std::swap(current_, next_);  // done: one batch is enough
  reserve();
  next_.places.clear();
  next_.classes.clear();
}

// Takes out the points of other shards and the ground.
void ColumnFiller::drop(Batch& batch) {
  enum class Fate : std::uint8_t { kept, elsewhere, ground };
  std::vector<Fate> fates(batch.places.size());
  parallel_for((fates.size() + kBlock - 1) / kBlock, run_, [&](std::size_t block) {
    const std::size_t end = std::min(fates.size(), (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < end; ++i) {
      const Vec3& p = batch.places[i];
      if (shard_.count > 1 && !takes(shard_, p, options_.columns.cell)) {
        fates[i] = Fate::elsewhere;
      } else if (ground_ && ground_->is_ground({p, batch.classes[i]})) {
        fates[i] = Fate::ground;
      }
    }
  });
  std::size_t n = 0;
  for (std::size_t i = 0; i < fates.size(); ++i) {
    dropped_ += fates[i] == Fate::ground;
    if (fates[i] == Fate::kept) batch.places[n++] = batch.places[i];
  }
  batch.places.resize(n);
}

}  // namespace geom
