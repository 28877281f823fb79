#include "base/watched_memory.h"

#include <atomic>
#include <mutex>
#include <new>

namespace geom {
namespace {

std::atomic<unsigned long> failed = 0;
std::atomic<std::new_handler> replaced = nullptr;

// Operator new calls it where malloc gave nothing, before it throws.
void count_failure() {
  ++failed;
  if (const std::new_handler before = replaced) return before();
  throw std::bad_alloc();
}

std::mutex guard;  // of these two
unsigned watching = 0;

}  // namespace

WatchedMemory::WatchedMemory() : failed_before_(failed) {
  const std::lock_guard lock(guard);
  if (watching++ == 0) replaced = std::set_new_handler(count_failure);
}

WatchedMemory::~WatchedMemory() {
  const std::lock_guard lock(guard);
  if (--watching == 0) std::set_new_handler(replaced);
}

void WatchedMemory::require_enough() const {
  if (failed != failed_before_) throw std::bad_alloc();
}

void note_failed_allocation() noexcept { ++failed; }

}  // namespace geom
