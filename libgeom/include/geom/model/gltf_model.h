#pragma once

// A reader of glTF 2.0 (Khronos, ISO/IEC 12113:2022): models as triangles.
//
// Example, not run:
//   std::ifstream file("house.glb", std::ios::binary);
//   const std::string bytes(std::istreambuf_iterator<char>(file), {});
//   const auto files = [](const std::string& name) -> std::string {
//     throw geom::InputError(name, {.says = "a file beside it is not read here"});
//   };
//   const geom::GltfModel house = geom::read_gltf(bytes, "house.glb", files);

#include "geom/model/draco_mesh.h"
#include "geom/model/model.h"

namespace geom {

struct GltfModel : Model {
  // For each triangle the feature that its vertices name (_BATCHID, _FEATURE_ID_0), or -1.
  std::vector<std::int64_t> feature;
};

// `.gltf` or `.glb`, by how `bytes` begin; `files` reads what it names, relative to `path`. Metres,
// y up. A part for each node that has triangles, named as the node, its mesh or its number. All
// meshes of the scene that the file shows (the first where it does not say) are there, each as its
// node and those above place it, in double precision.
//
// Skipped and counted: points and lines; meshes that nothing in that scene shows. Refused
// (InputError): what would move or multiply a mesh (skins, morph targets, animated nodes,
// EXT_mesh_gpu_instancing), sparse data, data compressed otherwise than the next lines say, any
// extension that the file requires and that changes what stands where, indices beyond their
// vertices, views beyond their buffers, buffers shorter than they say, nodes within themselves.
//
// What Draco has compressed is read where `draco` is given, and counts must be those that the
// accessors say. If a file has the same data uncompressed, too, these are read in any case.
GltfModel read_gltf(std::string_view bytes, std::string_view source, const ModelFiles& files,
                    std::string_view path = {}, const DracoDecoder& draco = {});

}  // namespace geom
