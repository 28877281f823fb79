#pragma once

// What PROJ gives out, given back by itself (proj_*.cpp only).

#include <memory>

#include "geom/earth/proj_reference.h"
#include "proj_library.h"

namespace geom {

struct ContextCloser {
  void operator()(PJ_CONTEXT* context) const { proj().context_destroy(context); }
};
using ProjContext = std::unique_ptr<PJ_CONTEXT, ContextCloser>;

struct ObjectCloser {
  void operator()(PJ* object) const { proj().destroy(object); }
};
using ProjObject = std::unique_ptr<PJ, ObjectCloser>;

struct ProjReference::Impl {
  ProjContext context;
  ProjObject whole;
  ProjObject plane;  // the part of x and y
  ProjObject own;    // the same without a transformation that it is bound to: its own axes
  CoordinateReference told;

  // To longitude and latitude, once it was searched; null where there is none.
  bool searched = false;
  ProjObject to_places;
  bool chooses = false;  // among several operations, for each point
};

}  // namespace geom
