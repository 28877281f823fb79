#include "laz_gps_time.h"

#include <array>

#include "integer_decoder.h"

namespace geom {
namespace {

std::int32_t wrapped_product(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b));
}

// A step from one time to the next, in units of the last place of a double; a step that was
// unusual four times in a row becomes the usual one.
struct TimeStep {
  std::int32_t usual = 0;
  unsigned unusual = 0;

  void saw_unusual(std::int32_t step) {
    if (++unusual <= 3) return;
    usual = step;
    unusual = 0;
  }
};

class GpsTimeVersion1 : public LazItemDecoder {
 public:
  void next(RangeDecoder& code, LazPoint&) override {
    if (step_.usual == 0) {
      const unsigned how = code.symbol(after_none_);
      if (how == 1) step_.usual = difference_.next(code, 0, 0);
      if (how == 2) whole(code);
      return;
    }
    const auto times = static_cast<std::int32_t>(code.symbol(times_));
    if (times == kWhole) {
      whole(code);
    } else if (times == 1) {
      step_ = {difference_.next(code, step_.usual, 1), 0};
    } else if (times == 0) {
      step_.saw_unusual(difference_.next(code, step_.usual / 4, 2));
    } else if (times < kWhole) {
      const std::int32_t step = difference_.next(code, wrapped_product(times, step_.usual),
                                                 times < 10   ? 3
                                                 : times < 50 ? 4
                                                              : 5);
      if (times == kMost) step_.saw_unusual(step);
    }
  }

 private:
  static constexpr std::int32_t kMost = 509;
  static constexpr std::int32_t kWhole = 510;  // 511: unchanged

  static void whole(RangeDecoder& code) {
    code.bits(32);
    code.bits(32);
  }

  SymbolModel times_{512};
  SymbolModel after_none_{3};
  IntegerDecoder difference_{32, 6};
  TimeStep step_;
};

// Four sequences of times, of as many flight lines.
class GpsTimeVersion2 : public LazItemDecoder {
 public:
  void next(RangeDecoder& code, LazPoint&) override {
    while (step_of_one(code)) {
    }
  }

 private:
  static constexpr std::int32_t kMost = 500;
  static constexpr std::int32_t kLeast = -10;
  static constexpr std::int32_t kUnchanged = 511;
  static constexpr std::int32_t kWhole = 512;

  // Whether the point is of another sequence, which its code names next.
  bool step_of_one(RangeDecoder& code) {
    if (steps_[now_].usual != 0) return by_usual_step(code);
    const unsigned how = code.symbol(after_none_);
    if (how == 1) steps_[now_] = {difference_.next(code, 0, 0), 0};
    if (how == 2) whole(code);
    if (how > 2) now_ = (now_ + how - 2) & 3;
    return how > 2;
  }

  bool by_usual_step(RangeDecoder& code) {
    TimeStep& step = steps_[now_];
    const auto times = static_cast<std::int32_t>(code.symbol(times_));
    if (times == 1) {
      difference_.next(code, step.usual, 1);
      step.unusual = 0;
    } else if (times == 0) {
      step.saw_unusual(difference_.next(code, 0, 7));
    } else if (times < kMost) {
      difference_.next(code, 0, times < 10 ? 2 : 3);
    } else if (times == kMost) {
      step.saw_unusual(difference_.next(code, wrapped_product(kMost, step.usual), 4));
    } else if (times < kUnchanged - 1) {
      difference_.next(code, 0, 5);
    } else if (times == kUnchanged - 1) {
      step.saw_unusual(difference_.next(code, wrapped_product(kLeast, step.usual), 6));
    } else if (times == kWhole) {
      whole(code);
    } else if (times > kWhole) {
      now_ = (now_ + static_cast<unsigned>(times - kWhole)) & 3;
      return true;
    }
    return false;
  }

  void whole(RangeDecoder& code) {
    difference_.next(code, 0, 8);
    code.bits(32);
    next_ = (next_ + 1) & 3;
    now_ = next_;
    steps_[now_] = {};
  }

  SymbolModel times_{516};
  SymbolModel after_none_{6};
  IntegerDecoder difference_{32, 9};
  std::array<TimeStep, 4> steps_;
  unsigned now_ = 0;
  unsigned next_ = 0;
};

}  // namespace

std::unique_ptr<LazItemDecoder> gps_time_decoder(unsigned version) {
  if (version == 1) return std::make_unique<GpsTimeVersion1>();
  return std::make_unique<GpsTimeVersion2>();
}

}  // namespace geom
