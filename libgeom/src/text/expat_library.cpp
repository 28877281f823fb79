#include "expat_library.h"

namespace geom {

const ExpatLibrary& expat() {
  static const ExpatLibrary library{LoadedLibrary(SKYWAY_EXPAT_SONAME, "libexpat1")};
  return library;
}

}  // namespace geom
