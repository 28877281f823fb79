// The worker threads of a call.

#include <algorithm>
#include <thread>

#include "pybind_module.h"

namespace binding {

geom::Execution on_threads(unsigned threads) {
  return {threads ? threads : std::max(1u, std::thread::hardware_concurrency()), {}};
}

}  // namespace binding
