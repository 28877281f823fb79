#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>

#include "gdal_reference.h"
#include "source.h"

namespace footprints {
namespace {

class VectorReader {
 public:
  VectorReader(const std::string& name, const ReadOptions& options)
      : name_(name), options_(options) {}

  Source read(GDALDataset& dataset) {
    for (int i = 0; i < dataset.GetLayerCount(); ++i) {
      OGRLayer& layer = *dataset.GetLayer(i);
      const std::string crs = wkt_of(layer.GetSpatialRef(), name_);
      if (i > 0 && crs != out_.crs) {
        throw geom::InputError(name_, fmt::format("expected one coordinate reference system in "
                                                  "all layers, found another in layer \"{}\"",
                                                  layer.GetName()));
      }
      out_.crs = crs;
      unit_ = height_unit(crs, name_, options_);
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
    layer_ = layer.GetName();
    has_attribute_ |= layer.GetLayerDefn()->GetFieldIndex(options_.height.attribute.c_str()) >= 0;
    if (!options_.where.empty() &&
        layer.SetAttributeFilter(options_.where.c_str()) != OGRERR_NONE) {
      throw geom::InputError(
          name_, fmt::format("--where: expected a condition on attributes of layer \"{}\", found "
                             "\"{}\" (GDAL: {})",
                             layer.GetName(), options_.where, CPLGetLastErrorMsg()));
    }
    layer.ResetReading();
    while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) read_feature(*feature);
    if (CPLGetLastErrorType() == CE_Failure) {
      throw geom::InputError(name_, fmt::format("layer \"{}\" cannot be read to its end (GDAL: "
                                                "{}): the file is damaged or cut, get it again",
                                                layer.GetName(), CPLGetLastErrorMsg()));
    }
  }

  void read_feature(OGRFeature& feature) {
    const OGRGeometry* geometry = feature.GetGeometryRef();
    which_ = fmt::format("feature {} of layer {}", feature.GetFID(), layer_);
    if (!geometry || geometry->IsEmpty()) {
      out_.skipped.add("feature without geometry", which_);
      return;
    }
    const auto tag = [&](const char* key) -> std::string {
      const int field = feature.GetFieldIndex(key);
      return field >= 0 && feature.IsFieldSetAndNotNull(field) ? feature.GetFieldAsString(field)
                                                               : "";
    };
    const std::size_t before = out_.footprints.size();
    geom::BuildingHeight height;
    if (holds_surfaces(*geometry)) {
      geom::HeightOptions options = options_.height;
      options.unit = unit_.value_or(1);
      height = geom::building_height(tag, options);
      if (height.bare && !unit_) refuse_heights(name_, out_.crs);
    }
    add_polygons(*geometry, static_cast<std::uint64_t>(feature.GetFID()), height);
    const bool shape = raise(before);
    if (out_.footprints.size() > before) count(feature, height, shape);
  }

  // Where the height of a feature came from that became footprints.
  void count(const OGRFeature& feature, const geom::BuildingHeight& height, bool shape) {
    if (shape) {
      ++out_.counts["heights_from_corners"];
      if (height.unread) out_.skipped.add("height that is not understood", which_);
      return;
    }
    count_height(height, which_, out_);
    if (height.from != geom::HeightFrom::nothing) return;
    for (int i = 0; i < feature.GetFieldCount(); ++i) {
      if (!feature.IsFieldSetAndNotNull(i)) continue;
      note_attribute(feature.GetFieldDefnRef(i)->GetNameRef(), feature.GetFieldAsString(i), out_);
    }
  }

  static bool holds_surfaces(const OGRGeometry& geometry) {
    const auto kind = wkbFlatten(geometry.getGeometryType());
    return OGR_GT_IsSubClassOf(kind, wkbSurface) || OGR_GT_IsSubClassOf(kind, wkbMultiSurface) ||
           kind == wkbGeometryCollection;
  }

  // Every part of a geometry becomes footprints or is named as skipped.
  void add_polygons(const OGRGeometry& geometry, std::uint64_t id,
                    const geom::BuildingHeight& height) {
    if (wkbFlatten(geometry.getGeometryType()) == wkbGeometryCollection) {
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
        add_polygons(*part, id, height);
      }
      return;
    }
    const std::unique_ptr<OGRGeometry> polygons(
        holds_surfaces(geometry)
            ? OGRGeometryFactory::forceToMultiPolygon(geometry.getLinearGeometry())
            : nullptr);
    if (!polygons || wkbFlatten(polygons->getGeometryType()) != wkbMultiPolygon) {
      out_.skipped.add(OGRGeometryTypeToName(wkbFlatten(geometry.getGeometryType())), which_);
      return;
    }
    for (const OGRPolygon* polygon : *polygons->toMultiPolygon()) {
      if (polygon->IsEmpty()) {
        out_.skipped.add("polygon without corners", which_);
        continue;
      }
      geom::Footprint f;
      f.id = id;
      f.bottom = height.bottom;
      f.top = height.top;
      for (const OGRLinearRing* ring : *polygon) {
        (ring == polygon->getExteriorRing() ? f.polygon.outer : f.polygon.holes.emplace_back()) =
            points_of(*ring, f.id);
      }
      out_.footprints.push_back(std::move(f));
      levels_.push_back(levels_of(*polygon));
    }
  }

  // The heights that a polygon's own corners give.
  struct Levels {
    double low = 0;
    double high = 0;
  };
  Levels levels_of(const OGRPolygon& polygon) const {
    OGREnvelope3D reach;
    polygon.getEnvelope(&reach);
    if (!polygon.Is3D() || (reach.MinZ == 0 && reach.MaxZ == 0)) return {};
    if (!unit_) refuse_heights(name_, out_.crs);
    const Levels levels{reach.MinZ * *unit_, reach.MaxZ * *unit_};
    if (!(std::abs(levels.low) <= 1e4 && std::abs(levels.high) <= 1e4)) {
      throw geom::InputError(name_, fmt::format("{}: expected corners within 1e4 m of height 0, "
                                                "found {} to {}",
                                                which_, levels.low, levels.high));
    }
    return levels;
  }

  // Corners with heights: a feature whose own differ is a shape in space, each polygon of which
  // stands on the feature's lowest point. Where they are all the same they may be the ground's,
  // below the building's height, or the roof's: it stands from the lower to the higher of both.
  // Says whether it is a shape in space.
  bool raise(std::size_t first) {
    Levels all = levels_.empty() ? Levels{} : levels_.front();
    for (const Levels& l : levels_) all = {std::min(all.low, l.low), std::max(all.high, l.high)};
    const bool shape = all.low < all.high;
    for (std::size_t i = 0; i < levels_.size() && (all.low != 0 || all.high != 0); ++i) {
      geom::Footprint& f = out_.footprints[first + i];
      ++out_.counts["polygons_with_heights"];
      if (shape) {
        f.bottom = all.low;
        f.top = std::max(levels_[i].high, f.bottom);
      } else {
        f.bottom = std::min(f.bottom, f.bottom + all.low);
        f.top = std::max(f.top, f.top + all.high);
      }
    }
    levels_.clear();
    return shape;
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
  std::optional<double> unit_;  // of heights that name none, where it is clear
  std::string layer_;
  std::string which_;           // the feature that is read
  std::vector<Levels> levels_;  // of its footprints
  Source out_;
};

}  // namespace

Source read_vector(const std::string& path, const std::string& name, const ReadOptions& options) {
  const Dataset dataset = open(path, GDAL_OF_VECTOR);
  if (!dataset) {
    throw geom::InputError(name,
                           "expected footprints that GDAL reads (GeoJSON, GeoPackage, "
                           "Shapefile, FlatGeobuf), CityJSON, OSM .pbf or a GeoTIFF, found "
                           "a file that GDAL cannot open");
  }
  return VectorReader(name, options).read(*dataset);
}

std::optional<double> height_unit(const std::string& crs, const std::string& name,
                                  const ReadOptions& options) {
  if (options.height_unit) return options.height_unit;
  if (crs.empty()) return 1;
  const OGRSpatialReference system = reference(crs, name);
  if (system.IsVertical()) return system.GetTargetLinearUnits("VERT_CS");
  if (system.IsGeographic() || std::abs(system.GetLinearUnits() - 1) < 1e-9) return 1;
  return std::nullopt;
}

void refuse_heights(const std::string& name, const std::string& crs) {
  const double unit = reference(crs, name).GetLinearUnits();
  throw geom::InputError(
      name,
      fmt::format("the file has coordinates in units of {} m, and does not say the unit of its "
                  "heights: give --height-units m, ft or us-ft",
                  unit));
}

struct Projector::Transformation {
  std::unique_ptr<OGRCoordinateTransformation> to_local;
};

namespace {

// The middle of all corners, and the largest extent of one footprint.
struct Layout {
  geom::Vec2 low;
  geom::Vec2 high;
  double largest = 0;

  explicit Layout(const std::vector<geom::Footprint>& footprints)
      : low(footprints.front().polygon.outer.front()), high(low) {
    for (const geom::Footprint& f : footprints) {
      geom::Vec2 least = f.polygon.outer.front();
      geom::Vec2 most = least;
      for (const geom::Vec2& p : f.polygon.outer) {
        least = least.cwiseMin(p);
        most = most.cwiseMax(p);
      }
      low = low.cwiseMin(least);
      high = high.cwiseMax(most);
      largest = std::max(largest, (most - least).maxCoeff());
    }
  }
};

// Numbers in the range of degrees, and not one footprint as large as a tenth of one: as metres that
// would be a city of crumbs.
void require_metres(const Layout& layout, const std::string& name) {
  const bool degrees = layout.low.x() >= -180 && layout.high.x() <= 180 && layout.low.y() >= -180 &&
                       layout.high.y() <= 180 && layout.largest < 0.1;
  if (!degrees) return;
  throw geom::InputError(
      name, fmt::format("the file names no coordinate reference system, and its numbers look like "
                        "degrees: [{}, {}] to [{}, {}]; name the system, for example with "
                        "`ogr2ogr -a_srs EPSG:4326`, or say that they are metres with --metres",
                        layout.low.x(), layout.low.y(), layout.high.x(), layout.high.y()));
}

double kilometres(const geom::Vec2& a, const geom::Vec2& b) {  // longitude, latitude
  const double radians = M_PI / 180;
  const double h = std::pow(std::sin((b.y() - a.y()) * radians / 2), 2) +
                   std::cos(a.y() * radians) * std::cos(b.y() * radians) *
                       std::pow(std::sin((b.x() - a.x()) * radians / 2), 2);
  return 2 * 6371 * std::asin(std::sqrt(std::min(1.0, h)));
}

// `at` and `middle`: longitude, latitude.
void require_near(const geom::Vec2& at, const geom::Vec2& middle, const std::string& name,
                  Source::Warnings& warnings) {
  constexpr double kFar = 200;      // km
  constexpr double kTooFar = 2000;  // where a plane about the origin means nothing any more
  const double away = kilometres(at, middle);
  if (away < kFar) return;
  const bool swapped = std::abs(at.x()) <= 90 && kilometres({at.y(), at.x()}, middle) < kFar;
  const std::string text =
      fmt::format("the origin {},{} is {:.0f} km from the data, which lie about {:.4f},{:.4f}{}",
                  at.y(), at.x(), away, middle.y(), middle.x(),
                  swapped ? ": give the latitude first, then the longitude" : "");
  if (swapped || away > kTooFar) throw geom::InputError(name, text);
  warnings.push_back(text);
}

}  // namespace

Projector::Projector(Source& source, const std::string& name,
                     const std::optional<geom::Vec2>& origin, bool metres)
    : name_(name), transformation_(std::make_unique<Transformation>()) {
  const Layout layout(source.footprints);
  if (source.crs.empty()) {
    if (!metres) require_metres(layout, name);
    if (origin) frame_.origin = geom::GeodeticOrigin{origin->x(), origin->y(), 0};
    return;
  }
  const OGRSpatialReference from = reference(source.crs, name);
  const OGRSpatialReference geodetic = reference("EPSG:4326", name);
  geom::Vec2 middle = 0.5 * (layout.low + layout.high);  // longitude, latitude once transformed
  const std::unique_ptr<OGRCoordinateTransformation> back(
      OGRCreateCoordinateTransformation(&from, &geodetic));
  if (!back || !back->Transform(1, &middle.x(), &middle.y()) || !middle.allFinite() ||
      std::abs(middle.y()) > 90) {
    throw geom::InputError(
        name,
        fmt::format("PROJ cannot tell where on Earth the coordinates [{}, {}] to [{}, {}] are in "
                    "\"{}\": is that the right coordinate reference system?",
                    layout.low.x(), layout.low.y(), layout.high.x(), layout.high.y(),
                    source.crs.substr(0, 60)));
  }
  geom::Vec2 at = (middle * 1e6).array().round() / 1e6;  // a tidy origin, a decimetre off
  if (origin) {
    at = {origin->y(), origin->x()};
    require_near(at, middle, name, source.warnings);
  }
  const std::string local = fmt::format(
      "+proj=tmerc +lat_0={} +lon_0={} +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs", at.y(),
      at.x());
  const OGRSpatialReference to = reference(local, name);
  transformation_->to_local.reset(OGRCreateCoordinateTransformation(&from, &to));
  if (!transformation_->to_local) {
    throw geom::InputError(
        name,
        "PROJ cannot convert these coordinates to metres about the origin: is their "
        "coordinate reference system right?");
  }
  frame_.origin = geom::GeodeticOrigin{at.y(), at.x(), 0};
  frame_.crs = local;
}

Projector::~Projector() = default;

geom::Vec2 Projector::operator()(const geom::Vec2& p) const {
  if (!transformation_->to_local) return p;
  geom::Vec2 q = p;
  if (!transformation_->to_local->Transform(1, &q.x(), &q.y()) || !q.allFinite()) {
    throw geom::InputError(
        name_, fmt::format("PROJ cannot convert ({}, {}) to metres about the origin: is the "
                           "coordinate reference system right?",
                           p.x(), p.y()));
  }
  return q;
}

}  // namespace footprints
