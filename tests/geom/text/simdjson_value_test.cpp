#include "text/simdjson_value.h"

#include <gtest/gtest.h>
#include <simdjson.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "geom/text/parse_json.h"
#include "support/cases.h"
#include "support/json_disagreement.h"

namespace geom {
namespace {

// Has every kernel of simdjson that this processor knows answer, and names it where one fails.
void with_each_kernel(const std::function<void()>& test) {
  auto& active = simdjson::get_active_implementation();
  const simdjson::implementation* const usual = active;
  for (const simdjson::implementation* kernel : simdjson::get_available_implementations()) {
    if (!kernel->supported_by_runtime_system()) continue;
    SCOPED_TRACE(kernel->name());
    active = kernel;
    test();
  }
  active = usual;
}

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

const std::vector<std::string> kRecords = {
    R"({"type":"trajectory","id":"street-local-0","status":"solved","duration":22.55,"vehicle":{"name":"box:1,1,1","half":[1,1,1]},"margin":0,"segments":[{"duration":1.5491323916287125,"x":[-1.756683,-1.7450778904697941,-0,0],"y":[],"z":[1e-7,-2.5E+3,-0.0]}]})",
    R"({"id":"a","from":[1,2,3],"to":[-1.5,2e2,60.0],"earliest":0,"best_known":null,"ok":true})",
    R"([ {"a" : [ ] , "b":{ } }, "x\u00e9\n\"\\\/\b\f\r\t", "\ud83d\ude00", "é€😀", false ])"};

// Odd documents, of which some are JSON.
const std::vector<std::string> kOdd = {"",
                                       " ",
                                       "0",
                                       "-0",
                                       "[-0]",
                                       "{\"a\":-0}",
                                       "-0 ",
                                       "-0.0",
                                       "-0e5",
                                       "0e99999999999999999999",
                                       "[0,-0]",
                                       "[\"-0\",0]",
                                       "[\",-0\",0]",
                                       "01",
                                       "-01",
                                       "00",
                                       "1.",
                                       ".5",
                                       "+1",
                                       "1e",
                                       "1e+",
                                       "1E5",
                                       "1e-",
                                       "0x10",
                                       "NaN",
                                       "Infinity",
                                       "-Infinity",
                                       "nan",
                                       "nul",
                                       "nulll",
                                       "truefalse",
                                       "tru",
                                       "9007199254740993",
                                       "9007199254740993.0",
                                       "9223372036854775807",
                                       "9223372036854775808",
                                       "-9223372036854775808",
                                       "-9223372036854775809",
                                       "18446744073709551615",
                                       "18446744073709551616",
                                       "123456789012345678901234567890",
                                       "1e308",
                                       "1.7976931348623157e308",
                                       "1.7976931348623159e308",
                                       "1e400",
                                       "-1e400",
                                       "1e-400",
                                       "-1e-400",
                                       "4.9e-324",
                                       "2.4703282292062327e-324",
                                       "2.4703282292062328e-324",
                                       "2.2250738585072011e-308",
                                       "1e99999999999999999999",
                                       "1e-99999999999999999999",
                                       "0.1e1",
                                       "1.0",
                                       "100000000000000000000e-20",
                                       "[1,]",
                                       "[,1]",
                                       "[1 2]",
                                       "{\"a\":1,}",
                                       "{,}",
                                       "{\"a\" 1}",
                                       "{1:2}",
                                       "{\"a\":1,\"a\":2}",
                                       "{\"a\":1,\"\\u0061\":2}",
                                       "{\"\":1}",
                                       "[1] 2",
                                       "{} {}",
                                       "{}\n{}",
                                       "[1]]",
                                       "[[1]",
                                       "[1}",
                                       "\"",
                                       "\"\\",
                                       "\"\\u",
                                       "\"\\ud800\"",
                                       "\"\\udc00\"",
                                       "\"\\ud800\\u0041\"",
                                       "\"\\ud800\\ud800\"",
                                       "\"\\udbff\\udfff\"",
                                       "\"\\u0000\"",
                                       "\"\\uD83D\\uDE0\"",
                                       "\"\\x41\"",
                                       "\"a\nb\"",
                                       "\"a\tb\"",
                                       "\"\x7f\"",
                                       "\"\xff\"",
                                       "\"\xc0\xaf\"",
                                       "\"\xed\xa0\x80\"",
                                       "\"\xf4\x90\x80\x80\"",
                                       "\"\xe2\x82\"",
                                       "\xef\xbb\xbf[1]",
                                       "\xef\xbb\xbf",
                                       "\xef\xbb[1]",
                                       "[1]\xef\xbb\xbf",
                                       "\xfe\xff[1]",
                                       "[1]\f",
                                       "\v[1]",
                                       "[1]\xa0",
                                       "\x1e[1]",
                                       "// c\n1",
                                       "/* */1",
                                       "[1]#",
                                       "'a'",
                                       std::string("[1\0]", 4),
                                       std::string("1\0", 2),
                                       std::string("\0", 1),
                                       std::string("\"a\0b\"", 5),
                                       std::string("[1]\0", 4),
                                       nested(100),
                                       nested(101),
                                       nested(5000),
                                       std::string(2000, '['),
                                       "[" + nested(99) + "," + nested(99) + "]",
                                       "[" + nested(99) + "," + nested(100) + "]",
                                       std::string(400, '9'),
                                       "0." + std::string(800, '1'),
                                       "1" + std::string(800, '0') + "e-800",
                                       "[" + std::string(70, ' ') + "1]"};

TEST(SimdjsonValue, IsWhatTheWordedReaderMakes) {
  with_each_kernel([] {
    for (const auto& list : {kRecords, kOdd}) {
      for (const std::string& text : list) EXPECT_EQ(support::json_disagreement(text), "") << text;
    }
  });
}

// So the comparisons here are of something.
TEST(SimdjsonValue, IsThereForRecords) {
  with_each_kernel([] {
    for (const char* const text :
         {R"({"id":"street-local-0","margin":0,"x":[-0.5,-0.0,1e3,12]})", "[]", "{}", "[0,1,-1]",
          R"({"a":[1,-2,3.5,1e3,true,null,"x\u00e9\n"],"b":{}})", "1.5", "\"-0\"", "0"}) {
      EXPECT_TRUE(simdjson_value(text).has_value()) << text;
    }
  });
}

TEST(SimdjsonValue, IsNothingForLongTexts) {
  const std::string longest(kLongestForSimdjson - 1, ' ');
  EXPECT_EQ(simdjson_value("1" + longest), 1u);
  EXPECT_EQ(simdjson_value("12" + longest), std::nullopt);
  EXPECT_EQ(parse_json("12" + longest, "f"), 12u);
}

// One change: a byte, a part lost, moved or repeated, an end.
std::string changed(std::string text, std::mt19937_64& random) {
  static constexpr std::string_view kLikely =
      "\"\\[]{}:,.-+eE0123456789 \n\t/untrfasld\x7f\x80\xc3";
  const std::size_t at = random() % (text.size() + 1);
  const std::size_t length = std::min<std::size_t>(random() % 12, text.size() - at);
  const char any = random() % 4 ? kLikely[random() % kLikely.size()] : static_cast<char>(random());
  switch (random() % 6) {
    case 0:
      return text.insert(at, 1, any);
    case 1:
      return text.erase(at, length);
    case 2:
      return text.insert(random() % (text.size() + 1), text.substr(at, length));
    case 3:
      return random() % 4 ? text : text.substr(0, at);
    default:
      if (at < text.size()) text[at] = any;
      return text;
  }
}

// With SKYWAY_CASES=50 of a million documents.
TEST(SimdjsonValue, AgreesOnChangedDocuments) {
  std::vector<std::string> seeds = kRecords;
  for (const std::string& text : kOdd) {
    if (text.size() < 300) seeds.push_back(text);
  }
  std::vector<const simdjson::implementation*> kernels;
  for (const simdjson::implementation* kernel : simdjson::get_available_implementations()) {
    if (kernel->supported_by_runtime_system()) kernels.push_back(kernel);
  }
  auto& active = simdjson::get_active_implementation();
  const simdjson::implementation* const usual = active;
  int there = 0;
  const int cases = support::cases(20000);
  for (int i = 0; i < cases; ++i) {
    std::mt19937_64 random(static_cast<std::uint64_t>(i));
    std::string text = seeds[random() % (random() % 2 ? kRecords.size() : seeds.size())];
    for (std::uint64_t n = random() % 4; n < 4; ++n) text = changed(std::move(text), random);
    active = kernels[random() % kernels.size()];
    ASSERT_EQ(support::json_disagreement(text), "")
        << "case " << i << ", " << active->name() << ": " << text;
    there += simdjson_value(text).has_value();
  }
  active = usual;
  EXPECT_GT(there, cases / 20);
}

std::string digits(std::mt19937_64& random, std::size_t most) {
  std::string out(1, static_cast<char>('1' + random() % 9));
  for (std::size_t n = random() % most; n > 0; --n) out += static_cast<char>('0' + random() % 10);
  return out;
}

// Halfway between two doubles, in all its digits.
std::string halfway(std::mt19937_64& random) {
  const double value =
      std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 2040) - 1100);
  const long double step = static_cast<long double>(std::nextafter(value, INFINITY)) - value;
  char text[1200];
  std::snprintf(text, sizeof text, "%.1100Lg", value + step / 2);
  return text;
}

std::string number(std::mt19937_64& random) {
  const std::string sign = random() % 2 ? "-" : "";
  if (random() % 4 == 0) return sign + halfway(random);
  std::string out = sign + (random() % 3 ? digits(random, 25) : "0");
  if (random() % 3) {
    out += '.' + std::string(random() % 3 ? 0 : random() % 30, '0') + digits(random, 25);
  }
  if (random() % 2) out += (random() % 2 ? "e-" : "e") + std::to_string(random() % 345);
  return out;
}

TEST(SimdjsonValue, HasNumbersToTheBit) {
  const int cases = support::cases(20000);
  with_each_kernel([cases] {
    for (int i = 0; i < cases; ++i) {
      std::mt19937_64 random(static_cast<std::uint64_t>(i));
      const std::string text = number(random);
      ASSERT_EQ(support::json_disagreement(text), "") << "case " << i << ": " << text;
      ASSERT_EQ(support::json_disagreement("[" + text + "]"), "") << "case " << i << ": " << text;
    }
  });
}

}  // namespace
}  // namespace geom
