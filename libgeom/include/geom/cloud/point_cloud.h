#pragma once

// Point clouds, read as they stream: PCD, PLY, LAS, LAZ and XYZ.
//
// Example:
//   std::istringstream in("1 2 3\n4 5 6\n");
//   std::vector<geom::Vec3> points;
//   const geom::CloudCounts counts = geom::read_xyz(
//       in, "scan.xyz", [&](std::span<const geom::CloudPoint> chunk) {
//         for (const geom::CloudPoint& p : chunk) points.push_back(p.position);
//       });
//   assert(counts.read == 2 && points[1] == geom::Vec3(4, 5, 6));

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <span>
#include <string_view>

#include "geom/base/execution.h"
#include "geom/base/skipped.h"
#include "geom/base/vec3.h"
#include "geom/earth/coordinate_reference.h"

namespace geom {

struct CloudPoint {
  Vec3 position;         // as the file gives it, in double: nothing is lost of large coordinates
  std::uint8_t cls = 0;  // LAS classification; 0 elsewhere
};

// Is given the points chunk by chunk, in the file's order.
using PointSink = std::function<void(std::span<const CloudPoint>)>;

// Is told what a file says of its coordinates, before the first point.
using ReferenceSink = std::function<void(const CoordinateReference&)>;

// Reads up to `to.size()` bytes from this place of a file; gives how many there were.
using ReadAt = std::function<std::size_t(std::uint64_t at, std::span<unsigned char> to)>;

// Options that change only the time that reading LAS takes.
struct LasReading {
  Execution run = {};  // chunks of LAZ are decoded on all threads; not so in formats 0 to 5 where
  ReadAt ahead = {};   // there is no second way into the file, to where it says how large they are
};

struct CloudCounts {
  std::size_t read = 0;        // points in the file
  std::size_t not_finite = 0;  // of these, left out: a coordinate is NaN or infinite
  Skipped skipped;             // shapes other than points, possibly obstacles: faces of a mesh
};

// Each throws InputError(source, …) for a header that is wrong or of a kind not known, for data
// that end before the points that the header promises or hold more, for a word where a number
// should be, and for coordinates beyond kLargestCoordinate. Memory does not grow with the file, but
// for compressed PCD, which is unpacked whole.
CloudCounts read_pcd(std::istream& in, std::string_view source, const PointSink& sink);
CloudCounts read_ply(std::istream& in, std::string_view source, const PointSink& sink);

// LAS 1.0 to 1.4 and LAZ, point formats 0 to 10; COPC is read whole, as the LAZ that it is. Debian
// packages no LAZ library, so the decoder is ours: M. Isenburg, "LASzip: lossless compression of
// LiDAR data", PE&RS 79(2), 2013, and the format as published, items of versions 1, 2 and 3. A
// chunk that takes other bytes than its table or its layers say throws, and so does one that is cut
// short. Memory grows with chunks of layers (three, and a dozen for each further thread), and with
// the compressed points where chunks of formats 0 to 5 vary in size. The sink is called by one
// thread at a time, which need not be the caller's. The reference is what its GeoTIFF keys and its
// well-known text say, read where they stand before the points; two that differ, and one that
// stands after the points alone, throw.
CloudCounts read_las(std::istream& in, std::string_view source, const PointSink& sink,
                     const ReferenceSink& reference = {}, const LasReading& reading = {});

// Three numbers a line, then anything. One separator holds for the whole file: blanks, tabs, commas
// or semicolons, as the first point has them; numbers have decimal points. A line of words before
// the first point names the columns ("Northing Easting Height", "id,X [m],Y [m],Z [m]") and is
// obeyed; it throws where it does not name one column for each axis and all columns of the points,
// and where it says degrees, another unit than metres, or depth. `#` and `//` begin comments, which
// are headers where they name all three axes. A number alone before the points is their count.
CloudCounts read_xyz(std::istream& in, std::string_view source, const PointSink& sink);

}  // namespace geom
