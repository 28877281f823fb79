#include "geom/map/ground_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "cell_index.h"
#include "cell_tiles.h"
#include "geom/base/precondition.h"

namespace geom {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kSeedArea = 100;  // square metres that hold together at a seed, or more
constexpr double kMostEdge = 0.2;  // share of the edge of ground that may be a step down
constexpr std::size_t kFirm = 5;   // of its eight neighbours that a cell holds together with
constexpr int kBeside = 3;         // cells that are looked at beyond an edge: over a parapet
constexpr std::array<std::pair<int, int>, 4> kSides{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

struct Cell {
  double lowest = kNone;  // of its returns
  double bare = kNone;    // the same, lowered to what the slope allows
  double top = -kNone;    // what is no higher is ground
  std::uint32_t surface = 0;
};

// Joined cells without a step between them.
struct Surface {
  std::size_t cells = 0;
  std::size_t edges = 0;       // sides of its cells beyond which something else was scanned
  std::size_t steps_down = 0;  // of these, those with something lower beside them
  bool seeded = false;

  // Few steps down for cells of this number: a square of them has four sides of the root.
  bool is_ground() const {
    const double edge =
        std::max(static_cast<double>(edges), 4 * std::sqrt(static_cast<double>(cells)));
    return seeded && static_cast<double>(steps_down) <= kMostEdge * edge;
  }
};

struct Place {
  double z;
  std::int32_t x;
  std::int32_t y;
  friend bool operator>(const Place& a, const Place& b) { return a.z > b.z; }
};

}  // namespace

struct GroundGrid::Impl {
  double allowed(int dx, int dy) const { return spec.slope * spec.cell * std::hypot(dx, dy); }
  Cell& at(const Vec3& p) { return cells.at(index.floor(p.x()), index.floor(p.y())); }
  const Cell* find(const Vec3& p) const {
    return cells.find(index.floor(p.x()), index.floor(p.y()));
  }
  // The cell there, where it has returns.
  const Cell* scanned(std::int64_t x, std::int64_t y) const {
    if (std::max(std::abs(x), std::abs(y)) >= 0x7FFFFFFF) return nullptr;
    const Cell* const cell = cells.find(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
    return cell && cell->lowest < kNone ? cell : nullptr;
  }
  double bare(std::int32_t x, std::int32_t y) const {
    const Cell* const cell = cells.find(x, y);
    return cell ? cell->bare : kNone;
  }

  std::vector<Place> places() const;
  void lower(const std::vector<Place>& all);
  void set_tops(const std::vector<Place>& all);
  void join_surfaces(const std::vector<Place>& all);
  void grow(const Place& from, std::uint32_t surface);
  void look_beside(const Place& p);
  void find_seeds(const std::vector<Place>& all);

  GroundSpec spec;
  CellIndex index;
  CellTiles<Cell> cells;
  std::vector<Surface> surfaces;  // by number; the first is none
};

// The cells with returns, and the lowest of each.
std::vector<Place> GroundGrid::Impl::places() const {
  constexpr int kSide = CellTiles<Cell>::kSide;
  std::vector<Place> out;
  for (const auto* tile : cells.sorted()) {
    for (int i = 0; i < kSide * kSide; ++i) {
      const double z = tile->cells[static_cast<std::size_t>(i)].lowest;
      if (z < kNone) out.push_back({z, tile->x * kSide + i % kSide, tile->y * kSide + i / kSide});
    }
  }
  return out;
}

// Dijkstra's order: the lowest cell first, so each is lowered once.
void GroundGrid::Impl::lower(const std::vector<Place>& all) {
  for (const Place& p : all) cells.at(p.x, p.y).bare = p.z;
  std::priority_queue<Place, std::vector<Place>, std::greater<>> open(std::greater<>(), all);
  while (!open.empty()) {
    const auto [z, x, y] = open.top();
    open.pop();
    if (z > bare(x, y)) continue;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const double next = bare(x + dx, y + dy);
        const double highest = z + allowed(dx, dy);
        if (next == kNone || highest >= next) continue;
        cells.at(x + dx, y + dy).bare = highest;
        open.push({highest, x + dx, y + dy});
      }
    }
  }
}

// Within its cell the ground may rise as it does to the neighbours.
void GroundGrid::Impl::set_tops(const std::vector<Place>& all) {
  for (const Place& p : all) {
    Cell& cell = cells.at(p.x, p.y);
    if (!surfaces[cell.surface].is_ground()) continue;
    double rise = 0;
    for (const auto& [dx, dy] : kSides) {
      const double next = bare(p.x + dx, p.y + dy);
      if (next < kNone) rise = std::max(rise, std::abs(next - cell.bare));
    }
    cell.top = cell.bare + rise + spec.height;
  }
}

void GroundGrid::Impl::join_surfaces(const std::vector<Place>& all) {
  surfaces.assign(1, {});
  for (const Place& p : all) {
    if (cells.at(p.x, p.y).surface != 0) continue;
    surfaces.push_back({});
    grow(p, static_cast<std::uint32_t>(surfaces.size() - 1));
  }
}

// From cell to cell until a step. A cell leads on where it holds together with most around it, so
// that a lone chain of cells, as a stair or a hedge, leads to no roof.
void GroundGrid::Impl::grow(const Place& from, std::uint32_t surface) {
  cells.at(from.x, from.y).surface = surface;
  std::vector<Place> open{from};
  std::vector<Place> joined;
  while (!open.empty()) {
    const Place p = open.back();
    open.pop_back();
    ++surfaces[surface].cells;
    joined.clear();
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell* const next = scanned(std::int64_t{p.x} + dx, std::int64_t{p.y} + dy);
        if (!next || std::abs(next->lowest - p.z) > allowed(dx, dy) + spec.step) continue;
        joined.push_back({next->lowest, p.x + dx, p.y + dy});
      }
    }
    if (joined.size() < kFirm + 1) continue;  // the cell itself is one of them
    for (const Place& next : joined) {
      Cell& cell = cells.at(next.x, next.y);
      if (cell.surface != 0) continue;
      cell.surface = surface;
      open.push_back(next);
    }
  }
}

// What stands beside the cell, on the four sides where its surface ends.
void GroundGrid::Impl::look_beside(const Place& p) {
  const std::uint32_t own = cells.at(p.x, p.y).surface;
  for (const auto& [dx, dy] : kSides) {
    bool found = false;
    bool lower = false;
    for (int i = 1; i <= kBeside; ++i) {
      const Cell* const beside = scanned(std::int64_t{p.x} + i * dx, std::int64_t{p.y} + i * dy);
      if (!beside) continue;
      if (beside->surface == own) break;
      found = true;
      lower |= beside->lowest < p.z - allowed(i, 0) - spec.step;
    }
    surfaces[own].edges += found;
    surfaces[own].steps_down += found && lower;
  }
}

// Squares of side `widest`: the lowest of one is a seed where none around it has a lower one. What
// is larger than such a square is one, too.
void GroundGrid::Impl::find_seeds(const std::vector<Place>& all) {
  const double enough =
      std::min(kSeedArea / (spec.cell * spec.cell), 0.25 * static_cast<double>(all.size()));
  const auto side =
      static_cast<std::int32_t>(std::clamp(std::ceil(spec.widest / spec.cell), 1.0, 0x1p24));
  const auto square = [&](std::int32_t cell) {  // rounded down
    return cell >= 0 ? cell / side : -((-(static_cast<std::int64_t>(cell) + 1)) / side) - 1;
  };
  struct Lowest {
    double z = kNone;
    std::uint32_t surface = 0;
    std::int32_t x = 0;
    std::int32_t y = 0;
  };
  const double square_cells = spec.widest * spec.widest / (spec.cell * spec.cell);
  for (Surface& s : surfaces) s.seeded = static_cast<double>(s.cells) >= square_cells;
  CellTiles<Lowest> squares;
  std::vector<std::pair<std::int32_t, std::int32_t>> known;
  for (const Place& p : all) {
    const std::uint32_t surface = cells.at(p.x, p.y).surface;
    if (static_cast<double>(surfaces[surface].cells) < enough) continue;
    const auto x = static_cast<std::int32_t>(square(p.x));
    const auto y = static_cast<std::int32_t>(square(p.y));
    Lowest& lowest = squares.at(x, y);
    if (lowest.z == kNone) known.emplace_back(x, y);
    if (p.z < lowest.z) lowest = {p.z, surface, x, y};
  }
  for (const auto& [x, y] : known) {
    const Lowest& here = *squares.find(x, y);
    bool lowest = true;
    for (int i = 0; i < 9; ++i) {
      const Lowest* const there = squares.find(x + i % 3 - 1, y + i / 3 - 1);
      lowest &= !there || there->z >= here.z;
    }
    if (lowest) surfaces[here.surface].seeded = true;
  }
}

GroundGrid::GroundGrid(const GroundSpec& spec)
    : impl_(std::make_unique<Impl>(Impl{spec, CellIndex(spec.cell), {}, {}})) {
  require_size("ground cell", spec.cell);
  require_length("ground slope", spec.slope, kLargestCoordinate);
  require_length("ground height", spec.height, kLargestCoordinate);
  require_length("ground step", spec.step, kLargestCoordinate);
  require_size("ground widest", spec.widest);
}
GroundGrid::~GroundGrid() = default;
GroundGrid::GroundGrid(GroundGrid&&) noexcept = default;

void GroundGrid::add(const Vec3& p) {
  Cell& cell = impl_->at(p);
  cell.lowest = std::min(cell.lowest, p.z());
}

void GroundGrid::finish() {
  const std::vector<Place> all = impl_->places();
  impl_->join_surfaces(all);
  for (const Place& p : all) impl_->look_beside(p);
  impl_->find_seeds(all);
  impl_->lower(all);
  impl_->set_tops(all);
}

bool GroundGrid::is_ground(const Vec3& p) const {
  const Cell* cell = impl_->find(p);
  return cell && p.z() <= cell->top;
}

}  // namespace geom
