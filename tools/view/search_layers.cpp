#include <utility>

#include "layers.h"
#include "traj/record/duration_bound.h"

namespace view {

Json tree_layer(const plan::SearchTreeRecord& record, const LocalFrame& frame, Bundle& bundle) {
  const plan::SearchTree& tree = record.tree;
  std::vector<float> points;
  for (const geom::Vec3& p : tree.points) append(points, frame.at(p));
  const std::vector<float> cost(tree.cost.begin(), tree.cost.end());
  return {{"id", record.id},
          {"nodes", tree.points.size()},
          {"points", bundle.add(std::span<const float>(points))},
          {"parent", bundle.add(std::span<const std::uint32_t>(tree.parent))},
          {"first_parent", bundle.add(std::span<const std::uint32_t>(tree.first_parent))},
          {"tree", bundle.add(std::span<const std::uint8_t>(tree.tree))},
          {"cost", bundle.add(std::span<const float>(cost))}};
}

Json path_layer(const geom::PathRecord& path, const LocalFrame& frame, Bundle& bundle) {
  Json out = {{"id", path.id}, {"status", name(path.status)}};
  if (!path.message.empty()) out["message"] = path.message;
  if (path.points.empty()) return out;
  std::vector<float> points;
  for (const geom::Vec3& p : path.points) append(points, frame.at(p));
  out["length"] = geom::length(path.points);
  out["points"] = bundle.add(std::span<const float>(points));
  return out;
}

Json corridor_layer(const traj::CorridorShape& corridor, const LocalFrame& frame, Bundle& bundle) {
  std::vector<float> points;
  std::vector<std::uint32_t> triangles, edges;
  std::vector<std::uint32_t> triangle_end, edge_end;  // of each piece
  for (const auto& piece : corridor.pieces) {
    const auto first = static_cast<std::uint32_t>(points.size() / 3);
    for (const geom::Vec3& v : piece.vertices) append(points, frame.at(v));
    for (const auto& face : piece.faces) {
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::uint32_t next = face[(i + 1) % face.size()];
        if (face[i] < next) edges.insert(edges.end(), {first + face[i], first + next});
        if (i < 2) continue;
        triangles.insert(triangles.end(), {first + face[0], first + face[i - 1], first + face[i]});
      }
    }
    triangle_end.push_back(static_cast<std::uint32_t>(triangles.size()));
    edge_end.push_back(static_cast<std::uint32_t>(edges.size()));
  }
  const auto added = [&](const auto& values) {
    return bundle.add(std::span(std::as_const(values)));
  };
  return {{"id", corridor.id},
          {"pieces", corridor.pieces.size()},
          {"points", added(points)},
          {"triangles", added(triangles)},
          {"triangle_end", added(triangle_end)},
          {"edges", added(edges)},
          {"edge_end", added(edge_end)}};
}

Json report_layer(const traj::ReportSummary& report, const LocalFrame& frame) {
  Json out = {{"id", report.id}, {"checked", report.checked}, {"ok", report.ok}};
  if (!report.ok) out["reason"] = report.reason;
  if (!report.rests_on.empty()) out["rests"] = report.rests_on;
  if (report.overridden) out["overridden"] = true;
  if (report.time) out["time"] = *report.time;
  if (report.place) out["place"] = as_json(frame.at(*report.place));
  if (report.worst) out["worst"] = *report.worst;
  if (report.box) out["box"] = *report.box;
  if (report.item) out["item"] = *report.item;
  if (!report.part.empty()) out["part"] = report.part;
  if (!report.detail.empty()) out["detail"] = report.detail;
  if (report.duration) out["duration"] = *report.duration;
  if (report.duration && report.duration_bound && *report.duration_bound > 0) {
    out["slower"] = traj::slower_words(*report.duration / *report.duration_bound - 1);
  }
  if (report.exact_ok) out["exact"] = *report.exact_ok;
  if (report.returns) out["return"] = return_layer(*report.returns, frame);
  Json extremes = Json::array();
  for (const auto& [name, value, time] : report.extremes) {
    extremes.push_back({{"name", name}, {"value", value}});
    if (time) extremes.back()["time"] = *time;
  }
  out["extremes"] = std::move(extremes);
  out["limits"] = as_json(report.limits);
  return out;
}

}  // namespace view
