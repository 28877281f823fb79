#include "peak_memory.h"

#include <fstream>
#include <string>

namespace bench {

void reset_peak_memory() { std::ofstream("/proc/self/clear_refs") << "5\n"; }

std::optional<std::size_t> peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string key; status >> key;) {
    std::size_t kibibytes = 0;
    if (key == "VmHWM:" && status >> kibibytes) return kibibytes * 1024;
    status.ignore(1 << 16, '\n');
  }
  return std::nullopt;
}

}  // namespace bench
