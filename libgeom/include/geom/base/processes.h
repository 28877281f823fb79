#pragma once

// Ordered work in child processes, for libraries that may run only once in a process.
//
// Example:
//   std::string all;
//   const auto work = [](std::size_t i) { return std::to_string(i * i); };  // in a child process
//   geom::in_processes(4, 2, work, [&](std::size_t, const std::string& one) { all += one; });
//   assert(all == "0149");

#include <cstddef>
#include <functional>
#include <string>

namespace geom {

// Calls work(i) for i in [0, n) in up to `count` child processes, which see what this one holds by
// now, and take(i, result) here, in order, as soon as results are there. An InputError, UsageError,
// std::bad_alloc or other exception of work() is thrown here once all before it were taken, and
// std::runtime_error in place of the results of a process that was killed. With one process or
// one item nothing is forked. Call before any thread is running: children have only the caller's.
void in_processes(std::size_t n, unsigned count,
                  const std::function<std::string(std::size_t)>& work,
                  const std::function<void(std::size_t, const std::string&)>& take);

}  // namespace geom
