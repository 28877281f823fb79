#include "plan/planner/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>
#include <vector>

#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "plan/planner/snap_end.h"
#include "shown_point.h"
#include "step.h"

namespace plan {

using geom::Polyline;

namespace {

constexpr double kEntry = 200;  // metres from an end to where its layer is entered

// The map between two heights of the reference point: the boxes that it can touch there, as they
// are.
geom::BoxMap slab(const geom::CollisionScene& scene, double low, double high) {
  const geom::BoxMap& map = scene.map();
  geom::BoxMapSpec spec = map.spec();
  const double half = scene.half().z();
  spec.bounds.min.z() = std::max(spec.bounds.min.z(), low - half);
  spec.bounds.max.z() = std::min(spec.bounds.max.z(), high + half);
  geom::BoxTable table;
  geom::Aabb region = spec.bounds;
  region.min.z() = low - 1;
  region.max.z() = high + 1;
  for (const std::size_t box : scene.boxes_meeting(region)) table.add(map.box(box), 0);
  return geom::BoxMap(std::move(spec), table);
}

// Where flights of one layer are planned.
struct Level {
  Level(const geom::CollisionScene& whole, double low, double high)
      : scene(slab(whole, low, high), whole.vehicle(), whole.margin()), planner(scene) {}

  geom::CollisionScene scene;
  Planner planner;
};

void append(Polyline& path, const Polyline& more) {
  path.insert(path.end(), more.begin() + (path.empty() || path.back() != more.front() ? 0 : 1),
              more.end());
}

PlanResult refused(PlanResult result, std::string_view part,
                   const std::pair<double, double>& span) {
  result.message =
      fmt::format("{} the layer of {} to {} m: {}", part, span.first, span.second, result.message);
  result.path.clear();
  result.enclosure.reset();  // it would say that there is no way at all
  return result;
}

}  // namespace

std::pair<double, double> Layers::span(int layer) const {
  return {low + layer * step, low + (layer + 1) * step};
}

int layer_of(const Layers& layers, geom::Axes axes, const Vec3& from, const Vec3& to) {
  const Vec3 way = geom::to_enu(axes, to - from);
  const double turn = std::atan2(way.x(), way.y()) / (2 * std::numbers::pi);  // (-1/2, 1/2]
  const double share = turn < 0 ? turn + 1 : turn;
  return std::min(static_cast<int>(share * layers.count), layers.count - 1);
}

struct LayerPlanner::Impl {
  struct Lazy {
    std::once_flag once;
    std::unique_ptr<Level> level;
  };

  Level& level(int layer) {
    Lazy& lazy = levels[static_cast<std::size_t>(layer)];
    std::call_once(lazy.once, [&] {
      const auto [low, high] = layers.span(layer);
      lazy.level = std::make_unique<Level>(scene, low, high);
    });
    return *lazy.level;
  }

  // The place in the layer that is nearest to an end.
  std::optional<Vec3> entry(Level& at, Vec3 end) const {
    const auto& inside = at.scene.free_bounds();
    if (!inside) return std::nullopt;
    end.z() = std::clamp(end.z(), inside->min.z(), inside->max.z());
    return nearest_free(at.scene, end, kEntry);
  }

  const geom::CollisionScene& scene;
  Planner& whole;
  Layers layers;
  std::vector<Lazy> levels;
};

LayerPlanner::LayerPlanner(const geom::CollisionScene& scene, Planner& whole, const Layers& layers)
    : impl_(new Impl{scene, whole, layers,
                     std::vector<Impl::Lazy>(static_cast<std::size_t>(layers.count))}) {
  const auto [low, top] = std::pair(layers.low, layers.span(layers.count - 1).second);
  const geom::Aabb& bounds = scene.map().spec().bounds;
  if (low >= bounds.min.z() && top <= bounds.max.z()) return;
  throw geom::InputError("layers",
                         {.expected = fmt::format(
                              "layers between the bottom of the map, at {} m, and its top, at {} m",
                              bounds.min.z(), bounds.max.z()),
                          .found = fmt::format("{} to {} m", low, top)});
}

LayerPlanner::~LayerPlanner() = default;

PlanResult LayerPlanner::plan(const Vec3& from, const Vec3& to, const PlanOptions& options) {
  geom::require_point("start", from);
  geom::require_point("goal", to);
  const int layer = layer_of(impl_->layers, impl_->scene.map().spec().frame.axes, from, to);
  const auto span = impl_->layers.span(layer);
  Level& level = impl_->level(layer);
  const auto entry = impl_->entry(level, from);
  const auto exit = impl_->entry(level, to);
  if (!entry || !exit) {
    PlanResult none;
    none.message = fmt::format("there is no free place within {} m of the {}", kEntry,
                               entry ? "goal" : "start");
    return refused(std::move(none), "in", span);
  }
  PlanResult climb = impl_->whole.plan(from, *entry, options);
  if (climb.path.empty()) return refused(std::move(climb), "up or down to", span);
  PlanResult descent = impl_->whole.plan(*exit, to, options);
  if (descent.path.empty()) return refused(std::move(descent), "from", span);
  PlanResult result = level.planner.plan(*entry, *exit, options);
  if (result.path.empty()) return refused(std::move(result), "in", span);
  Polyline path = climb.path;
  append(path, result.path);
  append(path, descent.path);
  require_free(impl_->scene, path, "layers");
  result.path = std::move(path);
  result.steps.push_back(step_of("layer", result.path));
  result.expanded += climb.expanded + descent.expanded;
  result.snapped_start = climb.snapped_start;
  result.snapped_goal = descent.snapped_goal;
  result.layer = span;
  return result;
}

}  // namespace plan
