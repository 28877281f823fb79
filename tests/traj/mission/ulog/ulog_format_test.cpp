#include "traj/mission/ulog/ulog_format.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace traj {
namespace {

UlogFormats formats(std::initializer_list<const char*> texts) {
  UlogFormats out("log.ulg");
  for (const char* text : texts) out.add(text);
  return out;
}

std::string refusal(std::initializer_list<const char*> texts) {
  return support::refusal_of([&] { formats(texts).layout("a"); });
}

TEST(UlogFormat, LaysFieldsSideBySide) {
  const UlogLayout a = formats({"a:uint64_t timestamp;float[3] x;bool ok;"}).layout("a");
  EXPECT_EQ(a.size, 21u);
  EXPECT_EQ(a.least, 21u);
  EXPECT_EQ(a.fields.at("x").at, 8u);
  EXPECT_EQ(a.fields.at("x").count, 3u);
  EXPECT_EQ(a.fields.at("ok").type, UlogType::boolean);
}

TEST(UlogFormat, PaddingAtTheEndNeedNotBeLogged) {
  const UlogLayout a =
      formats({"a:uint8_t x;uint8_t[3] _padding0;float y;uint8_t[4] _padding1;"}).layout("a");
  EXPECT_EQ(a.size, 12u);
  EXPECT_EQ(a.least, 8u);
  EXPECT_EQ(a.fields.size(), 2u);
  EXPECT_EQ(a.fields.at("y").at, 4u);
}

TEST(UlogFormat, NestsFormatsThatComeLater) {
  const UlogLayout a = formats({"a:b[2] p;c q;", "b:int16_t x;", "c:double x;"}).layout("a");
  EXPECT_EQ(a.fields.at("p[1].x").at, 2u);
  EXPECT_EQ(a.fields.at("q.x").at, 4u);
  EXPECT_EQ(a.size, 12u);
}

TEST(UlogFormat, KnowsTheSizeOfEachType) {
  const UlogLayout a =
      formats({"a:int8_t a;uint8_t b;int16_t c;uint16_t d;int32_t e;uint32_t f;int64_t g;uint64_t "
               "h;float i;double j;bool k;char l;"})
          .layout("a");
  EXPECT_EQ(a.size, 1u + 1 + 2 + 2 + 4 + 4 + 8 + 8 + 4 + 8 + 1 + 1);
}

TEST(UlogFormat, RefusesWhatCannotBeLaidOut) {
  EXPECT_TRUE(
      support::says(refusal({"b:float x;"}), "expected a format or a basic type, found \"a\""));
  EXPECT_TRUE(support::says(refusal({"a:quad x;"}), "found \"quad\""));
  EXPECT_TRUE(support::says(refusal({"a:a x;"}), "the format a contains itself"));
  EXPECT_TRUE(support::says(refusal({"a:b[9] x;", "b:a[9] x;"}), "contains itself"));
  EXPECT_TRUE(support::says(refusal({"a:float x;float x;"}), "the field x comes twice"));
  EXPECT_TRUE(support::says(refusal({"a:double[9000] x;"}), "at most 65535 bytes"));
  EXPECT_TRUE(support::says(refusal({"a:b[65535] x;", "b:c[65535] x;", "c:double x;"}),
                            "at most 65535 bytes"));
  const std::string name(300, 'n');
  EXPECT_TRUE(
      support::says(refusal({("a:float " + name + ";").c_str()}), "at most 200 characters"));
  for (const char* field : {"a:float;", "a: x;", "a:float x y;", "a:float[0] x;", "a:float[-1] x;",
                            "a:float[99999] x;", "a:[3] x;", "a:float3] x;", "a:;"}) {
    EXPECT_TRUE(support::says(refusal({field}), "expected fields such as")) << field;
  }
}

TEST(UlogFormat, RefusesTextThatIsNoFormat) {
  for (const char* text : {"", "a", "a:", ":float x;"}) {
    EXPECT_TRUE(support::says(refusal({text}), "expected a format such as")) << text;
  }
  EXPECT_TRUE(support::says(refusal({"a:float x;", "a:float y;"}), "comes twice, and differs"));
  EXPECT_EQ(formats({"a:float x;", "a:float x;"}).layout("a").size, 4u);
}

}  // namespace
}  // namespace traj
