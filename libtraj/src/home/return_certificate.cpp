#include "traj/home/return_certificate.h"

#include "geom/text/json_line.h"

namespace traj {
namespace {

using geom::JsonLine;

JsonLine object_of(const ReturnSweep& sweep) {
  JsonLine line;
  line.add("phase", name(sweep.phase)).add("plan", sweep.region.plan);
  line.add("low", sweep.region.low).add("high", sweep.region.high);
  line.add("stands_on", sweep.stands_on);
  return line;
}

JsonLine object_of(const ProvedStage& one) {
  JsonLine line;
  line.add("from", one.stage.from).add("until", one.stage.until).add("lasts", one.lasts);
  line.add("where", one.stage.where);
  line.add("sweeps", one.sweeps, [](const ReturnSweep& sweep) { return object_of(sweep); });
  return line;
}

}  // namespace

std::string return_reasons(const geom::CollisionScene& scene, const ReturnTask& task,
                           std::span<const ProvedStage> proved) {
  std::string out = "[";
  for (std::size_t i = 0; i < task.models.size(); ++i) {
    std::vector<ProvedStage> of_model;
    for (const ProvedStage& one : proved) {
      if (one.model == i) of_model.push_back(one);
    }
    JsonLine line;
    line.add("autopilot", task.models[i].autopilot);
    line.add("half", return_half(scene, task.models[i], task));
    line.add("stages", of_model, [](const ProvedStage& one) { return object_of(one); });
    out += (i > 0 ? "," : "") + line.object();
  }
  return out + "]";
}

}  // namespace traj
