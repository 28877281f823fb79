#pragma once

// One chunk of LAZ points: read as it comes, and decoded by any thread.

#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "geom/base/execution.h"
#include "laz_layers.h"

namespace geom {

class LazChunk {
 public:
  // Of layers, from where the chunk begins: see read_laz_layers().
  static LazChunk of_layers(ByteSource& bytes, const LazSetup& setup, std::uint64_t at_most);

  // Of the formats 0 to 5, from where the chunk begins: it must have so many points (> 0) in so
  // many bytes, which is found when it is decoded.
  static LazChunk of_items(ByteSource& bytes, std::uint64_t points, std::uint64_t size);

  std::uint64_t points() const { return points_; }
  std::uint64_t bytes() const { return end_ - at_; }  // that it takes in the file

  // Decodes the points where they are few enough to be held; before for_each(). Throws
  // InputError(source, …).
  void decode(const LazSetup& setup, std::string_view source);

  // Gives the points; decodes them where decode() did not, and throws as it does.
  void for_each(const LazSetup& setup, std::string_view source, const LazPointSink& sink) const;

 private:
  std::uint64_t at_ = 0;  // its place in the file
  std::uint64_t end_ = 0;
  std::uint64_t points_ = 0;
  std::variant<LazLayers, std::vector<unsigned char>> code_;
  std::vector<LazPoint> decoded_;
};

// The points of a chunk of the formats 0 to 5 that begins here, to where their code ends.
void read_laz_items(ByteSource& bytes, const LazSetup& setup, std::uint64_t points,
                    const LazPointSink& sink);

// How many chunks of at most so many points are held at a time (in_order.h): enough for all
// threads, and no more points than these need of chunks of a usual size.
std::size_t laz_window(const Execution& run, std::uint64_t most_points);

}  // namespace geom
