#pragma once

// The corridor of a trajectory as a JSON Lines record, with what is needed to draw it.

#include <string>

#include "geom/io/record.h"
#include "traj/corridor.h"

namespace traj {

// Ends with a newline. Each piece with its planes, and the vertices and faces of the region behind
// them (geom/polytope.h) within `reach` metres of the piece's bounding box.
std::string to_json_line(const std::string& id, const geom::Provenance& provenance,
                         const Corridor& corridor, double reach);

}  // namespace traj
