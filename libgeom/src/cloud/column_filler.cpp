#include "column_filler.h"

#include <algorithm>
#include <utility>

#include "geom/base/parallel.h"

namespace geom {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 14;  // points that a thread looks at at once

constexpr std::size_t kAhead = 4;  // batches that may wait for other threads
// Points: few for one thread, which finds them in its cache, and work for all of several threads.
std::size_t batch_for(const Execution& run) {
  return std::size_t{1} << (run.threads <= 1 ? 15 : 19);
}

}  // namespace

ColumnFiller::ColumnFiller(const CloudDraftOptions& options, const GroundFilter* ground,
                           const Execution& run)
    : options_(options),
      ground_(ground),
      run_{run.threads, {}},
      batch_(batch_for(run)),
      columns_(options.columns),
      batches_(run.threads <= 1 ? 1 : kAhead + 1),
      beside_(run.threads <= 1 ? 0 : kAhead) {
  reserve();
}

void ColumnFiller::reserve() {
  next().places.reserve(batch_ + kBlock);
  if (ground_) next().classes.reserve(batch_ + kBlock);
}

void ColumnFiller::add(std::span<const CloudPoint> points) {
  Batch& batch = next();
  std::size_t n = batch.places.size();
  batch.places.resize(n + points.size());
  for (const CloudPoint& p : points) batch.places[n++] = p.position;
  if (ground_) {
    for (const CloudPoint& p : points) batch.classes.push_back(p.cls);
  }
  if (n >= batch_) hand_over();
}

void ColumnFiller::finish() {
  reads_on_ = false;
  hand_over();
  beside_.finish();
  batches_.clear();
}

void ColumnFiller::hand_over() {
  beside_.run([this, &batch = next()] {
    if (ground_) drop_ground(batch);
    kept_ += batch.places.size();
    columns_.add(batch.places, options_.resolution, run_);
    batch.places.clear();
    batch.classes.clear();
    while (reads_on_ && !beside_.is_waited_for() && columns_.sort_some()) {
    }
  });
  ++handed_over_;
  reserve();
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
