#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "gdal_reference.h"
#include "gdal_whole.h"
#include "geom/gis/footprint_source.h"
#include "geom/text/counted.h"
#include "gml_unfollowed.h"
#include "xml_heads.h"

namespace geom::gis {
namespace {

constexpr double kDegreesOfArc = 0.5;  // its chord lies 1e-5 of the radius within the arc

class VectorReader {
 public:
  VectorReader(const std::string& name, const ReadOptions& options)
      : name_(name), options_(options) {}

  Source read(GDALDataset& dataset, const std::string& path) {
    const std::size_t least = require_whole(dataset, path, name_);
    for (int i = 0; i < dataset.GetLayerCount(); ++i) {
      OGRLayer& layer = *dataset.GetLayer(i);
      const std::string crs = wkt_of(layer.GetSpatialRef(), name_);
      if (i > 0 && crs != out_.crs) {
        throw InputError(name_, {.expected = "one coordinate reference system in all layers",
                                 .found = fmt::format("another in layer \"{}\"", layer.GetName())});
      }
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
  void read_layer(OGRLayer& layer) {
    CPLErrorReset();
    layer_ = layer.GetName();
    out_.has_height_attribute |=
        layer.GetLayerDefn()->GetFieldIndex(options_.height.attribute.c_str()) >= 0;
    if (!options_.where.empty() &&
        layer.SetAttributeFilter(options_.where.c_str()) != OGRERR_NONE) {
      throw InputError(
          name_,
          {.item = "--where",
           .expected = fmt::format("a condition on attributes of layer \"{}\"", layer.GetName()),
           .found = fmt::format("\"{}\" (GDAL: {})", options_.where, CPLGetLastErrorMsg())});
    }
    layer.ResetReading();
    while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
      ++features_;
      read_feature(*feature);
    }
    if (CPLGetLastErrorType() == CE_Failure) {
      throw InputError(name_,
                       {.says = fmt::format("layer \"{}\" cannot be read to its end (GDAL: {})",
                                            layer.GetName(), CPLGetLastErrorMsg()),
                        .advice = "the file is damaged or cut, get it again"});
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
      if (field < 0 || !feature.IsFieldSetAndNotNull(field)) return "";
      if (feature.GetFieldDefnRef(field)->GetSubType() == OFSTBoolean) {
        return feature.GetFieldAsInteger(field) ? "true" : "false";  // no length of 1
      }
      return feature.GetFieldAsString(field);
    };
    const std::size_t before = out_.footprints.size();
    BuildingHeight height;
    if (holds_surfaces(*geometry)) {
      HeightOptions options = options_.height;
      options.unit = unit_.value_or(1);
      height = building_height(tag, options);
      if (height.bare && !unit_) refuse_heights(name_, out_.crs);
    }
    add_polygons(*geometry, static_cast<std::uint64_t>(feature.GetFID()), height);
    raise(before, height);
    if (out_.footprints.size() > before) count(feature, height);
    solid_ = false;
  }

  // Where the height of a feature came from that became footprints.
  void count(const OGRFeature& feature, const BuildingHeight& height) {
    if (solid_ && height.from == HeightFrom::nothing) {
      ++out_.counts["heights_from_corners"];
      if (height.unread) out_.skipped.add("height that is not understood", which_);
      return;
    }
    count_height(height, which_, out_);
    if (height.from != HeightFrom::nothing) return;
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
  void add_polygons(const OGRGeometry& geometry, std::uint64_t id, const BuildingHeight& height) {
    if (wkbFlatten(geometry.getGeometryType()) == wkbGeometryCollection) {
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
        add_polygons(*part, id, height);
      }
      return;
    }
    const auto kind = wkbFlatten(geometry.getGeometryType());
    solid_ |= kind == wkbPolyhedralSurface || kind == wkbTIN;
    const std::unique_ptr<OGRGeometry> polygons(
        holds_surfaces(geometry)
            ? OGRGeometryFactory::forceToMultiPolygon(geometry.getLinearGeometry(kDegreesOfArc))
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
      Footprint f;
      f.id = id;
      f.bottom = height.bottom;
      f.top = height.top;
      for (const OGRLinearRing* ring : *polygon) {
        (ring == polygon->getExteriorRing() ? f.polygon.outer : f.polygon.holes.emplace_back()) =
            points_of(*ring, f.id);
      }
      levels_.push_back(levels_of(*polygon));
      solid_ |= levels_.back().low < levels_.back().high && stands_upright(f.polygon.outer);
      out_.footprints.push_back(std::move(f));
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

  std::vector<Vec2> points_of(const OGRLinearRing& ring, std::uint64_t id) const {
    std::vector<Vec2> points;
    for (int i = 0; i < ring.getNumPoints(); ++i) {
      points.push_back({ring.getX(i), ring.getY(i)});
      if (!points.back().allFinite()) {
        throw InputError(name_, {.item = fmt::format("feature {}", id),
                                 .says = fmt::format("point {} is not finite", i)});
      }
    }
    return points;
  }

  const std::string& name_;
  const ReadOptions& options_;
  std::size_t features_ = 0;
  std::optional<double> unit_;  // of heights that name none, where it is clear
  std::string layer_;
  std::string which_;           // the feature that is read
  std::vector<Levels> levels_;  // of its footprints
  bool solid_ = false;          // it has walls, so its corners tell how high it is
  Source out_;
};

// What a gzip archive holds; empty for another file.
std::string unpacked(const std::string& path) {
  char magic[2] = {};
  std::ifstream(path, std::ios::binary).read(magic, 2);
  if (std::string_view(magic, 2) != "\x1f\x8b") return "";
  GByte* bytes = nullptr;
  vsi_l_offset size = 0;
  std::string out;
  if (VSIIngestFile(nullptr, ("/vsigzip/" + path).c_str(), &bytes, &size, -1)) {
    out.assign(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  }
  VSIFree(bytes);
  return out;
}

}  // namespace

Source read_vector(const std::string& path, const std::string& name, const ReadOptions& options) {
  require_plain_vector(path, name);
  const Dataset dataset = open(path, GDAL_OF_VECTOR);
  if (!dataset) {
    throw InputError(name, unopened(path));
  }
  Source source = VectorReader(name, options).read(*dataset, path);
  source.beside = files_beside(*dataset, path);
  if (dataset->GetDriver() && EQUAL(dataset->GetDriver()->GetDescription(), "GML")) {
    std::istringstream packed(unpacked(path));
    std::ifstream plain(path, std::ios::binary);
    const bool is_packed = packed.peek() != std::istringstream::traits_type::eof();
    skip_unfollowed(is_packed ? static_cast<std::istream&>(packed) : plain, name, source.skipped);
  }
  return source;
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
  throw InputError(
      name,
      {.says = fmt::format(
           "the file has coordinates in units of {} m, and does not say the unit of its heights",
           unit),
       .advice = "give --height-units m, ft or us-ft"});
}

}  // namespace geom::gis
