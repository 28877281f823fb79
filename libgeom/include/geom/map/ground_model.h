#pragma once

// The ground of a map: the least and the greatest height of the terrain over each cell of a grid.
//
// Example:
//   const geom::GroundModel flat = geom::GroundModel::flat(12);
//   assert(flat.range({{0, 0}, {50, 50}}).low == 12);
//   geom::GroundModel hill({.corner = {0, 0}, .cell = 10, .columns = 2, .rows = 1}, {5, 7}, {6,
//   9}); assert(hill.range({{0, 0}, {20, 10}}).high == 9); assert(!hill.range({{0, 0}, {21,
//   10}}).all_known);  // beyond the grid

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geom/map/frame.h"
#include "geom/shape/cover.h"

namespace geom {

// The grid lies along the map's axes: cell (i, j) is the closed square of side `cell` whose lower
// corner is corner + cell * (i, j). Its numbers stand at j * columns + i.
struct GroundGridSpec {
  Frame frame;  // that of the map
  Vec2 corner = Vec2::Zero();
  double cell = 10;  // metres, > 0
  std::size_t columns = 0;
  std::size_t rows = 0;
  // Metres that the true ground may be above or below what the source says.
  double error = 0;
  std::string source;  // a file's name
  std::string hash;    // and its hash, "sha256:…"
};

// Of a region: `low` and `high` bound the ground, with its error, where it is known.
struct GroundRange {
  double low = 0;
  double high = 0;
  bool any_known = false;
  bool all_known = false;

  // Whether the ground is known and within `step` metres, but for its error.
  bool level(double step, double error) const { return all_known && high - low <= step + 2 * error; }
};

// Immutable. Every point of the ground over a cell, and within a millionth of its side around it,
// has a height (the map's z) between the cell's two, give or take the error. A cell whose numbers
// are NaN is a hole.
class GroundModel {
 public:
  // Flat ground everywhere.
  static GroundModel flat(double z);

  // Precondition: as many numbers as cells, low <= high or both NaN.
  GroundModel(GroundGridSpec spec, std::vector<double> low, std::vector<double> high);

  const GroundGridSpec& spec() const { return spec_; }
  bool is_flat() const { return flat_.has_value(); }

  // Of the cells that hold the closed rectangle. Cost: their number.
  GroundRange range(const Rectangle& region) const;

  // The region in two, along the face of cells that is nearest to its middle; nothing where no face
  // of cells runs through it.
  std::optional<std::pair<Rectangle, Rectangle>> cut(const Rectangle& region) const;

  std::span<const double> lows() const { return low_; }
  std::span<const double> highs() const { return high_; }

 private:
  explicit GroundModel(double z) : flat_(z) {}

  long first_cell(double at, int axis) const;  // of those that hold a range from here up
  long last_cell(double at, int axis) const;
  double face(long cell, int axis) const {
    return spec_.corner[axis] + spec_.cell * static_cast<double>(cell);
  }

  std::optional<double> flat_;
  GroundGridSpec spec_;
  std::vector<double> low_;
  std::vector<double> high_;
};

// The file of a ground, a ZIP of NumPy arrays (docs/formats.md). Equal content gives equal bytes.
void write_ground(std::ostream& out, const GroundModel& ground);

// Throws InputError where it is no such file, or damaged.
GroundModel read_ground(const std::string& path);

// Throws InputError(source, …) where the frame is another than the map's.
void require_same_frame(const GroundModel& ground, const Frame& frame, const std::string& source);

}  // namespace geom
