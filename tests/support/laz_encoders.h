#pragma once

// The items of LAZ points, written as M. Isenburg's paper of 2013 and the published format have
// them. What a map does not need is chance: times, colours, extra bytes and waveforms take any
// turn that the code has.

#include <algorithm>
#include <array>

#include "support/random_city.h"
#include "support/range_encoder.h"

namespace support {

struct LazFilePoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;
  std::uint8_t cls = 0;
  unsigned number = 1;  // of the return
  unsigned of = 1;      // returns
  unsigned channel = 0;
  bool new_time = false;
};

class ItemEncoder {
 public:
  virtual ~ItemEncoder() = default;
  virtual void put(RangeEncoder& code, const LazFilePoint& p) = 0;
};

inline unsigned chance(Random& random, unsigned below) {
  return static_cast<unsigned>(random.below(static_cast<int>(below)));
}

inline std::int32_t any_int(Random& random) {
  const unsigned bits = chance(random, 33);
  const std::uint64_t value =
      (std::uint64_t{chance(random, 1u << 16)} << 16) | chance(random, 1u << 16);
  return static_cast<std::int32_t>(bits == 0 ? 0
                                             : static_cast<std::uint32_t>(value) >> (32 - bits));
}

// Five numbers in order, and which end the next one drives out.
struct EncoderMedian {
  std::array<std::int32_t, 5> v{};
  bool largest = true;
  void add(std::int32_t n) {
    const std::int32_t middle = v[2];
    v[largest ? 4 : 0] = n;
    std::sort(v.begin(), v.end());
    largest = largest ? n < middle : n <= middle;
  }
};

inline std::int32_t minus(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

inline std::uint8_t returns_byte(const LazFilePoint& p) {
  return static_cast<std::uint8_t>((p.number & 7) | (p.of & 7) << 3 | (p.x & 3) << 6);
}

class Point10Encoder : public ItemEncoder {
 public:
  Point10Encoder(unsigned version, const LazFilePoint& first, Random& random)
      : version_(version), last_(first), random_(random) {}

  void put(RangeEncoder& code, const LazFilePoint& p) override {
    if (version_ == 1) place1(code, p);
    const bool returns = returns_byte(p) != returns_byte(last_);
    const bool cls = p.cls != last_.cls;
    const unsigned others = chance(random_, 16);  // intensity, angle, user data, source
    if (version_ == 1) {
      code.symbol(changed_, (others & 1) * 32 + returns * 16u + cls * 8u + (others >> 1 & 7));
      if (others & 1) intensity1_.put(code, 7, any_int(random_) & 0xFFFF);
      if (returns) byte(code, 0, returns_byte(last_), returns_byte(p));
      if (cls) byte(code, 1, last_.cls, p.cls);
      if (others & 8) angle_.put(code, 0, chance(random_, 256), k_ < 3);
    } else {
      code.symbol(changed_, returns * 32u + (others & 1) * 16 + cls * 8u + (others >> 1 & 7));
      if (returns) byte(code, 0, returns_byte(last_), returns_byte(p));
      if (others & 1) intensity_.put(code, 7, any_int(random_) & 0xFFFF, std::min(kind(p), 3u));
      if (cls) byte(code, 1, last_.cls, p.cls);
      if (others & 8) code.symbol(angles_[returns_byte(p) >> 6 & 1], chance(random_, 256));
    }
    if (others & 4) {
      const auto next = static_cast<std::uint8_t>(chance(random_, 256));
      byte(code, 2, user_, next);
      user_ = next;
    }
    if (others & 2) source_.put(code, 9, any_int(random_) & 0xFFFF);
    if (version_ == 2) place2(code, p);
    last_ = p;
  }

 private:
  void byte(RangeEncoder& code, unsigned which, std::uint8_t before, std::uint8_t now) {
    code.symbol(bytes_[which * 256u + before], now);
  }

  static unsigned kind(const LazFilePoint& p) {
    constexpr unsigned kKind[8][8] = {
        {15, 14, 13, 12, 11, 10, 9, 8},  {14, 0, 1, 3, 6, 10, 10, 9},
        {13, 1, 2, 4, 7, 11, 11, 10},    {12, 3, 4, 5, 8, 12, 12, 11},
        {11, 6, 7, 8, 9, 13, 13, 12},    {10, 10, 11, 12, 13, 14, 14, 13},
        {9, 10, 11, 12, 13, 14, 15, 14}, {8, 9, 10, 11, 12, 13, 14, 15}};
    return kKind[p.of & 7][p.number & 7];
  }

  void place1(RangeEncoder& code, const LazFilePoint& p) {
    const auto middle = [](std::array<std::int32_t, 3> v) {
      std::sort(v.begin(), v.end());
      return v[1];
    };
    const std::int32_t dx = minus(p.x, last_.x);
    const std::int32_t dy = minus(p.y, last_.y);
    dx_.put(code, middle(x3_), dx);
    dy_.put(code, middle(y3_), dy, std::min(dx_.k(), 19u));
    k_ = (dx_.k() + dy_.k()) / 2;
    z_.put(code, last_.z, p.z, std::min(k_, 19u));
    x3_[turn_ % 3] = dx;
    y3_[turn_++ % 3] = dy;
  }

  void place2(RangeEncoder& code, const LazFilePoint& p) {
    const unsigned m = kind(p);
    const unsigned one = (p.of & 7) == 1;
    const auto level = static_cast<std::size_t>(
        std::abs(static_cast<int>(p.of & 7) - static_cast<int>(p.number & 7)));
    const std::int32_t dx = minus(p.x, last_.x);
    const std::int32_t dy = minus(p.y, last_.y);
    dx_.put(code, x5_[m].v[2], dx, one);
    dy_.put(code, y5_[m].v[2], dy, one + std::min(dx_.k() / 2 * 2, 20u));
    z_.put(code, heights_[level], p.z, one + std::min((dx_.k() + dy_.k()) / 4 * 2, 18u));
    x5_[m].add(dx);
    y5_[m].add(dy);
    heights_[level] = p.z;
  }

  unsigned version_;
  LazFilePoint last_;
  Random& random_;
  std::uint8_t user_ = 0;
  unsigned k_ = 0;
  unsigned turn_ = 0;
  EncoderModel changed_{64};
  std::vector<EncoderModel> bytes_ = std::vector<EncoderModel>(768);
  std::array<EncoderModel, 2> angles_;
  IntegerEncoder intensity_{16, 4}, intensity1_{16}, angle_{8, 2}, source_{16};
  IntegerEncoder dx_{32, 2}, dy_{32, 22}, z_{32, 20};
  std::array<std::int32_t, 3> x3_{}, y3_{};
  std::array<EncoderMedian, 16> x5_, y5_;
  std::array<std::int32_t, 8> heights_{};
};

class GpsTimeEncoder : public ItemEncoder {
 public:
  GpsTimeEncoder(unsigned version, Random& random)
      : version_(version),
        random_(random),
        times_(version == 1 ? 512 : 516),
        after_none_(version == 1 ? 3 : 6) {}

  void put(RangeEncoder& code, const LazFilePoint&) override {
    if (version_ == 1) return put1(code);
    while (put2(code)) {
    }
  }

 private:
  std::int32_t step(RangeEncoder& code, std::int32_t predicted, unsigned context) {
    const std::int32_t real = any_int(random_);
    difference_.put(code, predicted, real, context);
    return real;
  }

  void whole1(RangeEncoder& code) {
    for (int i = 0; i < 2; ++i) code.bits(32, static_cast<std::uint32_t>(any_int(random_)));
  }

  unsigned any_times(std::initializer_list<unsigned> marks, unsigned below) {
    const unsigned i = chance(random_, static_cast<unsigned>(marks.size()) + 1);
    return i < marks.size() ? marks.begin()[i] : chance(random_, below);
  }

  void seldom(std::int32_t to) {
    if (++extremes_[now_] <= 3) return;
    usual_[now_] = to;
    extremes_[now_] = 0;
  }

  std::int32_t times_usual(std::int32_t n) const {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(n) *
                                     static_cast<std::uint32_t>(usual_[now_]));
  }

  void put1(RangeEncoder& code) {
    if (usual_[0] == 0) {
      const unsigned how = chance(random_, 3);
      code.symbol(after_none_, how);
      if (how == 1) usual_[0] = step(code, 0, 0);
      if (how == 2) whole1(code);
      return;
    }
    const unsigned n = any_times({0, 0, 1, 2, 20, 60, 509, 509, 510, 511}, 512);
    code.symbol(times_, n);
    if (n == 510) whole1(code);
    if (n >= 510) return;
    if (n == 0) return seldom(step(code, usual_[0] / 4, 2));
    const std::int32_t to = step(code, times_usual(static_cast<std::int32_t>(n)),
                                 n == 1   ? 1
                                 : n < 10 ? 3
                                 : n < 50 ? 4
                                          : 5);
    if (n == 509) seldom(to);
    if (n != 1) return;
    usual_[0] = to;
    extremes_[0] = 0;
  }

  bool other2(unsigned by) {
    now_ = (now_ + by) % 4;
    return true;
  }

  void whole2(RangeEncoder& code) {
    step(code, 0, 8);
    code.bits(32, static_cast<std::uint32_t>(any_int(random_)));
    next_ = (next_ + 1) % 4;
    now_ = next_;
    usual_[now_] = 0;
    extremes_[now_] = 0;
  }

  bool put2(RangeEncoder& code) {
    if (usual_[now_] == 0) {
      const unsigned how = chance(random_, 6);
      code.symbol(after_none_, how);
      if (how == 1) usual_[now_] = step(code, 0, 0);
      if (how == 1) extremes_[now_] = 0;
      if (how == 2) whole2(code);
      return how > 2 && other2(how - 2);
    }
    const unsigned n = any_times({0, 0, 1, 1, 2, 12, 500, 500, 505, 510, 510, 511, 512, 514}, 516);
    code.symbol(times_, n);
    if (n == 0) seldom(step(code, 0, 7));
    if (n == 1) {
      step(code, usual_[now_], 1);
      extremes_[now_] = 0;
    }
    if (n > 1 && n < 500) step(code, times_usual(static_cast<std::int32_t>(n)), n < 10 ? 2 : 3);
    if (n == 500) seldom(step(code, times_usual(500), 4));
    if (n > 500 && n < 510) step(code, times_usual(500 - static_cast<std::int32_t>(n)), 5);
    if (n == 510) seldom(step(code, times_usual(-10), 6));
    if (n == 512) whole2(code);
    return n > 512 && other2(n - 512);
  }

  unsigned version_;
  Random& random_;
  EncoderModel times_;
  EncoderModel after_none_;
  IntegerEncoder difference_{32, 9};
  std::array<std::int32_t, 4> usual_{};
  std::array<unsigned, 4> extremes_{};
  unsigned now_ = 0;
  unsigned next_ = 0;
};

// Colours, extra bytes and waveforms.
class OtherEncoder : public ItemEncoder {
 public:
  OtherEncoder(char kind, unsigned version, unsigned count, Random& random)
      : kind_(kind),
        version_(version),
        count_(count),
        random_(random),
        changed_(version == 1 ? 64 : 128),
        models_(std::max(6u, count)),
        byte_(8, std::max(6u, count)) {}

  void put(RangeEncoder& code, const LazFilePoint&) override {
    if (kind_ == 'w') return wave(code);
    unsigned changed = ~0u;
    if (kind_ == 'c') code.symbol(changed_, changed = chance(random_, version_ == 1 ? 64 : 128));
    const bool grey = kind_ == 'c' && version_ == 2 && !(changed & 64);
    for (unsigned turn = 0; turn < count_; ++turn) {
      // Version 2 of colours has the upper green byte after the lower blue one.
      const unsigned i =
          kind_ == 'c' && version_ == 2 && (turn == 3 || turn == 4) ? 7 - turn : turn;
      if (kind_ == 'c' && (!(changed >> i & 1) || (grey && i >= 2))) continue;
      if (version_ == 1) byte_.put(code, 0, chance(random_, 256), i);
      if (version_ == 2) code.symbol(models_[i], chance(random_, 256));
    }
  }

 private:
  void wave(RangeEncoder& code) {
    code.symbol(models_[0], chance(random_, 256));
    const unsigned next = chance(random_, 4);
    code.symbol(offsets_[offset_], next);
    offset_ = next;
    if (next == 2) numbers_[0].put(code, 0, any_int(random_));
    for (int i = 0; next == 3 && i < 2; ++i) {
      code.bits(32, static_cast<std::uint32_t>(any_int(random_)));
    }
    numbers_[1].put(code, 0, any_int(random_));
    numbers_[2].put(code, 0, any_int(random_));
    for (const unsigned i : {0u, 1u, 2u}) numbers_[3].put(code, 0, any_int(random_), i);
  }

  char kind_;
  unsigned version_;
  unsigned count_;
  Random& random_;
  EncoderModel changed_;
  std::vector<EncoderModel> models_;
  IntegerEncoder byte_;
  unsigned offset_ = 0;
  std::vector<EncoderModel> offsets_ = std::vector<EncoderModel>(4, EncoderModel(4));
  std::vector<IntegerEncoder> numbers_ = std::vector<IntegerEncoder>(4, IntegerEncoder(32, 3));
};

}  // namespace support
