#include "traj/files/foreign_formats.h"

#include "geom/model/model_format.h"
#include "geom/text/beginning.h"
#include "traj/mission/formats/fence_file.h"

namespace traj::files {
namespace {

using geom::begins_with;
using geom::Format;
using geom::json_with;
using geom::xml_with;
using geom::zip_with;

constexpr std::string_view kToCloud = "convert it to LAS, PLY or PCD, which skyway-cloud reads";
constexpr std::string_view kToTable = "write it as CSV or GeoPackage";
constexpr std::string_view kToCsv = "write its table as CSV";
constexpr std::string_view kToUtf8 = "write it as UTF-8";
constexpr std::string_view kUnpack = "unpack it first";
constexpr std::string_view kToTrajectory =
    "convert its positions to a table id,x,y,z in metres, which skyway-check --paths-csv reads";

constexpr std::string_view kMapTool[] = {"skyway-map"};
constexpr std::string_view kViewTool[] = {"skyway-view"};
constexpr std::string_view kFlightTool[] = {"skyway-import-flight"};

// What another form of it is a source of obstacles.
constexpr Format kE57{
    .what = "an E57 point cloud", .begins = begins_with<"ASTM-E57">, .advice = kToCloud};
constexpr Format kFullOctomap{.what = "a full OctoMap (.ot)",
                              .begins = begins_with<"# Octomap OcTree file">,
                              .advice = "write it as .bt, which skyway-import reads"};
constexpr Format kCityFeatures{
    .what = "features of CityJSON without their first line",
    .begins = json_with<R"("type":"CityJSONFeature")">,
    .advice = "put the CityJSON line of their sequence or service before them"};
constexpr Format kZippedShapes{
    .what = "a Shapefile in a ZIP archive (.shz)",
    .begins = geom::any_of<zip_with<".shp">, zip_with<".shx">, zip_with<".dbf">, zip_with<".prj">,
                           zip_with<".cpg">>,
    .advice = "unpack it, and give skyway-footprints the .shp beside its other files"};
constexpr Format kIfc{.what = "an IFC or STEP model", .begins = begins_with<"ISO-10303-21">};

// Logs and tracks of flights, fences, and missions that want a wrapping.
constexpr Format kDataFlash{.what = "an ArduPilot flight log (DataFlash .bin)",
                            .begins = begins_with<"\xa3\x95\x80">,
                            .advice = kToTrajectory};
constexpr Format kRosBag{
    .what = "a ROS bag", .begins = begins_with<"#ROSBAG V">, .advice = kToTrajectory};
constexpr Format kMcap{
    .what = "an MCAP log", .begins = begins_with<"\x89MCAP0\r\n">, .advice = kToTrajectory};
// MAVLink frames behind 8 bytes of microseconds since 1970.
bool is_tlog(std::string_view head) {
  if (head.size() < 9) return false;
  const bool time = head[0] == 0 && head[1] >= 4 && head[1] <= 7;
  return time && (head[8] == '\xfe' || head[8] == '\xfd');
}
constexpr Format kTlog{
    .what = "a telemetry log (tlog)", .begins = is_tlog, .advice = kToTrajectory};
constexpr Format kGpx{.what = "a GPX track", .begins = xml_with<"<gpx">, .advice = kToTrajectory};
constexpr Format kWpml{.what = "a DJI mission (WPML)",
                       .begins = xml_with<"<wpml:">,
                       .advice =
                           "put it into a ZIP archive (.kmz) as wpmz/waylines.wpml, which "
                           "skyway-check and skyway-import-trajectory read"};
constexpr Format kQgcFence{
    .what = "a QGroundControl fence",
    .begins = json_with<R"("fileType":"GeoFence")">,
    .advice = "write its polygons as GeoJSON for skyway-map patch --keep-out"};

constexpr Format kPng{
    .what = "a PNG picture", .begins = begins_with<"\x89PNG\r\n\x1a\n">, .readers = kViewTool};
constexpr Format kJpeg{.what = "a JPEG picture", .begins = begins_with<"\xff\xd8\xff">};
constexpr Format kPdf{.what = "a PDF document", .begins = begins_with<"%PDF">};
constexpr Format kSvg{.what = "an SVG drawing", .begins = xml_with<"<svg">};
constexpr Format kHtml{.what = "an HTML page",
                       .begins = geom::any_of<xml_with<"<html">, xml_with<"<HTML">>};

constexpr Format kHdf5{.what = "an HDF5 file", .begins = begins_with<"\x89HDF\r\n\x1a\n">};
constexpr Format kNumpy{.what = "a NumPy array (.npy)", .begins = begins_with<"\x93NUMPY">};
constexpr Format kNumpyArchive{.what = "NumPy arrays (.npz)", .begins = zip_with<".npy">};
constexpr Format kParquet{
    .what = "a Parquet table", .begins = begins_with<"PAR1">, .advice = kToTable};
constexpr Format kArrow{
    .what = "an Arrow table", .begins = begins_with<"ARROW1">, .advice = kToTable};
constexpr Format kOffice{
    .what = "an office document",
    .begins = geom::any_of<zip_with<"[Content_Types].xml">, zip_with<"mimetype">>,
    .advice = kToCsv};

constexpr Format kGzip{
    .what = "a gzip archive", .begins = begins_with<"\x1f\x8b">, .advice = "unpack it with gunzip"};
constexpr Format kBzip2{
    .what = "a bzip2 archive", .begins = begins_with<"BZh">, .advice = "unpack it with bunzip2"};
constexpr Format kXz{.what = "an xz archive",
                     .begins = begins_with<"\xfd"
                                           "7zXZ\0">,
                     .advice = "unpack it with unxz"};
constexpr Format kZstandard{.what = "a Zstandard archive",
                            .begins = begins_with<"\x28\xb5\x2f\xfd">,
                            .advice = "unpack it with unzstd"};
constexpr Format kSevenZip{
    .what = "a 7-Zip archive", .begins = begins_with<"7z\xbc\xaf\x27\x1c">, .advice = kUnpack};
constexpr Format kTar{
    .what = "a tar archive", .begins = begins_with<"ustar", 257>, .advice = kUnpack};

constexpr Format kProgram{.what = "a program (ELF)",
                          .begins = begins_with<"\x7f"
                                                "ELF">};
constexpr Format kUtf32{
    .what = "text in UTF-32", .begins = begins_with<"\xff\xfe\0\0">, .advice = kToUtf8};
constexpr Format kUtf16{.what = "text in UTF-16",
                        .begins = geom::any_of<begins_with<"\xff\xfe">, begins_with<"\xfe\xff">>,
                        .advice = kToUtf8};
constexpr Format kXml{.what = "an XML file", .begins = xml_with<"<?xml">};

}  // namespace

constinit const Format kFenceText{.what = "a fence or rally points without a mission",
                                  .begins = traj::is_fence_text,
                                  .readers = kMapTool,
                                  .advice = "skyway-map patch --fence makes a fence part of a map"};
constinit const Format kPx4Log{.what = "a PX4 flight log (ULog)",
                               .begins = begins_with<"ULog\x01\x12\x35">,
                               .readers = kFlightTool};
constinit const Format kZip{.what = "a ZIP archive", .begins = geom::is_zip, .advice = kUnpack};

geom::Formats foreign_formats() {
  static constexpr const Format* kTable[] = {
      &kE57,      &kFullOctomap, &kCityFeatures, &kZippedShapes, &geom::kTileFile,
      &kIfc,      &kFenceText,   &kPx4Log,       &kDataFlash,    &kRosBag,
      &kMcap,     &kTlog,        &kGpx,          &kWpml,         &kQgcFence,
      &kPng,      &kJpeg,        &kPdf,          &kSvg,          &kHtml,
      &kHdf5,     &kNumpy,       &kNumpyArchive, &kParquet,      &kArrow,
      &kOffice,   &kGzip,        &kBzip2,        &kXz,           &kZstandard,
      &kSevenZip, &kTar,         &kProgram,      &kUtf32,        &kUtf16,
      &kXml,      &kZip};
  return kTable;
}

}  // namespace traj::files
