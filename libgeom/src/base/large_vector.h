#pragma once

// Vectors that all threads fill.

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geom/base/parallel.h"

namespace geom {

// Asks the system for the pages that lie wholly in this memory, on all threads. If the system
// cannot give them together, each page comes when it is first written.
inline void ask_for_pages(void* begin, std::size_t bytes, const Execution& run) {
#ifdef MADV_POPULATE_WRITE
  constexpr std::size_t kTogether = std::size_t{1} << 22;
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const std::uintptr_t first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page;
  const std::uintptr_t last = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / page * page;
  if (run.threads <= 1 || last <= first + kTogether) return;
  parallel_for((last - first + kTogether - 1) / kTogether, {run.threads, {}}, [&](std::size_t k) {
    const std::uintptr_t from = first + k * kTogether;
    static_cast<void>(madvise(reinterpret_cast<void*>(from), std::min(kTogether, last - from),
                              MADV_POPULATE_WRITE));
  });
#endif
}

// Makes an empty vector one of `size` values.
template <class T>
void resize_large(std::vector<T>& empty, std::size_t size, const Execution& run) {
  empty.reserve(size);
  ask_for_pages(empty.data(), size * sizeof(T), run);
  empty.resize(size);
}

}  // namespace geom
