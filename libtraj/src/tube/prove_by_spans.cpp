#include <algorithm>

#include "tube/prove_cell.h"

namespace traj {
namespace {

// Bounds of spans are larger than those of periods, so the remainders are, and so the deviations:
// larger bounds have to be taken until they hold. They must leave room for checkers that sum
// otherwise.
constexpr double kLeastRoom = 1.03;
constexpr double kRoom = 1.045;
constexpr double kLeastBound = 1e-8;
constexpr int kPasses = 8;
constexpr double kMostGrowth = 5;  // larger bounds than so many times what was taken do not settle

class Bounds {
 public:
  explicit Bounds(const std::vector<SpanBounds>& found) : taken_(found), found_(found) {
    for_all([](double& taken, double& before, double) {
      before = std::max(before, kLeastBound);
      taken = kRoom * before;
    });
  }

  const std::vector<SpanBounds>& taken() const { return taken_; }
  bool settling() const { return settling_; }

  // Whether there is room beyond what was found; else takes larger ones. What was found grew by
  // some share since the pass before, and is taken to grow by that once more.
  bool settled(const std::vector<SpanBounds>& found) {
    now_ = &found;
    bool out = true;
    for_all([&](double& taken, double& before, double now) {
      out = out && kLeastRoom * now <= taken;
      now = std::max(now, kLeastBound);
      const double growth = std::max(now / before, 1.0);
      settling_ = settling_ && now <= kMostGrowth * taken;
      if (kRoom * now > 0.995 * taken) taken = std::max(taken, kRoom * growth * now);
      before = now;
    });
    return out;
  }

 private:
  template <class F>
  void for_all(const F& f) {
    for (std::size_t k = 0; k < taken_.size(); ++k) {
      for (std::size_t i = 0; i < taken_[k].size(); ++i) {
        f(taken_[k][i], found_[k][i], now_ ? (*now_)[k][i] : 0);
      }
    }
  }

  std::vector<SpanBounds> taken_;
  std::vector<SpanBounds> found_;  // in the pass before
  const std::vector<SpanBounds>* now_ = nullptr;
  bool settling_ = true;
};

}  // namespace

CellTube prove_by_spans(const ReferenceTrack& track, const FlightOptions& options,
                        const Disturbances& disturbances, const TubeCell& cell) {
  CellTube found = prove_cell(track, options, disturbances, cell);
  if (found.trouble) return found;
  Bounds bounds(found.bounds);
  for (int pass = 0; pass < kPasses && bounds.settling(); ++pass) {
    TubeCell taken = cell;
    taken.bounds = bounds.taken();
    found = prove_cell(track, options, disturbances, taken);
    if (found.trouble) return found;
    if (!bounds.settled(found.bounds)) continue;
    found.bounds = std::move(taken.bounds);
    return found;
  }
  found.trouble = TubeTrouble{TubeTrouble::Kind::bounds, 0, 0, 0};
  return found;
}

}  // namespace traj
