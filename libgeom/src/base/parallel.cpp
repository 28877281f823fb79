#include "geom/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace geom {

void parallel_for(std::size_t n, const Execution& run, const std::function<void(std::size_t)>& f) {
  std::atomic<std::size_t> next = 0;
  std::size_t done = 0;
  std::size_t failed_at = n;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto failed = [&](std::size_t i) noexcept {
    const std::lock_guard lock(mutex);
    if (i < failed_at) {
      failed_at = i;
      failure = std::current_exception();
    }
    next.store(n);
  };
  const auto work = [&]() noexcept {
    for (std::size_t i; (i = next.fetch_add(1)) < n;) {
      try {
        f(i);
        if (!run.progress) continue;
        const std::lock_guard lock(mutex);
        run.progress(++done, n);
      } catch (...) {
        failed(i);
      }
    }
  };
  std::vector<std::jthread> workers;
  const std::size_t count = std::min<std::size_t>(run.threads, n);
  try {
    for (std::size_t w = 1; w < count; ++w) workers.emplace_back(work);
  } catch (const std::system_error&) {  // no more threads: those that there are do the work
  } catch (const std::bad_alloc&) {
  }
  work();
  workers.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace geom
