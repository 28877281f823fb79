#pragma once

// Columns of the points of a stream, which all threads fill while the stream is read on.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/beside.h"
#include "geom/cloud/draft_cloud.h"
#include "geom/cloud/ground_filter.h"
#include "geom/map/column_grid.h"

namespace geom {

class ColumnFiller {
 public:
  // Takes the points that are no ground; `ground` may be null. All must outlive it.
  ColumnFiller(const CloudDraftOptions& options, const GroundFilter* ground, const Execution& run);

  // What a point is refused for may be thrown by a later call.
  void add(std::span<const CloudPoint> points);
  void finish();

  std::size_t kept() const { return kept_; }        // of all points, once finished
  std::size_t dropped() const { return dropped_; }  // as ground
  ColumnGrid take_columns() { return std::move(columns_); }

 private:
  struct Batch {
    std::vector<Vec3> places;
    std::vector<std::uint8_t> classes;
  };

  Batch& next() { return batches_[handed_over_ % batches_.size()]; }  // comes in
  void reserve();
  void hand_over();
  void drop_ground(Batch& batch);

  const CloudDraftOptions& options_;
  const GroundFilter* ground_;
  Execution run_;
  std::size_t batch_;  // points that go into the columns together
  ColumnGrid columns_;
  std::size_t kept_ = 0;
  std::size_t dropped_ = 0;
  std::vector<Batch> batches_;  // in turns
  std::size_t handed_over_ = 0;
  std::atomic<bool> reads_on_ = run_.threads > 1;
  Beside beside_;  // last: it ends before what it works on
};

}  // namespace geom
