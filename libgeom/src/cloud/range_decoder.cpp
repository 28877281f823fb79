#include "range_decoder.h"

#include <algorithm>

namespace geom {
namespace {

constexpr unsigned kRawBits = 19;  // more are taken in two parts

}  // namespace

void SymbolModel::begin() {
  unsigned buckets = 0;
  while ((2u << buckets) < symbols_) ++buckets;
  shift_ = kBits - buckets;
  counts_.assign(symbols_, 1);
  starts_.assign(symbols_ + 1, 0xFFFF);
  nearby_.assign(std::size_t{1} << buckets, 0);
  cycle_ = symbols_;
  update();
  left_ = cycle_ = (symbols_ + 6) / 2;
}

void SymbolModel::update() {
  total_ += cycle_;
  if (total_ > 1u << kBits) {
    total_ = 0;
    for (std::uint16_t& count : counts_) {
      count = static_cast<std::uint16_t>((count + 1) / 2);
      total_ += count;
    }
  }
  const std::uint32_t scale = (1u << 31) / total_;
  std::uint32_t sum = 0;
  std::size_t bucket = 0;
  for (unsigned s = 0; s < symbols_; ++s) {
    starts_[s] = static_cast<std::uint16_t>(scale * sum >> (31 - kBits));
    sum += counts_[s];
    // The buckets that begin before this symbol and not before the last one.
    for (; bucket < nearby_.size() && bucket << shift_ < starts_[s]; ++bucket) {
      nearby_[bucket] = static_cast<std::uint16_t>(s - 1);
    }
  }
  for (; bucket < nearby_.size(); ++bucket) {
    nearby_[bucket] = static_cast<std::uint16_t>(symbols_ - 1);
  }
  left_ = cycle_ = std::min(5 * cycle_ / 4, 8 * (symbols_ + 6));
}

void BitModel::update() {
  total += cycle;
  if (total > 1u << kBits) {
    total = (total + 1) / 2;
    zeros = (zeros + 1) / 2;
    if (zeros == total) ++total;
  }
  zero_part = zeros * ((1u << 31) / total) >> (31 - kBits);
  left = cycle = std::min(5 * cycle / 4, 64u);
}

RangeDecoder::RangeDecoder(ByteSource& bytes) : bytes_(bytes) {
  for (int i = 0; i < 4; ++i) value_ = value_ << 8 | bytes_.next();
  if (value_ == length_) {
    bytes_.refuse(
        {.says = "its compressed points are damaged: they begin with bytes that no writer makes"});
  }
}

// The encoder of HPL-2004-76 goes on by 2^24 and writes one byte, or by 2^23 and writes two, by the
// length that is left; bytes that it does not write are 0.
void RangeDecoder::require_end() const {
  const bool one_byte = length_ > 2 * kShortest;
  const std::uint32_t most = one_byte ? kShortest : kShortest / 2;
  const std::uint32_t lost = one_byte ? kShortest : 1u << 16;
  if (value_ > most || value_ + lost <= most) {
    bytes_.refuse(
        {.says = "its compressed points go on where they should end",
         .advice = "the file is damaged, or holds more or fewer points than its header says"});
  }
}

std::uint32_t RangeDecoder::bits(unsigned count) {
  std::uint32_t low = 0;
  unsigned shift = 0;
  if (count > kRawBits) {
    low = bits(16);
    shift = 16;
    count -= 16;
  }
  length_ >>= count;
  const std::uint32_t found = value_ / length_;
  if (found >> count != 0) {
    bytes_.refuse(
        {.says = "its compressed points are damaged: they hold a number beyond its bits"});
  }
  value_ -= found * length_;
  refill();
  return found << shift | low;
}

}  // namespace geom
