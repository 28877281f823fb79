#pragma once

// Ordered loops: item i writes slot i, whatever the number of threads.
//
// Example:
//   std::vector<double> squares(100);
//   geom::parallel_for(squares.size(), {.threads = 2},
//                      [&](std::size_t i) { squares[i] = static_cast<double>(i * i); });
//   assert(squares[9] == 81);

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "geom/base/execution.h"

namespace geom {

// Calls f(i) for i in [0, n), in any order, each once, on run.threads threads. Returns when all are
// done. The first exception (by lowest i of those thrown, by f or the progress report) is rethrown
// here, and no more items are begun. If the system gives fewer threads, the loop runs on those.
void parallel_for(std::size_t n, const Execution& run, const std::function<void(std::size_t)>& f);

// `run` with fewer threads, so that each has at least `least` of the work; one thread at least. To
// start a thread takes as long as 0.1 ms of work.
inline Execution for_work(Execution run, std::uint64_t work, std::uint64_t least) {
  run.threads = static_cast<unsigned>(std::min<std::uint64_t>(work / least, run.threads));
  run.threads = std::max(run.threads, 1u);
  return run;
}

}  // namespace geom
