#include "geom/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace geom {

void parallel_for(std::size_t n, const Execution& run, const std::function<void(std::size_t)>& f) {
  std::atomic<std::size_t> next = 0;
  std::size_t done = 0;
  std::size_t failed_at = n;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t i; (i = next.fetch_add(1)) < n;) {
      std::exception_ptr caught;
      try {
        f(i);
      } catch (...) {
        caught = std::current_exception();
      }
      if (!caught && !run.progress) continue;
      const std::lock_guard lock(mutex);
      if (caught && i < failed_at) {
        failed_at = i;
        failure = caught;
      }
      if (caught) next.store(n);
      if (run.progress) run.progress(++done, n);
    }
  };
  std::vector<std::jthread> workers;
  const std::size_t count = std::min<std::size_t>(run.threads, n);
  for (std::size_t w = 1; w < count; ++w) workers.emplace_back(work);
  work();
  workers.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace geom
