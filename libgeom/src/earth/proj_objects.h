#pragma once

// What PROJ gives out, given back by itself (proj_*.cpp only).

#include <memory>
#include <stdexcept>

#include "base/watched_memory.h"
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

// Watches PROJ while it works with a context. PROJ goes on after a failure, and only its log tells.
class WatchedProj {
 public:
  explicit WatchedProj(PJ_CONTEXT* context) : context_(context) {
    proj().log_function(context_, &errors_, note);
    proj().log_level(context_, PJ_LOG_ERROR);
  }
  ~WatchedProj() { proj().log_level(context_, PJ_LOG_NONE); }
  WatchedProj(const WatchedProj&) = delete;
  WatchedProj& operator=(const WatchedProj&) = delete;

  // Throws std::bad_alloc where memory ran out, and std::runtime_error for another error.
  void require_none() const {
    memory_.require_enough();
    if (failed()) throw std::runtime_error("PROJ failed, and may have found less than it knows");
  }
  bool failed() const { return errors_ > 0; }

 private:
  static void note(void* errors, int level, const char*) {
    if (level == PJ_LOG_ERROR) ++*static_cast<unsigned*>(errors);
  }

  PJ_CONTEXT* context_;
  WatchedMemory memory_;
  unsigned errors_ = 0;
};

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
