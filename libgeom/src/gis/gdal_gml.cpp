#include "gdal_gml.h"

#include <atomic>
#include <cmath>

#include "gdal_content.h"
#include "geom/text/counted.h"
#include "geom/text/text_table.h"
#include "gml_words.h"

namespace geom::gis {
namespace {

constexpr const char* kOpenRings = "OGR_GEOMETRY_ACCEPT_UNCLOSED_RING";

bool is_gml(const std::string& path) {
  const GDALDriverH driver = gdal().identify(path.c_str(), GDAL_OF_VECTOR, nullptr, nullptr);
  return driver && std::string_view(gdal().driver_name(driver)) == "GML";
}

std::size_t polygons_of(OGRGeometryH geometry) {
  const OGRwkbGeometryType kind = gdal().flat_type(gdal().geometry_type(geometry));
  if (gdal().is_subclass(kind, wkbCurvePolygon)) return 1;
  if (!gdal().is_subclass(kind, wkbGeometryCollection) &&
      !gdal().is_subclass(kind, wkbPolyhedralSurface)) {
    return 0;
  }
  std::size_t count = 0;
  for (int i = 0; i < gdal().part_count(geometry); ++i) {
    count += polygons_of(gdal().part_of(geometry, i));
  }
  return count;
}

void require_metres_of_radii(const DatasetHandle& dataset, const GmlTold& told,
                             const std::string& name) {
  const auto refuse = [&](const std::string& found) {
    throw InputError(name, {.item = "the radius of an arc about its centre",
                            .expected = "metres, and coordinates in metres",
                            .found = found,
                            .advice = "write the arc through three points, or as a polygon"});
  };
  for (const std::string& uom : told.radii) {
    const std::string unit = unit_of(uom);
    if (unit != "m" && unit != "metre" && unit != "meter") refuse(in_quotes(uom.substr(0, 40)));
  }
  for (int i = 0; !told.radii.empty() && i < gdal().layer_count(dataset.get()); ++i) {
    const auto crs = reference_of(gdal().layer_reference(gdal().layer(dataset.get(), i)), name);
    if (crs && std::abs(crs->unit().value_or(0) - 1) > 1e-9) refuse("coordinates in another unit");
  }
}

}  // namespace

std::unique_ptr<GmlInMemory> GmlInMemory::of(const std::string& path, const std::string& name) {
  if (!is_gml(path)) return nullptr;
  std::string text = content_of(path, name);
  if (text.starts_with("\x1f\x8b")) text = content_of("/vsigzip/" + path, name);
  return std::unique_ptr<GmlInMemory>(new GmlInMemory(std::move(text)));
}

GmlInMemory::GmlInMemory(std::string text) : text_(std::move(text)) {
  static std::atomic<unsigned> number = 0;
  path_ = fmt::format("/vsimem/skyway_{}.gml", ++number);
  gdal().set_option_of_thread(kOpenRings, "NO");
  const FileHandle file(gdal().file_in_memory(path_.c_str(), reinterpret_cast<GByte*>(text_.data()),
                                              text_.size(), FALSE));
}

GmlInMemory::~GmlInMemory() {
  gdal().set_option_of_thread(kOpenRings, nullptr);
  gdal().remove(path_.c_str());
  gdal().remove(gdal().with_extension(path_.c_str(), "gfs"));
}

void require_whole_gml(const DatasetHandle& dataset, const GmlTold& told, const std::string& name) {
  require_metres_of_radii(dataset, told, name);
  std::size_t geometries = 0;
  std::size_t polygons = 0;
  std::size_t without = 0;  // features: each is skipped by itself, and told
  for (int i = 0; i < gdal().layer_count(dataset.get()); ++i) {
    const OGRLayerH layer = gdal().layer(dataset.get(), i);
    gdal().rewind(layer);
    while (const FeatureHandle feature{gdal().next_feature(layer)}) {
      const OGRGeometryH geometry = gdal().geometry_of(feature.get());
      ++(geometry ? geometries : without);
      if (geometry) polygons += polygons_of(geometry);
    }
  }
  const bool whole = polygons >= told.polygons || without > 0;
  if (geometries + without >= told.geometries && whole) return;
  throw InputError(
      name, {.says = fmt::format("its features have {} and {}, and GDAL reads {} and {}",
                                 counted(told.geometries, "geometry", "geometries"),
                                 counted(told.polygons, "polygon"), geometries, polygons),
             .advice = "write one geometry for each feature, of surfaces of GML 3 with closed "
                       "rings, and give lists of three numbers a point a srsDimension"});
}

}  // namespace geom::gis
