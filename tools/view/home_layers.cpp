
#include "layers.h"

namespace view {
namespace {

Json gap_json(const traj::ReturnGapSummary& gap, const LocalFrame& frame) {
  Json out = {{"from", gap.from}, {"until", gap.until}};
  if (gap.item) out["item"] = *gap.item;
  if (!gap.part.empty()) out["part"] = gap.part;
  if (!gap.autopilot.empty()) out["autopilot"] = gap.autopilot;
  out["phase"] = gap.phase;
  out["reason"] = gap.reason;
  if (gap.place) out["place"] = as_json(frame.at(*gap.place));
  if (gap.box) out["box"] = *gap.box;
  if (gap.fence) out["fence"] = *gap.fence;
  return out;
}

}  // namespace

Json return_layer(const traj::ReturnSummary& returns, const LocalFrame& frame) {
  Json out = {{"action", returns.action}, {"autopilot", returns.autopilot}};
  if (returns.home) out["home"] = as_json(frame.at(*returns.home));
  out["height"] = returns.height;
  out["share"] = returns.share;
  out["duration"] = returns.duration;
  out["longest"] = returns.longest;
  if (returns.least_height) out["least_height"] = *returns.least_height;
  if (returns.best_height) out["best_height"] = *returns.best_height;
  if (returns.best_share) out["best_share"] = *returns.best_share;
  Json gaps = Json::array();
  for (const traj::ReturnGapSummary& gap : returns.gaps) {
    gaps.push_back(gap_json(gap, frame));
  }
  out["gaps"] = std::move(gaps);
  return out;
}

Json timeline_layer(const traj::ReportSummary& report, const LocalFrame& frame, Bundle& bundle) {
  std::vector<float> time, position;
  for (const traj::TimedPlace& one : report.returns->timeline) {
    time.push_back(static_cast<float>(one.time));
    append(position, frame.at(one.place));
  }
  return {{"id", report.id},
          {"kind", "mission"},
          {"duration", report.returns->duration},
          {"samples", time.size()},
          {"time", bundle.add(std::span<const float>(time))},
          {"position", bundle.add(std::span<const float>(position))}};
}

Json contingency_layer(const traj::ContingencyRecord& way, const LocalFrame& frame,
                       Bundle& bundle) {
  Json out = {{"id", way.id}, {"from", way.from}, {"until", way.until}};
  if (!way.message.empty()) out["message"] = way.message;
  if (!way.found()) return out;
  std::vector<float> points;
  for (const geom::Vec3& p : way.points) append(points, frame.at(p));
  out["site"] = way.site;
  out["points"] = bundle.add(std::span<const float>(points));
  if (way.length) out["length"] = *way.length;
  if (way.duration) out["duration"] = *way.duration;
  if (const auto until = way.good_until()) out["latest"] = *until;
  out["energy"] = way.bounds_energy;
  return out;
}

}  // namespace view
