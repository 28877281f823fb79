#include "squares.h"

namespace plan {
namespace {

// Every second bit, from the lowest on, is one of `x`.
std::uint64_t spread(std::uint32_t value) {
  std::uint64_t x = value;
  x = (x | x << 16) & 0x0000ffff0000ffff;
  x = (x | x << 8) & 0x00ff00ff00ff00ff;
  x = (x | x << 4) & 0x0f0f0f0f0f0f0f0f;
  x = (x | x << 2) & 0x3333333333333333;
  return (x | x << 1) & 0x5555555555555555;
}

std::uint32_t gathered(std::uint64_t x) {
  x &= 0x5555555555555555;
  x = (x | x >> 1) & 0x3333333333333333;
  x = (x | x >> 2) & 0x0f0f0f0f0f0f0f0f;
  x = (x | x >> 4) & 0x00ff00ff00ff00ff;
  x = (x | x >> 8) & 0x0000ffff0000ffff;
  return static_cast<std::uint32_t>(x | x >> 16);
}

constexpr std::uint32_t kOrigin = 0x80000000u;

}  // namespace

std::uint64_t code_of(const Square& square) {
  return spread(static_cast<std::uint32_t>(square.column) ^ kOrigin) |
         spread(static_cast<std::uint32_t>(square.row) ^ kOrigin) << 1;
}

Square square_at(std::uint64_t code) {
  return {static_cast<std::int32_t>(gathered(code) ^ kOrigin),
          static_cast<std::int32_t>(gathered(code >> 1) ^ kOrigin)};
}

}  // namespace plan
