#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "gdal_arcs.h"
#include "gdal_gml.h"
#include "gdal_handles.h"
#include "gdal_numbers.h"
#include "gdal_reference.h"
#include "gdal_whole.h"
#include "geom/gis/footprint_source.h"
#include "geom/text/counted.h"
#include "gml_told.h"
#include "gml_words.h"
#include "xml_heads.h"

namespace geom::gis {
namespace {

class VectorReader {
 public:
  VectorReader(const std::string& name, const ReadOptions& options)
      : name_(name), options_(options) {}

  Source read(const DatasetHandle& dataset, const std::string& path) {
    const std::size_t least = require_whole(dataset, path, name_);
    // GDAL makes a hole of any ring within another there.
    clockwise_outlines_ =
        std::string_view(gdal().driver_name(gdal().driver_of(dataset.get()))) == "ESRIJSON";
    require_whole_numbers(dataset, path, options_.height.attribute, name_);
    bool any = false;
    for (int i = 0; i < gdal().layer_count(dataset.get()); ++i) {
      const OGRLayerH layer = gdal().layer(dataset.get(), i);
      if (is_of_qgis(layer)) continue;
      const auto crs = reference_of(gdal().layer_reference(layer), name_);
      if (any && (crs ? crs->told().crs : "") != (out_.crs ? out_.crs->told().crs : "")) {
        throw InputError(
            name_, {.expected = "one coordinate reference system in all layers",
                    .found = fmt::format("another in layer \"{}\"", gdal().layer_name(layer))});
      }
      any = true;
      out_.crs = crs;
      unit_ = height_unit(crs, name_, options_);
      read_layer(layer);
    }
    if (options_.where.empty() && features_ < least) {
      throw InputError(name_, {.says = fmt::format(
                                   "the file has {}, and GDAL reads {}: it is damaged, or not "
                                   "quite of its format; write it anew, for example as GeoPackage",
                                   counted(least, "feature"), features_)});
    }
    return std::move(out_);
  }

 private:
  // How QGIS draws the other tables, and what it was doing: no places.
  static bool is_of_qgis(OGRLayerH layer) {
    const std::string_view name = gdal().layer_name(layer);
    return (name == "layer_styles" || name == "qgis_projects") &&
           gdal().layer_geometry_count(gdal().layer_definition(layer)) == 0;
  }

  void read_layer(OGRLayerH layer) {
    gdal().forget_errors();
    layer_ = gdal().layer_name(layer);
    handle_ = layer;
    fields_.clear();
    out_.has_height_attribute |= gdal().layer_field_index(gdal().layer_definition(layer),
                                                          options_.height.attribute.c_str()) >= 0;
    if (!options_.where.empty() &&
        gdal().set_filter(layer, options_.where.c_str()) != OGRERR_NONE) {
      throw InputError(
          name_, {.item = "--where",
                  .expected = fmt::format("a condition on attributes of layer \"{}\"",
                                          gdal().layer_name(layer)),
                  .found = fmt::format("\"{}\" (GDAL: {})", options_.where, gdal().last_error())});
    }
    gdal().rewind(layer);
    while (const FeatureHandle feature{gdal().next_feature(layer)}) {
      ++features_;
      read_feature(feature.get());
      note_warning();
    }
    if (gdal().last_error_type() == CE_Failure) {
      throw InputError(name_,
                       {.says = fmt::format("layer \"{}\" cannot be read to its end (GDAL: {})",
                                            gdal().layer_name(layer), gdal().last_error()),
                        .advice = "the file is damaged or cut, get it again"});
    }
  }

  // As of the number "10a" of a house in a column that is said to be of whole numbers: GDAL
  // reads 10.
  void note_warning() {
    constexpr std::size_t kMost = 3;
    if (gdal().last_error_type() != CE_Warning) return;
    const std::string warning = fmt::format("GDAL warns: {}", gdal().last_error());
    gdal().forget_errors();
    if (out_.warnings.size() < kMost &&
        std::find(out_.warnings.begin(), out_.warnings.end(), warning) == out_.warnings.end()) {
      out_.warnings.push_back(warning);
    }
  }

  void read_feature(OGRFeatureH feature) {
    const OGRGeometryH geometry = gdal().geometry_of(feature);
    const GIntBig id = gdal().feature_id(feature);
    which_ = fmt::format("feature {} of layer {}", id, layer_);
    skip_further(feature);
    if (!geometry || gdal().is_empty(geometry)) {
      out_.skipped.add("feature without geometry", which_);
      return;
    }
    if (!has_reference_of(geometry, handle_)) {
      throw InputError(name_, {.item = which_,
                               .expected = "the coordinate reference system of its layer",
                               .found = "another",
                               .advice = "bring all features to one system"});
    }
    const auto tag = [&](const char* key) { return values_of(feature, key); };
    const std::size_t before = out_.footprints.size();
    BuildingHeight height;
    if (holds_surfaces(geometry)) {
      HeightOptions options = options_.height;
      options.unit = unit_.value_or(1);
      height = building_height(tag, options);
      if (height.bare && !unit_) refuse_heights(name_, *out_.crs);
    }
    add_polygons(geometry, static_cast<std::uint64_t>(id), height);
    raise(before, height);
    if (out_.footprints.size() > before) count(feature, height);
    solid_ = false;
  }

  // A table may have several columns of geometries: the plan, the roof, a place for the label.
  void skip_further(OGRFeatureH feature) {
    for (int i = 1; i < gdal().geometry_count(feature); ++i) {
      const OGRGeometryH geometry = gdal().geometry_at(feature, i);
      if (geometry && !gdal().is_empty(geometry)) {
        out_.skipped.add("further geometry of a feature", which_);
      }
    }
  }

  // Of all fields that are so called in any case: a file may have "height" beside "HEIGHT".
  std::string values_of(OGRFeatureH feature, const char* key) {
    std::string values;
    for (const int field : fields_of(feature, key)) {
      if (gdal().is_field_set(feature, field)) {
        add_value(value_of(feature, field) + unit_beside(feature, field), values);
      }
    }
    return values;
  }

  const std::vector<int>& fields_of(OGRFeatureH feature, const char* key) {
    const auto known = fields_.find(key);
    if (known != fields_.end()) return known->second;
    std::vector<int>& fields = fields_[key];
    for (int i = 0; i < gdal().field_count(feature); ++i) {
      if (is_attribute(gdal().field_name(gdal().field(feature, i)), key)) fields.push_back(i);
    }
    return fields;
  }

  static std::string value_of(OGRFeatureH feature, int field) {
    if (gdal().field_subtype(gdal().field(feature, field)) == OFSTBoolean) {
      return gdal().integer(feature, field) ? "true" : "false";  // no length of 1
    }
    return gdal().text(feature, field);
  }

  // " ft", where the field "height_uom" says so: GDAL has the attribute "uom" of GML there.
  static std::string unit_beside(OGRFeatureH feature, int field) {
    const std::string name = gdal().field_name(gdal().field(feature, field)) + std::string("_uom");
    const int unit = gdal().field_index(feature, name.c_str());
    if (unit < 0 || !gdal().is_field_set(feature, unit)) return "";
    const std::string word = unit_of(gdal().text(feature, unit));
    return word.empty() ? "" : ' ' + word;
  }

  // Where the height of a feature came from that became footprints.
  void count(OGRFeatureH feature, const BuildingHeight& height) {
    if (solid_ && height.from == HeightFrom::nothing) {
      ++out_.counts["heights_from_corners"];
      if (height.unread) out_.skipped.add("height that is not understood", which_);
      return;
    }
    count_height(height, which_, out_);
    if (height.from != HeightFrom::nothing) return;
    for (int i = 0; i < gdal().field_count(feature); ++i) {
      if (!gdal().is_field_set(feature, i)) continue;
      note_attribute(gdal().field_name(gdal().field(feature, i)), gdal().text(feature, i), out_);
    }
  }

  static OGRwkbGeometryType kind_of(OGRGeometryH geometry) {
    return gdal().flat_type(gdal().geometry_type(geometry));
  }

  static bool holds_surfaces(OGRGeometryH geometry) {
    const OGRwkbGeometryType kind = kind_of(geometry);
    return gdal().is_subclass(kind, wkbSurface) || gdal().is_subclass(kind, wkbMultiSurface) ||
           kind == wkbGeometryCollection;
  }

  // Every part of a geometry becomes footprints or is named as skipped.
  void add_polygons(OGRGeometryH geometry, std::uint64_t id, const BuildingHeight& height) {
    const OGRwkbGeometryType kind = kind_of(geometry);
    if (kind == wkbGeometryCollection) {
      for (int i = 0; i < gdal().part_count(geometry); ++i) {
        add_polygons(gdal().part_of(geometry, i), id, height);
      }
      return;
    }
    solid_ |= kind == wkbPolyhedralSurface || kind == wkbTIN;
    const GeometryHandle polygons(
        holds_surfaces(geometry)
            ? gdal().force_to_polygons(gdal().without_arcs(geometry, kDegreesOfArc, nullptr))
            : nullptr);
    if (!polygons || kind_of(polygons.get()) != wkbMultiPolygon) {
      out_.skipped.add(gdal().type_name(kind), which_);
      return;
    }
    const double gap = gap_of_chords(geometry);
    for (int i = 0; i < gdal().part_count(polygons.get()); ++i) {
      const OGRGeometryH polygon = gdal().part_of(polygons.get(), i);
      if (gdal().is_empty(polygon)) {
        out_.skipped.add("polygon without corners", which_);
        continue;
      }
      Footprint f;
      f.id = id;
      f.bottom = height.bottom;
      f.top = height.top;
      f.bulge = gap;
      std::vector<std::vector<Vec2>> outlines;
      for (int k = 0; k < gdal().part_count(polygon); ++k) {
        std::vector<Vec2> ring = points_of(gdal().part_of(polygon, k), f.id);
        const bool outline = k == 0 || (clockwise_outlines_ && is_clockwise(ring));
        (outline ? outlines : f.polygon.holes).push_back(std::move(ring));
      }
      const Levels levels = levels_of(polygon);
      for (std::vector<Vec2>& outline : outlines) {
        solid_ |= levels.low < levels.high && stands_upright(outline);
        f.polygon.outer = std::move(outline);
        levels_.push_back(levels);
        out_.footprints.push_back(f);
        f.polygon.holes.clear();  // they are in the first
      }
    }
  }

  static bool is_clockwise(const std::vector<Vec2>& ring) {
    double twice_area = 0;
    for (std::size_t i = 2; i < ring.size(); ++i) {
      const Vec2 a = ring[i - 1] - ring[0];
      const Vec2 b = ring[i] - ring[0];
      twice_area += a.x() * b.y() - a.y() * b.x();
    }
    return twice_area < 0;
  }

  // The heights that a polygon's own corners give.
  struct Levels {
    double low = 0;
    double high = 0;
  };
  Levels levels_of(OGRGeometryH polygon) const {
    OGREnvelope3D reach;
    gdal().envelope(polygon, &reach);
    if (!gdal().is_3d(polygon) || (reach.MinZ == 0 && reach.MaxZ == 0)) return {};
    if (!unit_) refuse_heights(name_, *out_.crs);
    const Levels levels{reach.MinZ * *unit_, reach.MaxZ * *unit_};
    if (!(std::abs(levels.low) <= 1e4 && std::abs(levels.high) <= 1e4)) {
      throw InputError(name_, {.item = std::string(which_),
                               .expected = "corners within 1e4 m of height 0",
                               .found = fmt::format("{} to {}", levels.low, levels.high)});
    }
    return levels;
  }

  // Whether all corners are on one line in plan, as those of a wall.
  static bool stands_upright(const std::vector<Vec2>& ring) {
    const auto far = std::max_element(ring.begin(), ring.end(), [&](const auto& a, const auto& b) {
      return (a - ring.front()).squaredNorm() < (b - ring.front()).squaredNorm();
    });
    const Vec2 along = *far - ring.front();
    return std::all_of(ring.begin(), ring.end(), [&](const Vec2& p) {
      const Vec2 to = p - ring.front();
      return std::abs(along.x() * to.y() - along.y() * to.x()) <= 1e-6 * along.squaredNorm();
    });
  }

  // Corners with heights. They may be the ground's, below the building's height, or the roof's: the
  // building stands from the lowest corner, or from where it stands without them, up to its height
  // above the highest. A solid, which has walls, is as high as its highest corner says; a height
  // that the file gives counts from its lowest.
  void raise(std::size_t first, const BuildingHeight& height) {
    Levels all = levels_.empty() ? Levels{} : levels_.front();
    for (const Levels& l : levels_) all = {std::min(all.low, l.low), std::max(all.high, l.high)};
    const bool given = height.from != HeightFrom::nothing;
    solid_ &= all.low < all.high;
    for (std::size_t i = 0; i < levels_.size() && (all.low != 0 || all.high != 0); ++i) {
      Footprint& f = out_.footprints[first + i];
      const double above = solid_ ? all.low : levels_[i].high;
      ++out_.counts["polygons_with_heights"];
      f.bottom = std::min({f.bottom, f.bottom + all.low, all.low});
      if (solid_ && !given) {
        f.bottom = std::min(all.low, 0.0);
        f.top = levels_[i].high;
      } else {
        f.top = std::max({f.top, above + f.top, levels_[i].high});
      }
      f.top = std::max(f.top, f.bottom);
    }
    levels_.clear();
  }

  std::vector<Vec2> points_of(OGRGeometryH ring, std::uint64_t id) const {
    std::vector<Vec2> points(static_cast<std::size_t>(gdal().point_count(ring)));
    if (points.empty()) return points;
    constexpr int kStride = sizeof(Vec2);
    gdal().points(ring, &points[0].x(), kStride, &points[0].y(), kStride, nullptr, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].allFinite()) continue;
      throw InputError(name_, {.item = fmt::format("feature {}", id),
                               .says = fmt::format("point {} is not finite", i)});
    }
    return points;
  }

  const std::string& name_;
  const ReadOptions& options_;
  std::size_t features_ = 0;
  bool clockwise_outlines_ = false;  // a ring that turns so is the outline of something solid
  std::optional<double> unit_;       // of heights that name none, where it is clear
  OGRLayerH handle_ = nullptr;       // of the layer
  std::string layer_;
  std::map<std::string, std::vector<int>, std::less<>> fields_;  // of the layer, by what they tell
  std::string which_;                                            // the feature that is read
  std::vector<Levels> levels_;                                   // of its footprints
  bool solid_ = false;  // it has walls, so its corners tell how high it is
  Source out_;
};

}  // namespace

Source read_vector(const std::string& path, const std::string& name, const ReadOptions& options) {
  require_plain_vector(path, name);
  const std::unique_ptr<GmlInMemory> gml = GmlInMemory::of(path, name);
  Skipped links;
  const GmlTold told = gml ? told_by_gml(gml->text(), name, links) : GmlTold();
  gdal().forget_errors();
  const DatasetHandle dataset = opened(gml ? gml->path() : path, GDAL_OF_VECTOR);
  if (!dataset) throw InputError(name, unopened(path));
  require_known_references(dataset, path, told, name);
  if (gml) require_whole_gml(dataset, told, name);
  Source source = VectorReader(name, options).read(dataset, path);
  source.beside = files_beside(dataset, path);
  source.skipped.add(links);
  return source;
}

}  // namespace geom::gis
