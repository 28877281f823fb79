#pragma once

// Work that is done once, by the first thread that needs it.
//
// Example:
//   geom::Once once;
//   int made = 0;
//   for (int i = 0; i < 3; ++i) once.call([&] { ++made; });
//   assert(made == 1);

#include <atomic>
#include <mutex>

namespace geom {

// Like std::call_once: threads may call at once, and all return when `f` is done. If `f` throws,
// the next call tries again. Unlike std::call_once, no frame of the C library stands between `f`
// and the caller: such a frame cannot be unwound if memory is short, and the process would end.
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
