#pragma once

// What may vary from run to run without changing a result: threads and progress.
//
// Example:
//   const geom::Execution run{
//       .threads = 4, .progress = [](std::size_t done, std::size_t total) {
//         std::cerr << done << " of " << total << '\n';
//       }};

#include <cstddef>
#include <functional>

namespace geom {

struct Execution {
  unsigned threads = 1;  // never changes a result, only the time
  // Called now and then with (done, total) from any one thread at a time; may be empty.
  std::function<void(std::size_t, std::size_t)> progress;
};

}  // namespace geom
