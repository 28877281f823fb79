#pragma once

// The reference system of a file's coordinates, and the length of its units.
//
// Example:
//   const geom::CoordinateReference told =
//       geom::reference_of_wkt(R"(LOCAL_CS["site",UNIT["foot",0.3048]])");
//   if (told.plane) std::cout << "a unit is " << *told.plane << " m long\n";

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace geom {

struct CoordinateReference {
  enum class Kind {
    none,       // the file says nothing
    metric,     // lengths: a projected or a local system
    no_plane,   // degrees, metres from the centre of the Earth, a Mercator map of the whole world:
                // what is one metre long there is not one metre long in the numbers
    not_known,  // something that is not understood
  };
  Kind kind = Kind::none;
  std::string crs;              // the text or "EPSG:…" by which the file names it; local: empty
  std::optional<double> plane;  // metres in a unit of x and y, where that is told
  std::optional<double> up;     // of z, where it is told apart
  bool up_unclear = false;      // heights have a reference of their own whose unit is not told
  bool depths = false;          // z counts downwards (only PROJ tells)
  std::optional<int> epsg;      // the code of x and y, where it is told
  std::string name;             // for messages
  std::string moved;    // words of the file which say that its coordinates are shifted or scaled
  bool scaled = false;  // the latter

  friend bool operator==(const CoordinateReference&, const CoordinateReference&) = default;
};

// Reads well-known text as GDAL and Esri write it (WKT 1), and that of ISO 19162 (WKT 2). No data
// base is asked: a unit that the text does not give is not known.
CoordinateReference reference_of_wkt(std::string_view text);

// Reads the keys of GeoTIFF 1.1 (OGC 19-008), as LAS files have them: the directory (34735), and
// the doubles (34736) that it points into. Codes of EPSG whose unit follows from their range (UTM)
// or is well known (heights above common levels) are understood, others not.
CoordinateReference reference_of_geo_keys(std::span<const std::uint16_t> directory,
                                          std::span<const double> doubles);

}  // namespace geom
