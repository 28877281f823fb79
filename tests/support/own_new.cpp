#include "support/own_new.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <utility>

namespace {

std::atomic<long> left{-1};  // allocations until the one; negative: none is
std::atomic<bool> reached_it{false};
std::function<bool()> what;

bool fails() {
  if (left.load(std::memory_order_relaxed) < 0 || left.fetch_sub(1) > 0) return false;
  reached_it = true;
  return !what();
}

void* allocated(std::size_t size) {
  if (!fails()) {
    if (void* const at = std::malloc(size ? size : 1)) return at;
  }
  if (const std::new_handler handler = std::get_new_handler()) handler();
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return allocated(size); }
void* operator new[](std::size_t size) { return allocated(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return allocated(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void* operator new[](std::size_t size, const std::nothrow_t& how) noexcept {
  return operator new(size, how);
}
void operator delete(void* at) noexcept { std::free(at); }
void operator delete(void* at, std::size_t) noexcept { std::free(at); }
void operator delete[](void* at) noexcept { std::free(at); }
void operator delete[](void* at, std::size_t) noexcept { std::free(at); }

namespace support {

AtNew::AtNew(long number, std::function<bool()> then) {
  what = std::move(then);
  reached_it = false;
  left = number;
}

AtNew::~AtNew() { left = -1; }

bool AtNew::reached() { return reached_it; }
long AtNew::to_go() { return left; }

}  // namespace support
