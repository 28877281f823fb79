#pragma once

// COLLADA and 3DS files as triangles, read by assimp.
//
// Example, not run:
//   std::ifstream file("bridge.dae", std::ios::binary);
//   const std::string bytes(std::istreambuf_iterator<char>(file), {});
//   const geom::Model bridge = geom::read_collada(bytes, "bridge.dae");
//   std::cout << bridge.mesh.triangles.size() << " triangles\n";

#include <string>

#include "geom/model/model.h"

namespace geom {

// Triangles as the scene's nodes place them, z up; of COLLADA in metres, as its `unit` and
// `up_axis` say. Numbers are single precision on the way: Model::blur says how far that may be off.
// Polygons that the file counts and assimp does not give are skipped and counted, as are those with
// holes, points and lines. Refused: what bones, morphs or animations move. assimp reads it in a
// child process first: std::runtime_error where that breaks down. Throws InputError(source, …).
Model read_collada(const std::string& bytes, const std::string& source);
Model read_3ds(const std::string& bytes, const std::string& source);

}  // namespace geom
