#include "support/failing_memory.h"

#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SKYWAY_SANITIZED 1  // their malloc stays: what C++ allocates is all that fails then
#endif

namespace {

std::atomic<long> left{-1};  // allocations until one fails; negative: none will
std::atomic<bool> sticky{false};
std::atomic<bool> failed{false};

bool fails() {
  if (left.load(std::memory_order_relaxed) < 0) return false;
  if (left.fetch_sub(1) > 0) return false;
  if (sticky) left = 0;
  failed = true;
  errno = ENOMEM;
  return true;
}

}  // namespace

#ifdef SKYWAY_SANITIZED

void* operator new(std::size_t size) {
  void* const at = fails() ? nullptr : std::malloc(size);
  if (!at) throw std::bad_alloc();
  return at;
}
void* operator new[](std::size_t size) { return operator new(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return fails() ? nullptr : std::malloc(size);
}
void* operator new[](std::size_t size, const std::nothrow_t& how) noexcept {
  return operator new(size, how);
}
void operator delete(void* at) noexcept { std::free(at); }
void operator delete(void* at, std::size_t) noexcept { std::free(at); }
void operator delete[](void* at) noexcept { std::free(at); }
void operator delete[](void* at, std::size_t) noexcept { std::free(at); }

#else

// glibc's manual ("Replacing malloc") names what must be replaced together. What is allocated is
// glibc's own, so that its free() goes with it.
extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) { return fails() ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t n, std::size_t size) { return fails() ? nullptr : __libc_calloc(n, size); }
void* realloc(void* at, std::size_t size) { return fails() ? nullptr : __libc_realloc(at, size); }
void* memalign(std::size_t alignment, std::size_t size) {
  return fails() ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  void* const at = memalign(alignment, size);
  if (!at) return ENOMEM;
  *out = at;
  return 0;
}
void* mmap(void* at, std::size_t size, int protection, int flags, int file, off_t offset) noexcept {
  if (fails()) return MAP_FAILED;
  return reinterpret_cast<void*>(syscall(SYS_mmap, at, size, protection, flags, file, offset));
}

}  // extern "C"

#endif

namespace support {

FailingMemory::FailingMemory(long first, Then then) {
  failed = false;
  sticky = then == Then::fails;
  left = first;
}

FailingMemory::~FailingMemory() { left = -1; }

bool FailingMemory::any_failed() { return failed; }

}  // namespace support
