#include "gdal_reference.h"

#include <algorithm>
#include <iterator>

#include "gdal_content.h"
#include "gdal_sql.h"
#include "geom/text/text_table.h"

namespace geom::gis {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& found) {
  throw InputError(
      name, {.expected = "a coordinate reference system that PROJ knows",
             .found = found,
             .advice = "say in the file which it is, for example with `ogr2ogr -a_srs EPSG:25832 "
                       "out.gpkg in.shp`, or take the name away where coordinates are metres"});
}

// What the .prj says that belongs to a shapefile, a table or a grid; empty for other files.
std::string text_beside(const DatasetHandle& dataset, const std::string& path,
                        const std::string& name) {
  const std::string_view driver = gdal().driver_name(gdal().driver_of(dataset.get()));
  constexpr std::string_view kWithPrj[] = {"ESRI Shapefile", "CSV", "AAIGrid", "EHdr"};
  if (std::find(std::begin(kWithPrj), std::end(kWithPrj), driver) == std::end(kWithPrj)) return "";
  for (const char* ending : {"prj", "PRJ"}) {
    const std::string beside = gdal().with_extension(path.c_str(), ending);
    VSIStatBufL about;
    if (gdal().stat(beside.c_str(), &about) == 0) {
      return std::string(trimmed(content_of(beside, name)));
    }
  }
  return "";
}

// Of an SQLite database: GDAL complains of that in a GeoPackage alone.
bool names_row_that_is_gone(const DatasetHandle& dataset) {
  const std::string_view driver = gdal().driver_name(gdal().driver_of(dataset.get()));
  if (driver != "SQLite") return false;
  return !first_text_of(dataset,
                        "SELECT srid FROM geometry_columns WHERE srid > 0 AND srid NOT IN "
                        "(SELECT srid FROM spatial_ref_sys) LIMIT 1")
              .empty();
}

void refuse_prj(const DatasetHandle& dataset, const std::string& path, const std::string& name) {
  const std::string prj = text_beside(dataset, path, name);
  if (!prj.empty()) refuse(name, fmt::format("a .prj that says {}", in_quotes(prj.substr(0, 60))));
}

}  // namespace

void require_known_references(const DatasetHandle& dataset, const std::string& path,
                              const GmlTold& gml, const std::string& name) {
  bool known = true;
  for (int i = 0; i < gdal().layer_count(dataset.get()); ++i) {
    known &= !text_of(gdal().layer_reference(gdal().layer(dataset.get(), i))).empty();
  }
  const std::string complaint = gdal().last_error();
  if (gml.systems.size() > 1) {
    throw InputError(name, {.expected = "one coordinate reference system in the file",
                            .found = fmt::format("\"{}\" and \"{}\"", *gml.systems.begin(),
                                                 *gml.systems.rbegin()),
                            .advice = "bring all to one of them"});
  }
  if (known) return;
  refuse_prj(dataset, path, name);
  if (names_row_that_is_gone(dataset))
    refuse(name, "the number of one that the file does not have");
  if (gml.names_system) refuse(name, "an srsName that is not understood");
  // While it opens GML, GDAL reads its features and complains of these.
  if (!complaint.empty() && gml.geometries == 0)
    refuse(name, fmt::format("one that is not (GDAL: {})", complaint));
}

void require_known_raster_reference(const DatasetHandle& dataset, const std::string& path,
                                    const std::string& name) {
  if (text_of(gdal().spatial_reference(dataset.get())).empty()) refuse_prj(dataset, path, name);
}

bool has_reference_of(OGRGeometryH geometry, OGRLayerH layer) {
  const OGRSpatialReferenceH own = gdal().geometry_reference(geometry);
  const OGRSpatialReferenceH all = gdal().layer_reference(layer);
  if (!own || own == all) return true;
  const char* const options[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", nullptr};
  return all && gdal().is_same_reference(own, all, options);
}

}  // namespace geom::gis
