#include "embree_library.h"

namespace geom::picture {

const EmbreeLibrary& embree() {
  static const EmbreeLibrary library{LoadedLibrary(SKYWAY_EMBREE_SONAME, "libembree3-3")};
  return library;
}

}  // namespace geom::picture
