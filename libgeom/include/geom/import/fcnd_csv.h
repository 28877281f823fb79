#pragma once

// FCND tables (`colliders.csv`): a latitude and longitude line, then centre and half sizes.
//
// Example:
//   std::istringstream in("lat0 37.79, lon0 -122.39\n"
//                         "posX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n10,20,5,5,5,5\n");
//   const geom::FcndTable city = geom::read_fcnd_csv(in, "colliders.csv");
//   assert(city.table.boxes[0] == (geom::Aabb{{5, 15, 0}, {15, 25, 10}}));

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string_view>

#include "geom/base/execution.h"
#include "geom/base/skipped.h"
#include "geom/map/box_map.h"

namespace geom {

struct FcndTable {
  BoxTable table;  // ids are line numbers of the source
  std::optional<GeodeticOrigin> origin;
  std::size_t flat = 0;       // boxes with one or two zero half sizes: kept
  Skipped skipped;            // columns and fields that may turn or move a box
  double largest_change = 0;  // metres that rounding outward moved a face by, at most
};

// Reads `lat0 A, lon0 B`, perhaps with further such pairs (`lat1`, `lon1`), bare `A,B`, with
// commas, blanks or both in between, or the three-line form; all of them optional. Then the header
// posX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ (any order) or none. Further columns
// are ignored unless their name speaks of a turn (yaw, rotation, …); those, and fields beyond the
// columns, are `skipped`.
// Throws InputError(source, line, …) for a missing column, a field that is not a finite number, a
// negative half size, a box with three zero half sizes (likely a latitude and longitude read as a
// box), and a table without boxes.
// Lines are parsed on all threads; the error is that of the first bad line. `bytes`: how long the
// rest of the stream is, where that is known; then the table does not grow step by step.
FcndTable read_fcnd_csv(std::istream& in, std::string_view source, const Execution& run = {},
                        std::uint64_t bytes = 0);

struct CenteredBox {
  Vec3 center;
  Vec3 half;
};

void write_fcnd_csv(std::ostream& out, const GeodeticOrigin& origin,
                    std::span<const CenteredBox> boxes);

struct BoxFormat;
extern const BoxFormat kFcnd;  // of box_formats()

}  // namespace geom
