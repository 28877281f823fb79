#pragma once

// Corridors as JSON Lines records, with what is needed to draw them.
//
// Example:
//   traj::Corridor corridor = traj::pieces_between(path);
//   traj::add_planes(scene, 5, corridor);
//   const std::string line = traj::to_json_line("q1", geom::provenance_of(scene), corridor, 5);
//   const traj::CorridorShape shape = traj::parse_corridor_record(line, "corridor.jsonl", 1);
//   assert(shape.pieces.size() == corridor.size());

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geom/record/record.h"
#include "traj/solve/corridor.h"

namespace traj {

// Ends with a newline. Each piece with its planes, and the vertices and faces of the region behind
// them (geom/shape/polytope.h) within `reach` metres of the piece's bounding box.
std::string to_json_line(const std::string& id, const geom::Provenance& provenance,
                         const Corridor& corridor, double reach);

// A corridor as it is drawn.
struct CorridorShape {
  struct Piece {
    std::vector<Vec3> vertices;                     // metres
    std::vector<std::vector<std::uint32_t>> faces;  // >= 3 vertices in turn each
  };
  std::string id;
  geom::Provenance provenance;
  std::vector<Piece> pieces;
};

// Planes are not read. Throws InputError(source, line, …) for anything that is not such a record,
// and for a face with less than three vertices or one that is not there.
CorridorShape parse_corridor_record(std::string_view json, std::string_view source,
                                    std::size_t line);

}  // namespace traj
