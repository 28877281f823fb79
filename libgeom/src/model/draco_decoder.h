#pragma once

// What Draco has compressed, as libdraco decodes it.

#include "geom/model/draco_mesh.h"

namespace geom {

// A DracoDecoder. Throws InputError(source, …) for what libdraco refuses, for points,
// and for what is inconsistent: triangles without a vertex, vertices without a value. Of
// bitstream 2.2, without metadata, and with at most a thousand triangles or vertices a byte.
DracoMesh decode_draco(std::string_view bytes, const std::string& source);

}  // namespace geom
