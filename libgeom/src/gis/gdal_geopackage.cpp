#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gdal_handles.h"
#include "geom/gis/geopackage.h"

namespace geom::gis {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw std::runtime_error(
      fmt::format("cannot write {}: {} (GDAL: {})", path, what, gdal().last_error()));
}

OGRwkbGeometryType type_of(const GeoTable& table) {
  return table.polygons ? wkbPolygon25D : wkbLineString25D;
}

OGRGeometryH line_of(const std::vector<GeodeticPlace>& places, OGRwkbGeometryType type,
                     bool closed) {
  const OGRGeometryH line = gdal().new_geometry(type);
  for (const GeodeticPlace& p : places) gdal().add_point(line, p.longitude, p.latitude, p.height);
  if (closed && !places.empty()) {
    const GeodeticPlace& p = places.front();
    gdal().add_point(line, p.longitude, p.latitude, p.height);
  }
  return line;
}

OGRGeometryH geometry_of(const GeoRow& row, const GeoTable& table) {
  if (!table.polygons) return line_of(row.places, wkbLineString25D, false);
  const OGRGeometryH out = gdal().new_geometry(wkbPolygon25D);
  gdal().add_geometry(out, line_of(row.places, wkbLinearRing, true));
  return out;
}

void add_field(OGRLayerH layer, const std::string& name, OGRFieldType type) {
  const OGRFieldDefnH field = gdal().new_field(name.c_str(), type);
  gdal().create_field(layer, field, true);
  gdal().destroy_field(field);
}

bool add_row(OGRLayerH layer, const GeoRow& row, const GeoTable& table) {
  const OGRFeatureH feature = gdal().new_feature(gdal().layer_definition(layer));
  int field = 0;
  gdal().set_text(feature, field++, row.id.c_str());
  for (const double value : row.numbers) {
    if (!std::isnan(value)) gdal().set_number(feature, field, value);
    ++field;
  }
  for (const std::string& value : row.texts) {
    if (!value.empty()) gdal().set_text(feature, field, value.c_str());
    ++field;
  }
  if (!row.note.empty()) gdal().set_text(feature, field, row.note.c_str());
  gdal().set_geometry(feature, geometry_of(row, table));
  const bool done = gdal().create_feature(layer, feature) == OGRERR_NONE;
  gdal().destroy_feature(feature);
  return done;
}

void write_table(const DatasetHandle& file, const GeoTable& table, const std::string& path) {
  const ReferenceHandle reference = reference_to_write("EPSG:4979", path);
  const OGRLayerH layer =
      gdal().create_layer(file.get(), table.name.c_str(), reference.get(), type_of(table), nullptr);
  if (!layer) fail(path, "it takes no table");
  add_field(layer, "flight", OFTString);
  for (const std::string& name : table.numbers) add_field(layer, name, OFTReal);
  for (const std::string& name : table.texts) add_field(layer, name, OFTString);
  const bool noted = std::any_of(table.rows.begin(), table.rows.end(),
                                 [](const GeoRow& row) { return !row.note.empty(); });
  if (noted) add_field(layer, "note", OFTString);
  if (gdal().start_transaction(layer) != OGRERR_NONE) fail(path, "it takes no rows");
  for (const GeoRow& row : table.rows) {
    if (!add_row(layer, row, table)) fail(path, "it takes no row");
  }
  if (gdal().commit_transaction(layer) != OGRERR_NONE) fail(path, "its rows cannot be kept");
}

bool same(OGRGeometryH geometry, const GeoRow& row, const GeoTable& table) {
  if (!geometry) return false;
  const OGRGeometryH line = table.polygons ? gdal().part_of(geometry, 0) : geometry;
  const std::size_t more = table.polygons ? 1 : 0;
  if (static_cast<std::size_t>(gdal().point_count(line)) != row.places.size() + more) return false;
  for (std::size_t i = 0; i < row.places.size() + more; ++i) {
    double x = 0, y = 0, z = 0;
    gdal().point(line, static_cast<int>(i), &x, &y, &z);
    const GeodeticPlace& p = row.places[i % row.places.size()];
    if (x != p.longitude || y != p.latitude || z != p.height) return false;
  }
  return true;
}

void read_back(const std::string& path, std::span<const GeoTable> tables) {
  const DatasetHandle file(
      gdal().open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  if (!file) fail(path, "it cannot be read back");
  for (const GeoTable& table : tables) {
    const OGRLayerH layer = gdal().layer_named(file.get(), table.name.c_str());
    for (const GeoRow& row : table.rows) {
      const OGRFeatureH feature = layer ? gdal().next_feature(layer) : nullptr;
      const bool read = feature && same(gdal().geometry_of(feature), row, table);
      if (feature) gdal().destroy_feature(feature);
      if (!read) fail(path, "it does not read back as it was written");
    }
  }
}

}  // namespace

void write_geopackage(const std::string& path, std::span<const GeoTable> tables) {
  {
    DatasetHandle file(
        gdal().create(gdal().driver_named("GPKG"), path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (!file) fail(path, "it cannot be made");
    for (const GeoTable& table : tables) write_table(file, table, path);
  }
  read_back(path, tables);
}

}  // namespace geom::gis
