#include "traj/io/corridor_record.h"

#include <fmt/format.h>

#include "geom/polytope.h"

namespace traj {
namespace {

void append_planes(std::string& out, const std::vector<Plane>& planes) {
  out += ",\"planes\":[";
  for (const Plane& plane : planes) {
    out += '[';
    for (const double value : {plane.normal.x(), plane.normal.y(), plane.normal.z()}) {
      geom::append_json(out, value);
      out += ',';
    }
    geom::append_json(out, plane.offset);
    out += "],";
  }
  if (!planes.empty()) out.pop_back();
  out += ']';
}

std::vector<Plane> cut_off(const CorridorPiece& piece, double reach) {
  std::vector<Plane> planes = piece.planes;
  const Vec3 low = piece.from.cwiseMin(piece.to).array() - reach;
  const Vec3 high = piece.from.cwiseMax(piece.to).array() + reach;
  for (int i = 0; i < 3; ++i) {
    planes.push_back({Vec3::Unit(i), high[i]});
    planes.push_back({-Vec3::Unit(i), -low[i]});
  }
  return planes;
}

void append_region(std::string& out, const geom::Polytope& region) {
  out += ",\"vertices\":[";
  for (const Vec3& v : region.vertices) {
    geom::append_json(out, v);
    out += ',';
  }
  if (!region.vertices.empty()) out.pop_back();
  out += "],\"faces\":[";
  for (const auto& face : region.faces) out += fmt::format("[{}],", fmt::join(face, ","));
  if (!region.faces.empty()) out.pop_back();
  out += ']';
}

}  // namespace

std::string to_json_line(const std::string& id, const geom::Provenance& provenance,
                         const Corridor& corridor, double reach) {
  std::string line = "{\"type\":\"corridor\",\"id\":";
  geom::append_json(line, std::string_view(id));
  line += ',';
  geom::append_json(line, provenance);
  line += "\"pieces\":[";
  for (const CorridorPiece& piece : corridor) {
    line += "{\"from\":";
    geom::append_json(line, piece.from);
    line += ",\"to\":";
    geom::append_json(line, piece.to);
    append_planes(line, piece.planes);
    append_region(line, geom::polytope(cut_off(piece, reach)));
    line += "},";
  }
  if (!corridor.empty()) line.pop_back();
  line += "]}\n";
  return line;
}

}  // namespace traj
