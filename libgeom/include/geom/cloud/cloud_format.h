#pragma once

// The formats that point clouds come in, as a table of their readers.
//
// Example:
//   std::istringstream in("1 2 3\n4 5 6\n");
//   const geom::CloudFormat* const format =
//       geom::row_recognised("1 2 3\n4 5 6\n", geom::cloud_formats());
//   const auto sink = [](std::span<const geom::CloudPoint>) {};
//   const geom::CloudCounts counts =
//       format->read(in, "scan.xyz", sink, [](const geom::CoordinateReference&) {}, {});

#include "geom/base/format.h"
#include "geom/cloud/point_cloud.h"

namespace geom {

struct CloudFormat {
  const Format* format;
  Formats kinds = {};
  bool (*may_be)(std::string_view head) = nullptr;  // where no format of the table is sure
  // As read_las(): the reference is told before the first point, also where a format has no place
  // for one. Throws InputError.
  CloudCounts (*read)(std::istream& in, std::string_view source, const PointSink& sink,
                      const ReferenceSink& reference, const LasReading& reading);
  bool is_surveyed = false;  // its points have classes, and it may say its coordinate reference
};

// Each is defined in the file of its reader.
extern const CloudFormat kPcdCloud;
extern const CloudFormat kPlyCloud;
extern const CloudFormat kLasCloud;
extern const CloudFormat kXyzCloud;

// PCD, PLY, LAS (with LAZ and COPC) and, for any other text, XYZ.
inline constexpr const CloudFormat* kCloudFormats[] = {&kPcdCloud, &kPlyCloud, &kLasCloud,
                                                       &kXyzCloud};
inline FormatRows<CloudFormat> cloud_formats() { return kCloudFormats; }

extern const Format kPlyFile;  // of points or of triangles

}  // namespace geom
