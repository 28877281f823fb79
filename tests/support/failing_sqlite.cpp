#include "support/failing_sqlite.h"

#include <link.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace {

// The library's code: where its calls of malloc come from.
struct Code {
  std::uintptr_t begin = 0;
  std::uintptr_t end = 0;
};

int take_code(dl_phdr_info* library, std::size_t, void* out) {
  if (!std::strstr(library->dlpi_name, "libsqlite3.so")) return 0;
  for (int i = 0; i < library->dlpi_phnum; ++i) {
    const auto& part = library->dlpi_phdr[i];
    if (part.p_type != PT_LOAD || !(part.p_flags & PF_X)) continue;
    const std::uintptr_t begin = library->dlpi_addr + part.p_vaddr;
    *static_cast<Code*>(out) = {begin, begin + part.p_memsz};
  }
  return 1;
}

Code code;
std::atomic<long> left{-1};  // allocations until one fails; negative: none will
std::atomic<bool> failed{false};

}  // namespace

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SKYWAY_OWN_MALLOC 1

namespace {

bool fails(void* caller) {
  if (left.load(std::memory_order_relaxed) < 0) return false;
  const auto from = reinterpret_cast<std::uintptr_t>(caller);
  if (from < code.begin || from >= code.end || left.fetch_sub(1) > 0) return false;
  failed = true;
  errno = ENOMEM;
  return true;
}

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_realloc(void*, std::size_t);

void* malloc(std::size_t size) {
  return fails(__builtin_return_address(0)) ? nullptr : __libc_malloc(size);
}
void* realloc(void* at, std::size_t size) {
  return fails(__builtin_return_address(0)) ? nullptr : __libc_realloc(at, size);
}

}  // extern "C"

#endif

namespace support {

FailingSqlite::FailingSqlite(long number) {
  code = {};
  dl_iterate_phdr(take_code, &code);
  failed = false;
  left = number;
}

FailingSqlite::~FailingSqlite() { left = -1; }

bool FailingSqlite::works_here() {
#ifdef SKYWAY_OWN_MALLOC
  return true;
#else
  return false;
#endif
}

bool FailingSqlite::any_failed() { return failed; }

}  // namespace support
