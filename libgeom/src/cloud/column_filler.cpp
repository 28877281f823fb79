#include "column_filler.h"

#include <algorithm>
#include <utility>

#include "geom/base/parallel.h"

namespace geom {
namespace {

// Points: so many that what a processor fetches of the columns is used for several of them. An
// eighth of it takes half as long again.
constexpr std::size_t kBatch = std::size_t{1} << 21;
constexpr std::size_t kBlock = std::size_t{1} << 14;  // that a thread looks at at once

}  // namespace

ColumnFiller::ColumnFiller(const CloudDraftOptions& options, const GroundFilter* ground,
                           const Execution& run)
    : options_(options),
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
    if (ground_) drop_ground(current_);
    kept_ += current_.places.size();
    columns_.add(current_.places, options_.resolution, run_);
  });
  if (run_.threads <= 1) std::swap(current_, next_);  // done: one batch is enough
  reserve();
  next_.places.clear();
  next_.classes.clear();
}

void ColumnFiller::drop_ground(Batch& batch) {
  std::vector<std::uint8_t> ground(batch.places.size());  // not bool: threads write side by side
  parallel_for((ground.size() + kBlock - 1) / kBlock, run_, [&](std::size_t block) {
    const std::size_t end = std::min(ground.size(), (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < end; ++i) {
      ground[i] = ground_->is_ground({batch.places[i], batch.classes[i]});
    }
  });
  std::size_t n = 0;
  for (std::size_t i = 0; i < ground.size(); ++i) {
    dropped_ += ground[i];
    if (!ground[i]) batch.places[n++] = batch.places[i];
  }
  batch.places.resize(n);
}

}  // namespace geom
