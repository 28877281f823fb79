#include "geom/gis/footprint_format.h"

#include "geom/text/beginning.h"

namespace geom::gis {
namespace {

constexpr std::string_view kReaders[] = {"skyway-footprints"};
constexpr std::string_view kReadersOfKml[] = {"skyway-check", "skyway-import-trajectory",
                                              "skyway-footprints"};
constexpr std::string_view kReadersOfGeoJson[] = {"skyway-footprints", "skyway-map",
                                                  "skyway-check",      "skyway-import-trajectory",
                                                  "skyway-plan",       "skyway-bench"};
constexpr std::string_view kReadersOfFeature[] = {"skyway-footprints", "skyway-map", "skyway-plan",
                                                  "skyway-bench"};

bool is_sqlite(std::string_view head) { return begins_with<"SQLite format 3\0">(head); }

bool is_geopackage(std::string_view head) {
  constexpr std::size_t kApplication = 68;
  return is_sqlite(head) && begins_with<"GP", kApplication>(head);
}

constexpr Format kShapefile{
    .what = "a Shapefile", .begins = begins_with<"\0\0\x27\x0a">, .readers = kReaders};
constexpr Format kFlatGeobuf{
    .what = "a FlatGeobuf", .begins = begins_with<"fgb\x03">, .readers = kReaders};
constexpr Format kGeoPackage{.what = "a GeoPackage", .begins = is_geopackage, .readers = kReaders};
constexpr Format kSqlite{
    .what = "an SQLite database",
    .begins = [](std::string_view head) { return is_sqlite(head) && !is_geopackage(head); },
    .readers = kReaders};
constexpr Format kKmz{.what = "a KMZ file",
                      .begins =
                          [](std::string_view head) {
                            return zip_with<".kml">(head) && !zip_with<"wpmz/">(head) &&
                                   !zip_with<".wpml">(head);
                          },
                      .readers = kReaders};
constexpr Format kGml{.what = "a GML file",
                      .begins =
                          [](std::string_view head) {
                            return xml_with<"opengis.net/gml">(head) &&
                                   !xml_with<"CityModel">(head);
                          },
                      .readers = kReaders};
constexpr Format kPolygons{
    .word = "vector", .what = "polygons that GDAL reads", .readers = kReaders};
constexpr const Format* kVectorKinds[] = {&kShapefile, &kFlatGeobuf,  &kGeoPackage,
                                          &kSqlite,    &kGeoJsonFile, &kGeoJsonFeature,
                                          &kKmlFile,   &kKmz,         &kGml};

constexpr Format kOsmXml{.word = "osm",
                         .what = "an OpenStreetMap file",
                         .begins = xml_with<"<osm">,
                         .readers = kReaders};
constexpr Format kOsmPbf{.what = "an OpenStreetMap extract (.osm.pbf)",
                         .begins = begins_with<"\x0a\x09OSMHeader", 4>,
                         .readers = kReaders};
constexpr const Format* kOsmKinds[] = {&kOsmPbf, &kPackedOsm};

constexpr Format kCityJsonFile{.word = "cityjson",
                               .what = "a CityJSON model",
                               .begins = json_with<R"("type":"CityJSON")">,
                               .readers = kReaders};
constexpr Format kCityGmlFile{.word = "citygml",
                              .what = "a CityGML model",
                              .begins = xml_with<"CityModel">,
                              .readers = kReaders};

constexpr Format kTiff{.word = "raster",
                       .what = "a TIFF or GeoTIFF picture",
                       .begins = any_of<begins_with<"II*\0">, begins_with<"MM\0*">,
                                        begins_with<"II+\0">, begins_with<"MM\0+">>,
                       .readers = kReaders};
constexpr Format kAsciiGrid{.what = "a height model (ASCII grid)",
                            .begins = text_begins_with<"ncols ">,
                            .readers = kReaders};
constexpr const Format* kRasterKinds[] = {&kAsciiGrid};

constexpr const FootprintFormat* kTable[] = {&kVector, &kOsm, &kCityJson, &kCityGml, &kRaster};

}  // namespace

constinit const Format kGeoJsonFile{.word = "geojson",
                                    .what = "a GeoJSON file",
                                    .begins = json_with<R"("type":"FeatureCollection")">,
                                    .readers = kReadersOfGeoJson};
constinit const Format kGeoJsonFeature{.what = "a GeoJSON feature",
                                       .begins =
                                           [](std::string_view head) {
                                             return json_with<R"("type":"Feature")">(head) &&
                                                    !kGeoJsonFile.begins(head);
                                           },
                                       .readers = kReadersOfFeature};
constinit const Format kKmlFile{
    .word = "kml",
    .what = "a KML file",
    .begins =
        [](std::string_view head) { return xml_with<"<kml">(head) && !xml_with<"<wpml:">(head); },
    .readers = kReadersOfKml};
constinit const Format kPackedOsm{.what = "a packed OpenStreetMap extract", .readers = kReaders};

constinit const FootprintFormat kVector{.format = &kPolygons, .kinds = kVectorKinds};
constinit const FootprintFormat kOsm{.format = &kOsmXml, .kinds = kOsmKinds};
constinit const FootprintFormat kCityJson{.format = &kCityJsonFile};
constinit const FootprintFormat kCityGml{.format = &kCityGmlFile};
constinit const FootprintFormat kRaster{.format = &kTiff, .kinds = kRasterKinds};

bool is_packed_osm(std::string_view path) {
  return path.ends_with(".osm.gz") || path.ends_with(".osm.bz2");
}

FormatRows<FootprintFormat> footprint_formats() { return kTable; }

}  // namespace geom::gis
