#include "cloud/integer_decoder.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/random_city.h"
#include "support/range_encoder.h"

namespace geom {
namespace {

struct Turn {
  std::int32_t predicted, real;
  unsigned context;
};

void expect_round_trip(unsigned bits, const std::vector<Turn>& turns) {
  support::RangeEncoder encoder;
  support::IntegerEncoder written(bits, 3);
  std::vector<unsigned> ks;
  for (const Turn& t : turns) {
    written.put(encoder, t.predicted, t.real, t.context);
    ks.push_back(written.k());
  }
  const std::string code = encoder.finish();
  ByteSource bytes(std::span(reinterpret_cast<const unsigned char*>(code.data()), code.size()), 0,
                   "test");
  RangeDecoder decoder(bytes);
  IntegerDecoder number(bits, 3);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    ASSERT_EQ(number.next(decoder, turns[i].predicted, turns[i].context), turns[i].real)
        << bits << " bits, turn " << i;
    ASSERT_EQ(number.correction_bits(), ks[i]) << bits << " bits, turn " << i;
  }
  EXPECT_EQ(bytes.position(), code.size());
}

TEST(IntegerDecoder, ReadsNumbersOf32Bits) {
  constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  std::vector<Turn> turns{{0, 0, 0},          {0, 1, 0},          {0, -1, 0},     {0, 2, 1},
                          {kLeast, kMost, 0}, {kMost, kLeast, 1}, {0, kLeast, 2}, {0, kMost, 2},
                          {kMost, -1, 0},     {kLeast, 0, 0}};
  support::Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const double size = std::ldexp(1.0, random.below(32));
    const auto any = [&] { return static_cast<std::int32_t>(random.uniform(-size, size)); };
    turns.push_back({any(), any(), static_cast<unsigned>(random.below(3))});
  }
  expect_round_trip(32, turns);
}

}  // namespace
}  // namespace geom
