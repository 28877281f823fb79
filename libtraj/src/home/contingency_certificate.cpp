#include <tuple>

#include "geom/text/json_line.h"
#include "home/way_room.h"
#include "traj/home/contingency_proof.h"

namespace traj {
namespace {

using geom::JsonLine;

// m beyond half sizes and margin from which all that is proved stays clear, legs left out: the
// grown boxes reach 5e-10 m further, and regions are held against boxes that reach 1e-9 m more.
constexpr double kClear = 7e-10;

JsonLine object_of(const Prism& prism) {
  return JsonLine().add("plan", prism.plan).add("low", prism.low).add("high", prism.high);
}

JsonLine object_of(const ProvedJoin& join) {
  JsonLine line;
  line.add("from", join.from).add("until", join.until).add("lasts", join.lasts);
  line.add("where", join.where);
  return line.add("braking", object_of(join.braking)).add("beyond", object_of(join.beyond));
}

JsonLine object_of(const ProvedWay& way) {
  const ContingencyRecord& record = way.record;
  JsonLine line;
  line.add("from", record.from).add("until", record.until).add("site", record.site);
  line.add("points", record.points);
  line.add("beyond", way.beyond, [](const Prism& one) { return object_of(one); });
  return line.add("joins", way.joins, [](const ProvedJoin& one) { return object_of(one); });
}

std::string names_of(std::span<const ReturnModel> models) {
  std::string out;
  for (const ReturnModel& model : models) out += (out.empty() ? "" : ", ") + model.autopilot;
  return out;
}

}  // namespace

std::string contingency_certificate_line(const geom::CollisionScene& scene,
                                         const HomeFlight& flight, std::span<const ProvedWay> ways,
                                         const ContingencyRules& rules) {
  const geom::Aabb& bounds = scene.map().spec().bounds;
  const Vec3 half = scene.vehicle().half + Vec3::Constant(scene.margin() + kClear);
  JsonLine line;
  line.add("type", "contingencies").add("id", flight.id).add("of", flight.kind);
  add(line, geom::provenance_of(scene));
  line.add("bounds", std::tuple(bounds.min, bounds.max)).add("half", half);
  line.add("autopilot", names_of(rules.models));
  line.add("overshoot", WayRoom(scene, rules.models).overshoot());
  if (rules.energy) line.add("flying_time", flying_time(*rules.energy));
  const std::vector<FlightStage>& stages = flight.stages;
  line.add("duration", stages.empty() ? 0.0 : stages.back().until - stages.front().from);
  line.add("ways", ways, [](const ProvedWay& one) { return object_of(one); });
  return line.line();
}

}  // namespace traj
