#pragma once

// The most memory this process has had resident, by Linux's own count.

#include <cstddef>
#include <optional>

namespace bench {

void reset_peak_memory();                  // to what is resident now, where the kernel lets us
std::optional<std::size_t> peak_memory();  // bytes, since then; nothing where it is not told

}  // namespace bench
