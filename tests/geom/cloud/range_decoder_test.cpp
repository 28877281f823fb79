#include "cloud/range_decoder.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "support/random_city.h"
#include "support/range_encoder.h"

namespace geom {
namespace {

ByteSource source_of(const std::string& bytes) {
  return ByteSource(std::span(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()),
                    0, "test");
}

// Of a code that may end anywhere, the end is known; most other places are not one.
TEST(RangeDecoder, KnowsTheEnd) {
  int too_early = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    support::Random random(seed);
    support::RangeEncoder encoder;
    support::EncoderModel written(30);
    const int count = 1 + random.below(60);
    for (int i = 0; i < count; ++i) {
      encoder.symbol(written, static_cast<unsigned>(random.below(30)));
    }
    const std::string code = encoder.finish();
    ByteSource bytes = source_of(code);
    RangeDecoder decoder(bytes);
    SymbolModel model(30);
    for (int i = 0; i + 1 < count; ++i) decoder.symbol(model);
    try {
      decoder.require_end();
    } catch (const InputError&) {
      ++too_early;
    }
    decoder.symbol(model);
    EXPECT_NO_THROW(decoder.require_end()) << "seed " << seed;
    EXPECT_EQ(bytes.position(), code.size()) << "seed " << seed;
  }
  EXPECT_GT(too_early, 350);
}

TEST(RangeDecoder, RefusesACodeThatNoEncoderBegins) {
  ByteSource bytes = source_of("\xFF\xFF\xFF\xFF\xFF");
  EXPECT_THROW(RangeDecoder{bytes}, InputError);
}

}  // namespace
}  // namespace geom
