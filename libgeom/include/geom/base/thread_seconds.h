#pragma once

// Seconds of CPU that the calling thread has used: what a piece of work takes, whoever else runs.
//
// Example:
//   const double before = geom::thread_seconds();
//   scene.hits(path.front(), path.back());
//   assert(geom::thread_seconds() >= before);

#include <ctime>

namespace geom {

inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace geom
