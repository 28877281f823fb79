#pragma once

// The range decoder of LAZ: symbols out of bytes, by models that adapt to what they have seen.
//
// Debian packages no LAZ library, so this one is ours, written from: A. Said, "Introduction to
// Arithmetic Coding - Theory and Practice", HPL-2004-76 (the coder, and models updated from time
// to time); M. Isenburg, "LASzip: lossless compression of LiDAR data", PE&RS 79(2), 2013; and the
// format as it is published, which fixes each constant below.

#include <cstdint>
#include <vector>

#include "byte_source.h"

namespace geom {

// How often each of `symbols` came, as parts of 2^15. It takes memory when it is first used.
class SymbolModel {
 public:
  static constexpr unsigned kBits = 15;

  explicit SymbolModel(unsigned symbols = 256) : symbols_(symbols) {}

  unsigned symbols() const { return symbols_; }

  void begin_if_new() {
    if (left_ == 0) begin();
  }

  // Where a symbol's part starts; `symbols()` has a start beyond all.
  unsigned start(unsigned symbol) const { return starts_[symbol]; }

  // The symbol whose part holds `target`, which is below 2^15.
  unsigned find(unsigned target) const {
    unsigned s = nearby_[target >> shift_];
    while (starts_[s + 1] <= target) ++s;
    return s;
  }

  void count(unsigned symbol) {
    ++counts_[symbol];
    if (--left_ == 0) update();
  }

 private:
  void begin();
  void update();

  unsigned symbols_;
  unsigned total_ = 0;
  unsigned cycle_ = 0;
  unsigned left_ = 0;  // symbols until the next update; 0: never used
  unsigned shift_ = kBits;
  std::vector<std::uint16_t> counts_;
  std::vector<std::uint16_t> starts_;
  std::vector<std::uint16_t> nearby_;  // by the leading bits of a target, a symbol not after it
};

// The same of one bit, in parts of 2^13.
struct BitModel {
  static constexpr unsigned kBits = 13;

  unsigned zeros = 1;
  unsigned total = 2;
  unsigned zero_part = 1u << (kBits - 1);
  unsigned cycle = 4;
  unsigned left = 4;

  void update();
};

// Bytes that no encoder writes throw InputError where they would lead outside of a model, and so
// does a source that ends.
class RangeDecoder {
 public:
  explicit RangeDecoder(ByteSource& bytes);

  unsigned symbol(SymbolModel& model) {
    model.begin_if_new();
    const std::uint32_t part = length_ >> SymbolModel::kBits;
    const std::uint32_t target = value_ / part;
    // The division leaves a rest, which belongs to the last symbol.
    constexpr std::uint32_t kLast = (1u << SymbolModel::kBits) - 1;
    const unsigned s = model.find(target < kLast ? target : kLast);
    const std::uint32_t low = model.start(s) * part;
    const std::uint32_t high = s + 1 < model.symbols() ? model.start(s + 1) * part : length_;
    value_ -= low;
    length_ = high - low;
    refill();
    model.count(s);
    return s;
  }

  unsigned bit(BitModel& model) {
    const std::uint32_t zeros = model.zero_part * (length_ >> BitModel::kBits);
    const bool one = value_ >= zeros;
    if (one) {
      value_ -= zeros;
      length_ -= zeros;
    } else {
      length_ = zeros;
      ++model.zeros;
    }
    refill();
    if (--model.left == 0) model.update();
    return one;
  }

  // `count` bits, 1 to 32, of no model.
  std::uint32_t bits(unsigned count);

  // Whether an encoder may have stopped here: it ends on a place near the start of its interval,
  // with the rest of the bytes 0. So a symbol too few, or too many, is often found where it takes no
  // byte of its own. Throws where not.
  void require_end() const;

 private:
  static constexpr std::uint32_t kShortest = 1u << 24;

  void refill() {
    while (length_ < kShortest) {
      value_ = value_ << 8 | bytes_.next();
      length_ <<= 8;
    }
  }

  // The place in an interval of `length_` numbers, below it always.
  ByteSource& bytes_;
  std::uint32_t value_ = 0;
  std::uint32_t length_ = 0xFFFFFFFF;
};

}  // namespace geom
