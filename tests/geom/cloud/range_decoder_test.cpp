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

// Symbols of models of every size, bits and plain numbers, in one code; most symbols are few.
TEST(RangeDecoder, ReadsWhatWasWritten) {
  constexpr unsigned kSizes[] = {2, 3, 6, 9, 13, 16, 17, 33, 64, 128, 256, 512, 516};
  support::Random random(1);
  std::vector<support::EncoderModel> written;
  std::vector<SymbolModel> models;
  for (const unsigned size : kSizes) {
    written.emplace_back(size);
    models.emplace_back(size);
  }
  support::EncoderBitModel written_bit;
  BitModel bit;
  struct Said {
    unsigned kind, value;
  };
  std::vector<Said> said;
  support::RangeEncoder encoder;
  for (int i = 0; i < 60000; ++i) {
    const auto kind = static_cast<unsigned>(random.below(15));
    Said s{kind, 0};
    if (kind < std::size(kSizes)) {
      const auto size = static_cast<int>(kSizes[kind]);
      s.value = static_cast<unsigned>(random.below(4) ? random.below(2) : random.below(size));
      encoder.symbol(written[kind], s.value);
    } else if (kind == 13) {
      s.value = random.below(50) == 0;
      encoder.bit(written_bit, s.value != 0);
    } else {
      const auto count = 1 + static_cast<unsigned>(i) % 32;
      s.value = static_cast<unsigned>(random.uniform(0, std::ldexp(1.0, static_cast<int>(count))));
      encoder.bits(count, s.value);
    }
    said.push_back(s);
  }
  const std::string code = encoder.finish();
  ByteSource bytes = source_of(code);
  RangeDecoder decoder(bytes);
  for (std::size_t i = 0; i < said.size(); ++i) {
    const auto [kind, value] = said[i];
    const unsigned found = kind < models.size() ? decoder.symbol(models[kind])
                           : kind == 13         ? decoder.bit(bit)
                                                : decoder.bits(1 + static_cast<unsigned>(i) % 32);
    ASSERT_EQ(found, value) << "turn " << i << ", kind " << kind;
  }
  EXPECT_EQ(bytes.position(), code.size());  // all of it, and no more
  EXPECT_NO_THROW(decoder.require_end());
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

// Whatever the bytes are: a symbol of the model, or a refusal.
TEST(RangeDecoder, TakesAnyBytes) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    support::Random random(seed);
    std::string code;
    for (int i = 0; i < 200; ++i) {
      code += static_cast<char>(seed % 3 == 0 && random.below(3) ? 255 : random.below(256));
    }
    ByteSource bytes = source_of(code);
    SymbolModel few(6);
    SymbolModel many(256);
    try {
      RangeDecoder decoder(bytes);
      for (int i = 0; i < 2000; ++i) {
        ASSERT_LT(decoder.symbol(few), 6u);
        ASSERT_LT(decoder.symbol(many), 256u);
        ASSERT_LT(decoder.bits(11), 1u << 11);
      }
    } catch (const InputError&) {
    }
  }
}

TEST(RangeDecoder, RefusesACodeThatNoEncoderBegins) {
  ByteSource bytes = source_of("\xFF\xFF\xFF\xFF\xFF");
  EXPECT_THROW(RangeDecoder{bytes}, InputError);
}

TEST(RangeDecoder, RefusesACodeThatEnds) {
  ByteSource three = source_of("abc");
  EXPECT_THROW(RangeDecoder{three}, InputError);
  ByteSource four = source_of("abcd");
  RangeDecoder decoder(four);
  EXPECT_THROW(decoder.bits(16), InputError);
}

}  // namespace
}  // namespace geom
