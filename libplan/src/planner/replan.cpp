#include "plan/planner/replan.h"

#include <algorithm>
#include <cassert>
#include <optional>

#include "path/shortcut.h"
#include "path/taut.h"

namespace plan {
namespace {

using geom::LegRange;
using geom::Polyline;

constexpr double kWorth = 0.005;  // of a stretch: what giving up kept legs must gain
constexpr double kLonger = 1.05;  // times as long: then planning anew may do better

// What replaces the old legs from point `first` to point `last`; of the same ends.
struct Mend {
  std::size_t first;
  std::size_t last;
  Polyline path;
};

// Maximal runs of blocked legs. Their ends are free wherever both ends of the path are: a blocked
// point blocks both of its legs.
std::vector<LegRange> blocked_runs(const geom::CollisionScene& scene, const Polyline& path) {
  std::vector<LegRange> runs;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (scene.free(path[i], path[i + 1])) continue;
    if (runs.empty() || runs.back().last != i) runs.push_back({i, i});
    runs.back().last = i + 1;
  }
  return runs;
}

// Leaves out what `mend` shares with the old path at its ends.
void trim(const Polyline& old, Mend& mend) {
  std::size_t front = 0;
  while (mend.path.size() > front + 2 && mend.first + 1 < mend.last &&
         mend.path[front + 1] == old[mend.first + 1]) {
    ++front;
    ++mend.first;
  }
  mend.path.erase(mend.path.begin(), mend.path.begin() + static_cast<std::ptrdiff_t>(front));
  while (mend.path.size() > 2 && mend.first + 1 < mend.last &&
         mend.path[mend.path.size() - 2] == old[mend.last - 1]) {
    mend.path.pop_back();
    --mend.last;
  }
}

class Mender {
 public:
  Mender(const geom::CollisionScene& scene, Planner& planner, const Polyline& old, Quality quality)
      : scene_(scene), planner_(planner), old_(old) {
    options_.quality = quality;
  }

  ReplanResult replan() {
    const std::vector<LegRange> runs = blocked_runs(scene_, old_);
    if (!scene_.free(old_.front()) || !scene_.free(old_.back())) return anew();  // says which
    if (runs.empty()) return kept_whole();
    if (runs[0] == LegRange{0, old_.size() - 1}) return anew();
    std::optional<ReplanResult> mended = mend(runs);
    if (mended && geom::length(mended->plan.path) <= kLonger * geom::length(old_)) return *mended;
    ReplanResult fresh = anew();
    if (!mended) return fresh;
    const bool better = fresh.plan.status == PathStatus::found &&
                        geom::length(mended->plan.path) > kLonger * geom::length(fresh.plan.path);
    return better ? fresh : *mended;
  }

 private:
  ReplanResult kept_whole() const {
    ReplanResult result;
    result.plan.status = PathStatus::found;
    result.plan.path = old_;
    if (old_.size() > 1) result.origin.kept = {{0, old_.size() - 1}};
    return result;
  }

  ReplanResult anew() {
    ReplanResult result;
    result.plan = planner_.plan(old_.front(), old_.back(), options_);
    if (!result.plan.path.empty()) result.origin.mended = {{0, result.plan.path.size() - 1}};
    return result;
  }

  // Nothing where a run cannot be mended between its ends.
  std::optional<ReplanResult> mend(const std::vector<LegRange>& runs) {
    ReplanResult result;
    PlanResult& report = result.plan;
    std::vector<Mend> mends;
    std::size_t most = 0;
    for (const LegRange& run : runs) {
      PlanResult plan = planner_.plan(old_[run.first], old_[run.last], options_);
      if (plan.status != PathStatus::found) return std::nullopt;
      if (mends.empty() || plan.expanded > most) {
        most = plan.expanded;
        report.route = plan.route;
        report.resolution = plan.resolution;
      }
      report.expanded += plan.expanded;
      mends.push_back({run.first, run.last, std::move(plan.path)});
    }
    report.status = PathStatus::found;
    splice(mends, result);
    report.steps = {{"splice", report.path.size(), geom::length(report.path)}};
    for (std::size_t i = 0; i < mends.size(); ++i) {
      const std::size_t lowest = i ? mends[i - 1].last : 0;
      const std::size_t highest = i + 1 < mends.size() ? mends[i + 1].first : old_.size() - 1;
      pull_joints(lowest, highest, mends[i]);
    }
    splice(mends, result);
    report.steps.push_back({"taut", report.path.size(), geom::length(report.path)});
    return result;
  }

  // Takes in kept legs between the old points `lowest` and `highest` while the mend is a detour and
  // that shortens it: corners of the old path are not to be cut for their own sake.
  void pull_joints(std::size_t lowest, std::size_t highest, Mend& mend) const {
    for (std::size_t more = 1;; more *= 2) {
      const std::size_t first = mend.first - std::min(more, mend.first - lowest);
      const std::size_t last = mend.last + std::min(more, highest - mend.last);
      if (first == mend.first && last == mend.last) return;
      Polyline stretch = old_points(first, mend.first);
      stretch.insert(stretch.end(), mend.path.begin(), mend.path.end());
      const Polyline after = old_points(mend.last + 1, last + 1);
      stretch.insert(stretch.end(), after.begin(), after.end());
      const double length = geom::length(stretch);
      if (length <= (1 + kWorth) * geom::length(old_points(first, last + 1))) return;
      Polyline pulled = shortcut(scene_, stretch);
      if (options_.quality != Quality::fast) pulled = taut(scene_, pulled);
      if (length - geom::length(pulled) <= kWorth * length) return;
      mend = {first, last, std::move(pulled)};
      trim(old_, mend);
    }
  }

  Polyline old_points(std::size_t begin, std::size_t end) const {
    return {old_.begin() + static_cast<std::ptrdiff_t>(begin),
            old_.begin() + static_cast<std::ptrdiff_t>(end)};
  }

  // The old path with its mends, and where its legs are from.
  void splice(const std::vector<Mend>& mends, ReplanResult& result) const {
    Polyline& path = result.plan.path;
    path = {old_.front()};
    result.origin = {};
    const auto add = [&](std::vector<LegRange>& ranges, const Polyline& points) {
      const std::size_t first = path.size() - 1;
      path.insert(path.end(), points.begin() + 1, points.end());
      if (points.size() < 2) return;
      if (!ranges.empty() && ranges.back().last == first) {
        ranges.back().last = path.size() - 1;
      } else {
        ranges.push_back({first, path.size() - 1});
      }
    };
    std::size_t at = 0;
    for (const Mend& mend : mends) {
      add(result.origin.kept, old_points(at, mend.first + 1));
      add(result.origin.mended, mend.path);
      at = mend.last;
    }
    add(result.origin.kept, old_points(at, old_.size()));
  }

  const geom::CollisionScene& scene_;
  Planner& planner_;
  const Polyline& old_;
  PlanOptions options_;
};

}  // namespace

ReplanResult replan(const geom::CollisionScene& scene, Planner& planner, const Polyline& path,
                    Quality quality) {
  assert(!path.empty());
  return Mender(scene, planner, path, quality).replan();
}

}  // namespace plan
