#pragma once

// Readers of footprints and terrain, in the coordinates of their source.
//
// Example:
//   geom::gis::Source source =
//       geom::gis::read_vector("blocks.geojson", "blocks.geojson", geom::gis::ReadOptions{});
//   const geom::gis::Projector projector(source, "blocks.geojson", std::nullopt, false);
//   std::cout << source.footprints.size() << " footprints, " << source.skipped.text() << '\n';

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/base/skipped.h"
#include "geom/earth/proj_way.h"
#include "geom/gis/axis_order.h"
#include "geom/import/building_height.h"
#include "geom/map/footprint.h"
#include "geom/text/words.h"

namespace geom::gis {

// An attribute whose values are numbers: one such may be the height that nobody named.
struct NumericAttribute {
  std::size_t features = 0;  // that have it
  double low = 0;
  double high = 0;
};

// Where the cells of a height model are.
struct CellGrid {
  struct Cells {  // [first_column, last_column) x [first_row, last_row)
    int first_column;
    int last_column;
    int first_row;
    int last_row;
  };
  double transform[6];    // GDAL's, from columns and rows to coordinates
  std::vector<Cells> of;  // of each footprint, by its id

  Vec2 corner(double column, double row) const {
    return {transform[0] + column * transform[1] + row * transform[2],
            transform[3] + column * transform[4] + row * transform[5]};
  }
  // Calls f(corner) for all corners of cells along the sides, from that of the first column and row
  // on.
  template <class F>
  void for_each_corner(const Cells& cells, const F& f) const {
    for (int i = cells.first_column; i < cells.last_column; ++i) f(corner(i, cells.first_row));
    for (int j = cells.first_row; j < cells.last_row; ++j) f(corner(cells.last_column, j));
    for (int i = cells.last_column; i > cells.first_column; --i) f(corner(i, cells.last_row));
    for (int j = cells.last_row; j > cells.first_row; --j) f(corner(cells.first_column, j));
  }
};

struct Source {
  using Warnings = std::vector<std::string>;

  std::vector<Footprint> footprints;
  std::optional<CellGrid> grid;               // of a height model with a CRS
  std::optional<ProjReference> crs;           // none: local metres
  std::map<std::string, std::size_t> counts;  // for the report: "heights from levels", …
  Skipped skipped;                            // what is or may be an obstacle and is no footprint
  Skipped defaults;                           // built as high as the default, as nothing tells
  bool has_height_attribute = false;          // that of the options was there
  std::map<std::string, NumericAttribute> numeric;  // of the features without a height
  std::map<std::string, std::uint32_t>
      labels;  // those of the footprints with their numbers, from 1
  std::map<std::string, std::size_t> left_out;  // what is not built by its type: how many
  std::optional<double>
      left_out_rise;  // where that is so by default: metres above the lowest ground
  Warnings warnings;
  std::vector<std::string> beside;  // paths of files that were read with that which was named
};

// What the labels of boxes say: "Building", or "Building: BAG.123" where the file has such names.
enum class LabelBy { type, object };
inline constexpr Words<LabelBy, 2> kLabelWords{
    {{LabelBy::type, "type"}, {LabelBy::object, "object"}}};

struct ReadOptions {
  HeightOptions height;
  // Of city models and OpenStreetMap data: the types that are built; all else is left out. Empty:
  // all but roads, land use and the like that lie on the ground.
  std::vector<std::string> types;
  LabelBy label_by = LabelBy::type;
  Axes axes = Axes::as_named;         // of city models
  std::string where;                  // OGR SQL on attributes; empty: all features
  std::optional<double> height_unit;  // metres in one of the heights that name no unit
  double slack = 0.5;                 // metres that boxes will be allowed to reach outside
  std::optional<Vec2> origin;         // of the map: latitude, longitude; else the middle
  double height_step = 0.5;  // metres: surface models are rounded up to multiples of it; 0: not
};

// Counts where the height of a building came from. `which` names the building where its height is
// not understood, or is the default. A tower, mast, chimney or crane may be of any height: where
// nothing tells, it counts as skipped, too.
void count_height(const BuildingHeight& height, const std::string& which, Source& source);

// Throws InputError(name, …) where --height-attribute names one that nothing in the file has.
void require_attribute(const Source& source, const ReadOptions& options, const std::string& name);

// The number of the label of an object of this type and name, which is added where it is new.
std::uint32_t label_of(const std::string& type, const std::string& object,
                       const ReadOptions& options, Source& source);

// Throws InputError(name, …) where one of the types of the options is none of the file's, which are
// given with how many objects are of each.
void require_types(const std::map<std::string, std::size_t>& types, const ReadOptions& options,
                   const std::string& name);

// Notes an attribute of a feature without a height, where its value is a number.
void note_attribute(const std::string& name, const std::string& value, Source& source);

// Why a source is refused where more than a tenth of its buildings have no height but the default,
// which nobody has chosen: names the attributes that may be heights. Else empty.
std::string heights_fault(const Source& source);

// Metres in a unit of heights that name none, in a source of this CRS: what the options say, or the
// CRS's own vertical part, or 1 where the CRS counts metres or degrees, or there is none. Nothing
// where it counts something else, as heights may then too. Throws InputError(name, …) for depths.
std::optional<double> height_unit(const std::optional<ProjReference>& crs, const std::string& name,
                                  const ReadOptions& options);

// The refusal where height_unit() is nothing and a height is needed.
[[noreturn]] void refuse_heights(const std::string& name, const ProjReference& crs);

// GeoJSON, GeoPackage, Shapefile, FlatGeobuf, SQLite, KML, GML or CSV with WKT. `path` may
// be one of GDAL's virtual files; `name` is for messages. Throws InputError.
Source read_vector(const std::string& path, const std::string& name, const ReadOptions& options);

// Whether GDAL reads the file as a raster. Throws InputError for one that has layers of features,
// too.
bool is_raster(const std::string& path);

// A surface or terrain model of one band: rectangles of cells, from the lowest cell up, that
// together hold what the cells hold and no more; those that pass below higher cells overlap others.
// Where there is a CRS, `grid` knows the corners of cells along their sides, since straight lines
// bend when projected.
Source read_raster(const std::string& path, const std::string& name, const ReadOptions& options);

// OpenStreetMap data: ways and multipolygons that are buildings, building parts, or towers, masts,
// chimneys, silos and the like; multipolygons assembled. Those that are points or lines are
// skipped, and so are outlines of which a part is not in the file, and other obstacles
// (osm_obstacle.h).
Source read_osm(const std::string& path, const std::string& name, const ReadOptions& options);

// How far one step from cell to cell of a height model leads off the nearer of the map's axes,
// metres: the most of nine places all over it. Infinity where PROJ converts one of them to nothing.
// An estimate, for speed: between those places it may be more.
struct CellLean {
  double column = 0;
  double row = 0;
};
CellLean lean_of(const CellGrid& grid, int width, int height,
                 const std::optional<ProjReference>& crs, const std::optional<Vec2>& origin);

// The ground under a place, from a terrain model.
class Terrain {
 public:
  Terrain(const std::string& path, const std::string& name, const ReadOptions& options);

  struct Range {
    double low;
    double high;
    bool whole = true;  // no cell under the region is unknown or outside of the raster
  };
  // Over the cells that the rectangle touches, and their neighbours, as far as they have a height;
  // nothing where none has. `way`: from the raster's own system to that of the rectangle, where
  // these differ.
  std::optional<Range> range(const Vec2& low, const Vec2& high,
                             const std::optional<ProjWay>& way) const;

  // Of the surface within the rectangle around these points (x and y in the raster's own system),
  // whether a cell has its height all over or its middle alone, with straight slopes between.
  // Nothing where it is not known all over.
  std::optional<Range> surface(std::span<const Vec2> around) const;

  const std::optional<ProjReference>& crs() const { return crs_; }
  const std::string& name() const { return name_; }  // for messages

 private:
  using Cells = CellGrid::Cells;

  double at(int column, int row) const;
  bool known(const Cells& cells) const;  // none is outside or without data
  // Of a rectangle in columns and rows.
  std::optional<Range> over_cells(const Vec2& low, const Vec2& high) const;

  std::string name_;
  std::optional<ProjReference> crs_;
  double transform_[6];
  int width_ = 0;
  int height_ = 0;
  std::vector<double> cells_;  // NaN where there is no data
};

// From the source's coordinates to metres east and north of an origin.
class Projector {
 public:
  // Without a CRS coordinates are metres already and stay; `origin` is then where (0, 0) is.
  // `origin`: latitude, longitude; else the middle of the footprints. Throws InputError(name,
  // …) for a CRS from which PROJ knows no way, for an origin too far from the footprints (and warns
  // of one that is far), and, unless `metres` insists, for numbers without a CRS that look like
  // degrees.
  Projector(Source& source, const std::string& name, const std::optional<Vec2>& origin,
            bool metres);

  // Many at once cost less than each, and those that are the same bit for bit cost one.
  void convert(std::vector<Vec2>& points) const;
  const Frame& frame() const { return frame_; }

  // How much x grows once around the Earth, where it is a longitude; else 0.
  double turn() const { return turn_; }

 private:
  std::string name_;
  Frame frame_;
  double turn_ = 0;
  std::optional<ProjWay> way_;
};

}  // namespace geom::gis
