#include <algorithm>

#include "tube/prove_cell.h"

namespace traj {
namespace {

constexpr double kRoom = 1.06;  // of the bounds of spans, for checkers that sum otherwise
constexpr double kLeastBound = 1e-8;
constexpr int kPasses = 6;

std::vector<SpanBounds> widened(std::vector<SpanBounds> bounds) {
  for (SpanBounds& span : bounds) {
    for (double& bound : span) bound = kRoom * std::max(bound, kLeastBound);
  }
  return bounds;
}

// Raises bounds that leave no room; whether there were any.
bool raise_bounds(std::vector<SpanBounds>& bounds, const std::vector<SpanBounds>& found) {
  bool raised = false;
  const std::vector<SpanBounds> needed = widened(found);
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    for (std::size_t i = 0; i < bounds[k].size(); ++i) {
      if (needed[k][i] <= bounds[k][i]) continue;
      bounds[k][i] = 1.02 * needed[k][i];
      raised = true;
    }
  }
  return raised;
}

}  // namespace

CellTube prove_by_spans(const ReferenceTrack& track, const FlightOptions& options,
                        const Disturbances& disturbances, const TubeCell& cell) {
  CellTube found = prove_cell(track, options, disturbances, cell);
  TubeCell taken = cell;
  taken.bounds = widened(widened(found.bounds));
  for (int pass = 0; pass < kPasses && !found.trouble; ++pass) {
    found = prove_cell(track, options, disturbances, taken);
    if (found.trouble || raise_bounds(taken.bounds, found.bounds)) continue;
    found.bounds = std::move(taken.bounds);
    return found;
  }
  if (!found.trouble) found.trouble = TubeTrouble{TubeTrouble::Kind::bounds, 0, 0, 0};
  return found;
}

}  // namespace traj
