#include "laz_point10.h"

#include <algorithm>
#include <array>

#include "integer_decoder.h"
#include "streaming_median.h"

namespace geom {
namespace {

using Bytes = std::span<const unsigned char>;

constexpr std::size_t kReturns = 14;
constexpr std::size_t kClass = 15;
constexpr std::size_t kUserData = 17;

std::int32_t wrapped_sum(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}

// Bytes that changed, each predicted by the one before it: a model for each.
class ChangedByte {
 public:
  explicit ChangedByte(std::uint8_t first) : value_(first), models_(256) {}

  std::uint8_t value() const { return value_; }
  void next(RangeDecoder& code) {
    value_ = static_cast<std::uint8_t>(code.symbol(models_[value_]));
  }

 private:
  std::uint8_t value_;
  std::vector<SymbolModel> models_;
};

// By the number of returns and the number of the return: which points resemble each other.
constexpr std::uint8_t kReturnMap[8][8] = {
    {15, 14, 13, 12, 11, 10, 9, 8},  {14, 0, 1, 3, 6, 10, 10, 9},
    {13, 1, 2, 4, 7, 11, 11, 10},    {12, 3, 4, 5, 8, 12, 12, 11},
    {11, 6, 7, 8, 9, 13, 13, 12},    {10, 10, 11, 12, 13, 14, 14, 13},
    {9, 10, 11, 12, 13, 14, 15, 14}, {8, 9, 10, 11, 12, 13, 14, 15},
};

class Point10Version2 : public LazItemDecoder {
 public:
  explicit Point10Version2(const LazPoint& first, Bytes raw)
      : last_(first), returns_(raw[kReturns]), class_(raw[kClass]), user_data_(raw[kUserData]) {}

  void next(RangeDecoder& code, LazPoint& point) override {
    const unsigned changed = code.symbol(changed_);
    if (changed & 32) returns_.next(code);
    const unsigned number = returns_.value() & 7;
    const unsigned of = returns_.value() >> 3 & 7;
    const unsigned kind = kReturnMap[of][number];
    if (changed & 16) intensity_.next(code, 0, std::min(kind, 3u));
    if (changed & 8) class_.next(code);
    if (changed & 4) code.symbol(scan_angle_[returns_.value() >> 6 & 1]);
    if (changed & 2) user_data_.next(code);
    if (changed & 1) source_.next(code, 0);
    place(code, kind, number > of ? number - of : of - number, of == 1);
    last_.cls = class_.value() & 0x1f;
    point = last_;
  }

 private:
  void place(RangeDecoder& code, unsigned kind, unsigned level, unsigned single) {
    const std::int32_t dx = dx_.next(code, x_steps_[kind].get(), single);
    x_steps_[kind].add(dx);
    last_.x = wrapped_sum(last_.x, dx);
    unsigned k = dx_.correction_bits();
    const std::int32_t dy = dy_.next(code, y_steps_[kind].get(), single + (k < 20 ? k & ~1u : 20));
    y_steps_[kind].add(dy);
    last_.y = wrapped_sum(last_.y, dy);
    k = (k + dy_.correction_bits()) / 2;
    last_.z = z_.next(code, heights_[level], single + (k < 18 ? k & ~1u : 18));
    heights_[level] = last_.z;
  }

  LazPoint last_;
  ChangedByte returns_;
  ChangedByte class_;
  ChangedByte user_data_;
  SymbolModel changed_{64};
  IntegerDecoder intensity_{16, 4};
  std::array<SymbolModel, 2> scan_angle_;
  IntegerDecoder source_{16};
  IntegerDecoder dx_{32, 2};
  IntegerDecoder dy_{32, 22};
  IntegerDecoder z_{32, 20};
  std::array<StreamingMedian, 16> x_steps_;
  std::array<StreamingMedian, 16> y_steps_;
  std::array<std::int32_t, 8> heights_{};
};

class Point10Version1 : public LazItemDecoder {
 public:
  explicit Point10Version1(const LazPoint& first, Bytes raw)
      : last_(first), returns_(raw[kReturns]), class_(raw[kClass]), user_data_(raw[kUserData]) {}

  void next(RangeDecoder& code, LazPoint& point) override {
    const std::int32_t dx = dx_.next(code, median(x_steps_));
    unsigned k = dx_.correction_bits();
    const std::int32_t dy = dy_.next(code, median(y_steps_), std::min(k, 19u));
    k = (k + dy_.correction_bits()) / 2;
    last_.x = wrapped_sum(last_.x, dx);
    last_.y = wrapped_sum(last_.y, dy);
    last_.z = z_.next(code, last_.z, std::min(k, 19u));
    x_steps_[step_] = dx;
    y_steps_[step_] = dy;
    step_ = (step_ + 1) % 3;
    const unsigned changed = code.symbol(changed_);
    if (changed & 32) intensity_.next(code, 0);
    if (changed & 16) returns_.next(code);
    if (changed & 8) class_.next(code);
    if (changed & 4) scan_angle_.next(code, 0, k < 3);
    if (changed & 2) user_data_.next(code);
    if (changed & 1) source_.next(code, 0);
    last_.cls = class_.value() & 0x1f;
    point = last_;
  }

 private:
  static std::int32_t median(const std::array<std::int32_t, 3>& v) {
    return std::max(std::min(v[0], v[1]), std::min(std::max(v[0], v[1]), v[2]));
  }

  LazPoint last_;
  ChangedByte returns_;
  ChangedByte class_;
  ChangedByte user_data_;
  SymbolModel changed_{64};
  IntegerDecoder intensity_{16};
  IntegerDecoder scan_angle_{8, 2};
  IntegerDecoder source_{16};
  IntegerDecoder dx_{32};
  IntegerDecoder dy_{32, 20};
  IntegerDecoder z_{32, 20};
  std::array<std::int32_t, 3> x_steps_{};
  std::array<std::int32_t, 3> y_steps_{};
  std::size_t step_ = 0;
};

}  // namespace

std::unique_ptr<LazItemDecoder> point10_decoder(unsigned version, const LazPoint& first,
                                                Bytes raw) {
  if (version == 1) return std::make_unique<Point10Version1>(first, raw);
  return std::make_unique<Point10Version2>(first, raw);
}

}  // namespace geom
