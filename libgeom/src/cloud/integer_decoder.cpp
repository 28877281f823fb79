#include "integer_decoder.h"

#include <algorithm>

namespace geom {
namespace {

constexpr unsigned kLeading = 8;

}  // namespace

IntegerDecoder::IntegerDecoder(unsigned bits, unsigned contexts)
    : bits_(bits), sizes_(contexts, SymbolModel(bits + 1)) {
  for (unsigned k = 1; k <= bits && k < 32; ++k) {
    leading_.emplace_back(1u << std::min(k, kLeading));
  }
}

// Of k bits, the numbers from -(2^k - 1) to -2^(k-1), then those from 2^(k-1) + 1 to 2^k.
std::uint32_t IntegerDecoder::correction(RangeDecoder& code, unsigned k) {
  if (k == 0) return code.bit(smallest_);
  if (k == 32) return 1u << 31;
  std::uint32_t c = code.symbol(leading_[k - 1]);
  if (k > kLeading) c = c << (k - kLeading) | code.bits(k - kLeading);
  return c >= 1u << (k - 1) ? c + 1 : c - ((1u << k) - 1);
}

std::int32_t IntegerDecoder::next(RangeDecoder& code, std::int32_t predicted, unsigned context) {
  last_ = code.symbol(sizes_[context]);
  const std::uint32_t sum = static_cast<std::uint32_t>(predicted) + correction(code, last_);
  return static_cast<std::int32_t>(bits_ < 32 ? sum & ((1u << bits_) - 1) : sum);
}

}  // namespace geom
