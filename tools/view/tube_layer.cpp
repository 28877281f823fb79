#include "layers.h"
#include "traj/record/tube_reports.h"

namespace view {

std::optional<Json> tube_layer(const cli::Contents& contents, const traj::TrajectoryRecord& record,
                               Bundle& bundle) {
  const geom::Provenance over{.frame = axes_of(contents, record.provenance),
                              .vehicle = record.provenance.vehicle};
  for (const auto& [tube, source, line] : contents.tubes) {
    if (tube.id != record.id || traj::why_not_of(tube, record.trajectory, over)) continue;
    const std::vector<float> radius(tube.radius.begin(), tube.radius.end());
    return Json{{"kind", geom::word_of(traj::kTubeKindWords, tube.claim.kind)},
                {"words", traj::in_words(tube.claim)},
                {"period", tube.period},
                {"radius", bundle.add(std::span<const float>(radius))}};
  }
  return std::nullopt;
}

}  // namespace view
