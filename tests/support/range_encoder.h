#pragma once

// The encoder that belongs to LAZ's range decoder: slow and plain, for files of tests.
// A. Said, "Introduction to Arithmetic Coding - Theory and Practice", HPL-2004-76.

#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace support {

struct EncoderModel {
  explicit EncoderModel(unsigned symbols = 256)
      : counts(symbols, 1), cycle((symbols + 6) / 2), left(cycle) {
    spread();
  }

  void count(unsigned symbol) {
    ++counts[symbol];
    if (--left > 0) return;
    if (total() > 32768) {
      for (unsigned& c : counts) c = (c + 1) / 2;
    }
    spread();
    const auto symbols = static_cast<unsigned>(counts.size());
    left = cycle = std::min(5 * cycle / 4, 8 * (symbols + 6));
  }

  unsigned total() const { return std::accumulate(counts.begin(), counts.end(), 0u); }

  void spread() {
    starts.clear();
    const unsigned scale = (1u << 31) / total();
    unsigned sum = 0;
    for (const unsigned c : counts) {
      starts.push_back(scale * sum >> 16);
      sum += c;
    }
  }

  std::vector<unsigned> counts;
  std::vector<unsigned> starts;  // in parts of 2^15
  unsigned cycle;
  unsigned left;
};

struct EncoderBitModel {
  unsigned zeros = 1;
  unsigned total = 2;
  unsigned zero_part = 1u << 12;
  unsigned cycle = 4;
  unsigned left = 4;

  void count(bool one) {
    if (!one) ++zeros;
    if (--left > 0) return;
    total += cycle;
    if (total > 8192) {
      total = (total + 1) / 2;
      zeros = (zeros + 1) / 2;
      if (zeros == total) ++total;
    }
    zero_part = (1u << 31) / total * zeros >> 18;
    left = cycle = std::min(5 * cycle / 4, 64u);
  }
};

class RangeEncoder {
 public:
  void symbol(EncoderModel& model, unsigned s) {
    const std::uint32_t part = length_ >> 15;
    const std::uint32_t low = model.starts[s] * part;
    const bool last = s + 1 == model.starts.size();
    narrow(low, last ? length_ - low : model.starts[s + 1] * part - low);
    model.count(s);
  }

  void bit(EncoderBitModel& model, bool one) {
    const std::uint32_t zeros = model.zero_part * (length_ >> 13);
    narrow(one ? zeros : 0, one ? length_ - zeros : zeros);
    model.count(one);
  }

  void bits(unsigned count, std::uint32_t value) {
    if (count > 19) {
      bits(16, value & 0xFFFF);
      value >>= 16;
      count -= 16;
    }
    const std::uint32_t part = length_ >> count;
    narrow(value * part, part);
  }

  // The bytes; as many as the decoder reads.
  std::string finish() {
    const bool long_interval = length_ > 2u << 24;
    narrow(long_interval ? 1u << 24 : 1u << 23, long_interval ? 1u << 23 : 1u << 15);
    return out_ + std::string(long_interval ? 3 : 2, '\0');
  }

 private:
  void narrow(std::uint32_t low, std::uint32_t length) {
    const std::uint32_t base = base_ + low;
    if (base < base_) {
      std::size_t i = out_.size();
      while (out_[--i] == '\xFF') out_[i] = 0;
      ++out_[i];
    }
    base_ = base;
    length_ = length;
    while (length_ < 1u << 24) {
      out_ += static_cast<char>(base_ >> 24);
      base_ <<= 8;
      length_ <<= 8;
    }
  }

  std::string out_;
  std::uint32_t base_ = 0;
  std::uint32_t length_ = 0xFFFFFFFF;
};

// Integers by their difference from what is predicted (Isenburg 2013).
class IntegerEncoder {
 public:
  explicit IntegerEncoder(unsigned bits, unsigned contexts = 1)
      : bits_(bits), sizes_(contexts, EncoderModel(bits + 1)) {
    for (unsigned k = 1; k <= bits && k < 32; ++k) leading_.emplace_back(1u << std::min(k, 8u));
  }

  unsigned k() const { return k_; }

  void put(RangeEncoder& code, std::int64_t predicted, std::int64_t real, unsigned context = 0) {
    const std::int64_t range = std::int64_t{1} << bits_;
    std::int64_t c = (real - predicted) % range;
    if (c < -range / 2) c += range;
    if (c >= range / 2) c -= range;
    const auto size = static_cast<std::uint64_t>(c <= 0 ? -c : c - 1);
    for (k_ = 0; size >> k_ != 0; ++k_) {
    }
    code.symbol(sizes_[context], k_);
    if (k_ == 0) code.bit(smallest_, c == 1);
    if (k_ == 0 || k_ == 32) return;
    const auto at = static_cast<std::uint32_t>(c < 0 ? c + (std::int64_t{1} << k_) - 1 : c - 1);
    const unsigned rest = k_ > 8 ? k_ - 8 : 0;
    code.symbol(leading_[k_ - 1], at >> rest);
    if (rest > 0) code.bits(rest, at & ((1u << rest) - 1));
  }

 private:
  unsigned bits_;
  unsigned k_ = 0;
  EncoderBitModel smallest_;
  std::vector<EncoderModel> sizes_;
  std::vector<EncoderModel> leading_;
};

}  // namespace support
