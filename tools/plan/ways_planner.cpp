#include "ways_planner.h"

#include <algorithm>

#include "geom/text/json_fields.h"

namespace planning {

WaysPlanner::Answer WaysPlanner::answer(const std::string& text, const std::string& source,
                                        std::size_t line) {
  Answer out{traj::read_home_flight(geom::JsonFields(text, source, line), options_.vmax)};
  if (out.flight.stages.empty()) {
    traj::ContingencyRecord& record = out.records.emplace_back();
    record.id = out.flight.id;
    record.message = out.flight.without;
    record.provenance = out.flight.provenance;
    return out;
  }
  const auto base = base_for(out.flight.provenance, source, line);
  metres_.check_input(scenes_.map().spec().frame, out.flight.places(), source, line);
  out.home = traj::ways_home(*base->scene, out.flight.stages, base->task);
  out.complete = traj::complete(out.home, base->task);
  out.records =
      traj::contingency_records(out.flight.id, out.home, base->task,
                                geom::provenance_of(*base->scene), out.flight.checked_hash);
  return out;
}

// The margin is at least what autopilots stray.
std::shared_ptr<const WaysPlanner::Base> WaysPlanner::base_for(geom::Provenance provenance,
                                                               const std::string& source,
                                                               std::size_t line) {
  provenance.margin = std::max(provenance.margin.value_or(0), traj::least_margin(options_.models));
  const auto scene = scenes_.shared_scene_for(provenance, source, line);
  const std::lock_guard lock(mutex_);
  auto& base = bases_[scene.get()];
  if (!base) base = made(scene);
  return base;
}

std::shared_ptr<const WaysPlanner::Base> WaysPlanner::made(
    std::shared_ptr<const geom::CollisionScene> scene) const {
  auto out = std::make_shared<Base>();
  out->planner = std::make_unique<plan::Planner>(*scene);
  out->task.models = options_.models;
  if (scenes_.profile()) out->task.energy = scenes_.profile()->energy;
  for (const traj::DrawnSite& site : options_.sites) {
    out->task.sites.push_back(traj::landing_site(*scene, site, options_.source));
  }
  plan::PlanOptions search;
  search.quality = options_.quality;
  out->task.plan = [planner = out->planner.get(), search](
                       const geom::Vec3& from,
                       const traj::LandingSite& site) -> std::optional<geom::Polyline> {
    plan::PlanResult result = planner->plan(from, site.above, search);
    if (result.status != geom::PathStatus::found) return std::nullopt;
    return std::move(result.path);
  };
  out->scene = std::move(scene);
  return out;
}

}  // namespace planning
