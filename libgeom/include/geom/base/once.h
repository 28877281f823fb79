#pragma once

// What is to be done once, by whoever comes first.

#include <atomic>
#include <mutex>

namespace geom {

// As std::call_once: threads may call at once, and all return when it is done; what throws is not
// done, and the next call tries again. But nothing of the C library stands between `f` and the
// caller: its frames cannot be unwound where memory is short, and the process would end.
class Once {
 public:
  template <class F>
  void call(const F& f) {
    if (done_.load(std::memory_order_acquire)) return;
    const std::scoped_lock lock(mutex_);
    if (done_.load(std::memory_order_relaxed)) return;
    f();
    done_.store(true, std::memory_order_release);
  }

 private:
  std::atomic<bool> done_ = false;
  std::mutex mutex_;
};

}  // namespace geom
