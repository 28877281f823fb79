#include "traj/tube/prove_tube.h"

#include <algorithm>
#include <cassert>

#include "geom/base/parallel.h"
#include "tube/prove_cell.h"

namespace traj {
namespace {

TubeCell whole(const Disturbances& d, bool by_spans) {
  return {d.wind, d.wind_spread, Vec3::Zero(), 1 - d.mass_error, 1 + d.mass_error, {}, by_spans};
}

// Whether some wind of the box is allowed.
bool meets(const TubeCell& cell, const Disturbances& d) {
  const Vec3 beyond = ((cell.wind - d.wind).cwiseAbs() - cell.wind_half).cwiseMax(0);
  return beyond.norm() <= d.wind_spread * (1 + 1e-12);
}

// Halves the masses, and the winds along each axis.
std::vector<TubeCell> parts(const TubeCell& cell, const Disturbances& d) {
  const Vec3 half = cell.wind_radius > 0 ? Vec3::Constant(cell.wind_radius) : cell.wind_half;
  const double middle = 0.5 * (cell.mass_least + cell.mass_most);
  std::vector<TubeCell> out;
  for (int k = 0; k < 16; ++k) {
    TubeCell part = cell;
    part.wind_radius = 0;
    part.wind_half = 0.5 * half;
    part.part.push_back(k);
    for (int i = 0; i < 3; ++i) part.wind[i] += (k >> i & 1 ? 0.5 : -0.5) * half[i];
    (k & 8 ? part.mass_least : part.mass_most) = middle;
    const bool same_wind = half.isZero() && (k & 7);
    const bool same_mass = d.mass_error == 0 && (k & 8);
    if (!same_wind && !same_mass && meets(part, d)) out.push_back(part);
  }
  return out;
}

void add(ProvedTube& tube, const TubeCell& part, CellTube&& cell) {
  tube.radius.resize(cell.radius.size(), 0);
  for (std::size_t k = 0; k < cell.radius.size(); ++k) {
    tube.radius[k] = std::max(tube.radius[k], cell.radius[k]);
  }
  tube.damping = std::min(tube.damping, cell.damping);
  tube.tilt = std::max(tube.tilt, cell.tilt);
  ++tube.cells;
  tube.proofs.push_back({part.part, std::move(cell.spans)});
}

// The middle alone: if its gusts are too much, no smaller cells help.
TubeCell middle_of(TubeCell cell) {
  cell.wind_radius = 0;
  cell.mass_least = cell.mass_most = 0.5 * (cell.mass_least + cell.mass_most);
  return cell;
}

}  // namespace

ProvedTube prove_tube(const ReferenceTrack& track, const FlightOptions& options,
                      const Disturbances& d, const geom::Execution& run, const TubeOptions& tube) {
  assert(options.hover >= kStep && options.periods.attitude >= 1 && options.periods.attitude <= 4);
  ProvedTube out;
  const bool cascade = options.law == ControlLaw::cascade;
  const auto prove = cascade ? prove_cascade_cell : prove_cell;
  std::vector<TubeCell> cells = {whole(d, tube.by_spans)};
  bool first = true;
  while (!cells.empty()) {
    std::vector<CellTube> proved(cells.size());
    geom::parallel_for(cells.size(), run,
                       [&](std::size_t i) { proved[i] = prove(track, options, d, cells[i]); });
    std::vector<TubeCell> next;
    std::optional<TubeTrouble> trouble;
    bool divisible = true;  // no failed cell that cannot be halved
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!proved[i].trouble) {
        add(out, cells[i], std::move(proved[i]));
        continue;
      }
      if (!trouble) trouble = proved[i].trouble;
      const std::vector<TubeCell> halves = parts(cells[i], d);
      next.insert(next.end(), halves.begin(), halves.end());
      if (halves.size() < 2 || proved[i].trouble->kind == TubeTrouble::Kind::unstable) {
        divisible = false;
      }
    }
    if (trouble && first && divisible) {
      const CellTube middle = prove(track, options, d, middle_of(cells.front()));
      if (middle.trouble) trouble = middle.trouble, divisible = false;
    }
    first = false;
    if (trouble && (!divisible || out.cells + next.size() > tube.most_cells)) {
      out.trouble = trouble;
      out.damping = std::min(out.damping, proved.front().damping);
      out.radius.clear();
      out.proofs.clear();
      return out;
    }
    cells = std::move(next);
  }
  out.largest = *std::max_element(out.radius.begin(), out.radius.end());
  return out;
}

}  // namespace traj
