#include <ogrsf_frmts.h>

#include <cmath>

#include "footprints/gdal_reference.h"
#include "footprints/source.h"

namespace footprints {
namespace {

class VectorReader {
 public:
  VectorReader(const std::string& name, const ReadOptions& options)
      : name_(name), options_(options) {}

  Source read(GDALDataset& dataset) {
    for (int i = 0; i < dataset.GetLayerCount(); ++i) {
      OGRLayer& layer = *dataset.GetLayer(i);
      const std::string crs = wkt_of(layer.GetSpatialRef());
      if (i > 0 && crs != out_.crs) {
        throw geom::InputError(name_, fmt::format("expected one coordinate reference system, and "
                                                  "layer \"{}\" has another",
                                                  layer.GetName()));
      }
      out_.crs = crs;
      read_layer(layer);
    }
    if (!options_.height.attribute.empty() && !has_attribute_) {
      throw geom::InputError(name_,
                             fmt::format("expected an attribute \"{}\" (--height-attribute), "
                                         "and no layer has it",
                                         options_.height.attribute));
    }
    return std::move(out_);
  }

 private:
  void read_layer(OGRLayer& layer) {
    CPLErrorReset();
    has_attribute_ |= layer.GetLayerDefn()->GetFieldIndex(options_.height.attribute.c_str()) >= 0;
    if (!options_.where.empty() &&
        layer.SetAttributeFilter(options_.where.c_str()) != OGRERR_NONE) {
      throw geom::InputError(
          name_, fmt::format("--where \"{}\" does not fit layer \"{}\": {}", options_.where,
                             layer.GetName(), CPLGetLastErrorMsg()));
    }
    layer.ResetReading();
    while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) read_feature(*feature);
    if (CPLGetLastErrorType() == CE_Failure) throw geom::InputError(name_, CPLGetLastErrorMsg());
  }

  void read_feature(OGRFeature& feature) {
    const OGRGeometry* geometry = feature.GetGeometryRef();
    const auto kind = geometry ? wkbFlatten(geometry->getGeometryType()) : wkbNone;
    if (!geometry || geometry->IsEmpty()) {
      ++out_.counts["skipped_without_geometry"];
      return;
    }
    if (!OGR_GT_IsSubClassOf(kind, wkbSurface) && !OGR_GT_IsSubClassOf(kind, wkbMultiSurface) &&
        kind != wkbGeometryCollection) {
      ++out_.counts[std::string("skipped_") + OGRGeometryTypeToName(kind)];
      return;
    }
    const auto tag = [&](const char* key) -> std::string {
      const int field = feature.GetFieldIndex(key);
      return field >= 0 && feature.IsFieldSetAndNotNull(field) ? feature.GetFieldAsString(field)
                                                               : "";
    };
    const geom::BuildingHeight height = counted_height(tag, options_, out_);
    const std::size_t before = out_.footprints.size();
    add_polygons(*geometry, static_cast<std::uint64_t>(feature.GetFID()), height);
    if (out_.footprints.size() == before) ++out_.counts["skipped_without_polygons"];
  }

  void add_polygons(const OGRGeometry& geometry, std::uint64_t id,
                    const geom::BuildingHeight& height) {
    if (wkbFlatten(geometry.getGeometryType()) == wkbGeometryCollection) {
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
        add_polygons(*part, id, height);
      }
      return;
    }
    const std::unique_ptr<OGRGeometry> polygons(
        OGRGeometryFactory::forceToMultiPolygon(geometry.getLinearGeometry()));
    if (wkbFlatten(polygons->getGeometryType()) != wkbMultiPolygon) {
      ++out_.counts[std::string("skipped_") + OGRGeometryTypeToName(geometry.getGeometryType())];
      return;
    }
    for (const OGRPolygon* polygon : *polygons->toMultiPolygon()) {
      if (polygon->IsEmpty()) continue;
      geom::Footprint f;
      f.id = id;
      f.bottom = height.bottom;
      f.top = height.top;
      for (const OGRLinearRing* ring : *polygon) {
        (ring == polygon->getExteriorRing() ? f.polygon.outer : f.polygon.holes.emplace_back()) =
            points_of(*ring, f.id);
      }
      out_.footprints.push_back(std::move(f));
    }
  }

  std::vector<geom::Vec2> points_of(const OGRLinearRing& ring, std::uint64_t id) const {
    std::vector<geom::Vec2> points;
    for (int i = 0; i < ring.getNumPoints(); ++i) {
      points.push_back({ring.getX(i), ring.getY(i)});
      if (!points.back().allFinite()) {
        throw geom::InputError(name_, fmt::format("feature {}: point {} is not finite", id, i));
      }
    }
    return points;
  }

  const std::string& name_;
  const ReadOptions& options_;
  bool has_attribute_ = false;
  Source out_;
};

}  // namespace

Source read_vector(const std::string& path, const std::string& name, const ReadOptions& options) {
  const Dataset dataset = open(path, GDAL_OF_VECTOR);
  if (!dataset) {
    throw geom::InputError(name,
                           "expected footprints that GDAL reads (GeoJSON, GeoPackage, "
                           "Shapefile, FlatGeobuf), CityJSON, OSM .pbf or a GeoTIFF, and "
                           "GDAL cannot open this");
  }
  return VectorReader(name, options).read(*dataset);
}

struct Projector::Transformation {
  std::unique_ptr<OGRCoordinateTransformation> to_local;
};

Projector::Projector(const Source& source, const std::string& name,
                     const std::optional<geom::Vec2>& origin)
    : name_(name), transformation_(std::make_unique<Transformation>()) {
  if (source.crs.empty()) {
    if (origin) frame_.origin = geom::GeodeticOrigin{origin->x(), origin->y(), 0};
    return;
  }
  const OGRSpatialReference from = reference(source.crs, name);
  const OGRSpatialReference geodetic = reference("EPSG:4326", name);
  geom::Vec2 at;  // longitude, latitude
  if (origin) {
    at = {origin->y(), origin->x()};
  } else {
    geom::Vec2 low = source.footprints.front().polygon.outer.front();
    geom::Vec2 high = low;
    for (const geom::Footprint& f : source.footprints) {
      for (const geom::Vec2& p : f.polygon.outer) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    }
    at = 0.5 * (low + high);
    const std::unique_ptr<OGRCoordinateTransformation> back(
        OGRCreateCoordinateTransformation(&from, &geodetic));
    if (!back || !back->Transform(1, &at.x(), &at.y())) {
      throw geom::InputError(name, "PROJ cannot tell where on Earth these coordinates are");
    }
    at = (at * 1e6).array().round() / 1e6;  // a tidy origin, a decimetre from the middle
  }
  const std::string local = fmt::format(
      "+proj=tmerc +lat_0={} +lon_0={} +k=1 +x_0=0 +y_0=0 +ellps=WGS84 +units=m +no_defs", at.y(),
      at.x());
  const OGRSpatialReference to = reference(local, name);
  transformation_->to_local.reset(OGRCreateCoordinateTransformation(&from, &to));
  if (!transformation_->to_local) {
    throw geom::InputError(name, "PROJ cannot take these coordinates to local metres");
  }
  frame_.origin = geom::GeodeticOrigin{at.y(), at.x(), 0};
  frame_.crs = local;
}

Projector::~Projector() = default;

geom::Vec2 Projector::operator()(const geom::Vec2& p) const {
  if (!transformation_->to_local) return p;
  geom::Vec2 q = p;
  if (!transformation_->to_local->Transform(1, &q.x(), &q.y()) || !q.allFinite()) {
    throw geom::InputError(name_,
                           fmt::format("PROJ cannot take ({}, {}) to local metres", p.x(), p.y()));
  }
  return q;
}

}  // namespace footprints
