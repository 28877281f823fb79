#pragma once

// The steps of a plan that search among bends.

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "plan/roadmap/roadmap.h"
#include "step.h"

namespace plan {

// May be asked from several threads.
class BendSteps {
 public:
  // Both must outlive it.
  BendSteps(const geom::CollisionScene& scene, const Roadmap* roadmap)
      : scene_(scene), roadmap_(roadmap) {}

  bool has_roadmap() const { return roadmap_; }

  // By the roadmap, giving up early; and however many bends it takes.
  std::optional<Found> at_once(const Task& task);
  std::optional<Found> exhaustively(const Task& task);

  // A path shorter than `than`: by the roadmap, or else among bends around the boxes that such a
  // path may touch.
  std::optional<Found> better(const Task& task, const geom::Polyline& than);

  // A path shorter than `than`, by bends that are closer to each other along it. Not sought where
  // it would gain little.
  std::optional<Found> closer(const Task& task, const geom::Polyline& than) const;

 private:
  std::unique_ptr<RoadmapSearch> take();
  std::optional<Found> by_roadmap(const Task& task, RoadmapLimits limits,
                                  const geom::Polyline& than);
  std::optional<Found> shortest(RoadmapSearch& search, const Task& task, RoadmapLimits limits,
                                const geom::Polyline& than) const;
  std::vector<Bend> bends_for(const geom::Polyline& part, double length, bool best) const;
  std::optional<Found> tighter(const PlanOptions& options, const geom::Polyline& part,
                               std::size_t paths) const;
  std::optional<Found> by_stretches(const PlanOptions& options, const geom::Polyline& than) const;

  const geom::CollisionScene& scene_;
  const Roadmap* roadmap_;
  std::mutex mutex_;  // guards what follows
  std::vector<std::unique_ptr<RoadmapSearch>> idle_;
};

}  // namespace plan
