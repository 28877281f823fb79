#include "huge_arena.h"

#include <sys/mman.h>

#include <algorithm>
#include <limits>
#include <new>

namespace geom {
namespace {

constexpr std::size_t kHuge = std::size_t{1} << 21;  // bytes of a large page
constexpr std::size_t kMost = std::size_t{1} << 26;

std::size_t rounded_up(std::size_t bytes, std::size_t unit) {
  if (bytes > std::numeric_limits<std::size_t>::max() - unit) throw std::bad_alloc();
  return (bytes + unit - 1) / unit * unit;
}

}  // namespace

void* HugeArena::take(std::size_t bytes) {
  bytes = rounded_up(bytes, kAlign);
  const std::lock_guard lock(mutex_);
  if (bytes > left_) add_chunk(bytes);
  std::byte* const out = free_;
  free_ += bytes;
  left_ -= bytes;
  return out;
}

void HugeArena::add_chunk(std::size_t bytes) {
  const std::size_t unit = chunks_.empty() ? kAlign : kHuge;
  const std::size_t size = rounded_up(std::max(bytes, next_size_), unit);
  chunks_.reserve(chunks_.size() + 1);
  auto* const chunk = static_cast<std::byte*>(std::aligned_alloc(unit, size));
  if (!chunk) throw std::bad_alloc();
  chunks_.emplace_back(chunk);
  free_ = chunk;
  left_ = size;
  next_size_ = std::clamp(2 * size, kHuge, kMost);
#ifdef MADV_HUGEPAGE
  // A wish: small pages do where the system has no large ones.
  if (unit == kHuge) static_cast<void>(madvise(chunk, size, MADV_HUGEPAGE));
#endif
}

}  // namespace geom
