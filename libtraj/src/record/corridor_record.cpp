#include "traj/record/corridor_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <tuple>

#include "geom/shape/polytope.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"

namespace traj {
namespace {

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

// Within `reach` metres of its bounding box.
geom::JsonLine object_of(const CorridorPiece& piece, double reach) {
  const geom::Polytope region = geom::polytope(cut_off(piece, reach));
  geom::JsonLine line;
  line.add("from", piece.from).add("to", piece.to);
  line.add("planes", piece.planes, [](const Plane& plane) {
    const Vec3& n = plane.normal;
    return std::tuple(n.x(), n.y(), n.z(), plane.offset);
  });
  line.add("vertices", region.vertices).add("faces", region.faces);
  return line;
}

std::vector<std::uint32_t> parse_face(const geom::JsonFields& fields, const nlohmann::json& face,
                                      std::size_t vertices, const std::string& where) {
  if (!face.is_array() || face.size() < 3) {
    fields.refuse({.key = where,
                   .expected = "a list of at least 3 vertices",
                   .found = face.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)});
  }
  std::vector<std::uint32_t> out;
  for (const nlohmann::json& vertex : face) {
    if (!vertex.is_number_unsigned() || vertex.get<std::uint64_t>() >= vertices) {
      fields.refuse(
          {.says = fmt::format("{} must name vertices from 0 to below {}", where, vertices),
           .found = vertex.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)});
    }
    out.push_back(vertex.get<std::uint32_t>());
  }
  return out;
}

const nlohmann::json& list_of(const geom::JsonFields& fields, const nlohmann::json& object,
                              const char* key, const std::string& what) {
  if (!object.is_object() || !object.contains(key) || !object[key].is_array()) {
    fields.refuse({.key = what, .expected = "a list", .found = "none"});
  }
  return object[key];
}

CorridorShape::Piece parse_piece(const geom::JsonFields& fields, const nlohmann::json& piece,
                                 const std::string& where) {
  CorridorShape::Piece out;
  for (const auto& vertex : list_of(fields, piece, "vertices", where + ".vertices")) {
    out.vertices.push_back(fields.point(vertex, where + ".vertices"));
  }
  for (const auto& face : list_of(fields, piece, "faces", where + ".faces")) {
    out.faces.push_back(parse_face(fields, face, out.vertices.size(), where + ".faces"));
  }
  return out;
}

}  // namespace

std::string to_json_line(const std::string& id, const geom::Provenance& provenance,
                         const Corridor& corridor, double reach) {
  geom::JsonLine line;
  line.add("type", "corridor").add("id", id);
  add(line, provenance);
  line.add("pieces", corridor, [&](const CorridorPiece& piece) { return object_of(piece, reach); });
  return line.line();
}

CorridorShape parse_corridor_record(std::string_view json, std::string_view source,
                                    std::size_t line) {
  const geom::JsonFields fields(json, source, line);
  fields.require_type("corridor");
  CorridorShape shape{fields.text("id"), geom::read_provenance(fields), {}};
  for (const auto& piece : list_of(fields, fields.object(), "pieces", "pieces")) {
    shape.pieces.push_back(
        parse_piece(fields, piece, fmt::format("pieces[{}]", shape.pieces.size())));
  }
  return shape;
}

}  // namespace traj
