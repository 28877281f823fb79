#include "proj_library.h"

namespace geom {

const ProjLibrary& proj() {
  static const ProjLibrary library{LoadedLibrary(SKYWAY_PROJ_SONAME, "libproj25")};
  return library;
}

}  // namespace geom
