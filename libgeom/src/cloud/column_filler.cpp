#include "column_filler.h"

#include <algorithm>
#include <utility>

#include "geom/base/parallel.h"

namespace geom {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 14;  // points that a thread looks at at once

// Points: few for one thread, which finds them in its cache, and work for all of several threads.
std::size_t batch_for(const Execution& run) {
  return run.threads <= 1 ? std::size_t{1} << 15 : std::size_t{1} << 21;
}

}  // namespace

ColumnFiller::ColumnFiller(const CloudDraftOptions& options, const GroundFilter* ground,
                           const Execution& run)
    : options_(options),
      ground_(ground),
      run_{run.threads, {}},
      batch_(batch_for(run)),
      columns_(options.columns),
      beside_(run.threads <= 1) {
  reserve();
}

void ColumnFiller::reserve() {
  next_.places.reserve(batch_ + kBlock);
  if (ground_) next_.classes.reserve(batch_ + kBlock);
}

void ColumnFiller::add(std::span<const CloudPoint> points) {
  std::size_t n = next_.places.size();
  next_.places.resize(n + points.size());
  for (const CloudPoint& p : points) next_.places[n++] = p.position;
  if (ground_) {
    for (const CloudPoint& p : points) next_.classes.push_back(p.cls);
  }
  if (next_.places.size() >= batch_) hand_over();
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
