#pragma once

// One item of the points of a LAZ chunk in the formats 0 to 5.
//
// A map needs places and classes. Of intensity, times, colours, waveforms and extra bytes as much
// is decoded as it takes to come to the next point.

#include <cstdint>
#include <functional>

#include "range_decoder.h"

namespace geom {

struct LazPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;
  std::uint8_t cls = 0;
};

// Is given the points one by one, in the file's order.
using LazPointSink = std::function<void(const LazPoint&)>;

class LazItemDecoder {
 public:
  virtual ~LazItemDecoder() = default;

  // Reads the item of the chunk's next point; of a place or class that it holds, into `point`.
  virtual void next(RangeDecoder& code, LazPoint& point) = 0;
};

}  // namespace geom
