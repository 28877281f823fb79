#include "traj/mission/ulog/ulog_reader.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "support/reading.h"
#include "ulog_bytes.h"

namespace traj {
namespace {

using std::string_view_literals::operator""sv;

struct Read {
  UlogSummary summary;
  std::vector<std::uint64_t> times;
  std::vector<std::optional<double>> values;  // of x
};

Read read(const std::string& bytes) {
  std::istringstream in(bytes);
  Read out;
  constexpr std::array topics{"p"sv};
  out.summary = read_ulog(in, "log.ulg", topics, [&](const UlogMessage& message) {
    EXPECT_EQ(message.topic(), "p");
    out.times.push_back(message.timestamp());
    out.values.push_back(message.number("x"));
  });
  return out;
}

std::string refusal(const std::string& bytes) {
  return support::refusal_of([&] { read(bytes); });
}

const std::string kFormat = ulog_message('F', "p:uint64_t timestamp;float x;uint8_t[4] _padding0;");

std::string row(std::uint64_t time, float x, std::uint16_t id = 7) {
  return ulog_data(id, bytes_of(time) + bytes_of(x));
}

const std::string kBegin = ulog_head() + kFormat + ulog_topic("p", 7);

std::string flags(char appended, std::initializer_list<std::uint64_t> offsets) {
  std::string body(40, '\0');
  body[8] = appended;
  std::size_t at = 16;
  for (const std::uint64_t offset : offsets) {
    body.replace(at, 8, bytes_of(offset));
    at += 8;
  }
  return ulog_message('B', body);
}

TEST(UlogReader, GivesTheMessagesOfATopic) {
  const Read all = read(kBegin + row(5, 1.5f) + row(6, 2.5f));
  EXPECT_EQ(all.times, (std::vector<std::uint64_t>{5, 6}));
  EXPECT_EQ(all.values, (std::vector<std::optional<double>>{1.5, 2.5}));
  EXPECT_EQ(all.summary.messages, 4u);
  EXPECT_FALSE(all.summary.cut_at);
}

TEST(UlogReader, GivesTheFirstInstanceOnly) {
  const Read all = read(kBegin + ulog_topic("p", 8, 1) + row(5, 1) + row(6, 2, 8));
  EXPECT_EQ(all.times, (std::vector<std::uint64_t>{5}));
}

TEST(UlogReader, TakesPaddingOrLeavesIt) {
  const std::string padded = ulog_data(7, bytes_of(std::uint64_t{9}) + bytes_of(3.f) + "....");
  EXPECT_EQ(read(kBegin + padded).values, (std::vector<std::optional<double>>{3}));
}

TEST(UlogReader, ReadsEachType) {
  const auto value = [](const std::string& type, const std::string& bytes) {
    return read(ulog_head() + ulog_message('F', "p:uint64_t timestamp;" + type + " x;") +
                ulog_topic("p", 7) + ulog_data(7, bytes_of(std::uint64_t{1}) + bytes))
        .values.at(0);
  };
  EXPECT_EQ(value("int8_t", bytes_of(std::int8_t{-3})), -3);
  EXPECT_EQ(value("uint8_t", bytes_of(std::uint8_t{253})), 253);
  EXPECT_EQ(value("int16_t", bytes_of(std::int16_t{-300})), -300);
  EXPECT_EQ(value("uint16_t", bytes_of(std::uint16_t{60000})), 60000);
  EXPECT_EQ(value("int32_t", bytes_of(std::int32_t{-70000})), -70000);
  EXPECT_EQ(value("uint32_t", bytes_of(std::uint32_t{4000000000})), 4e9);
  EXPECT_EQ(value("int64_t", bytes_of(std::int64_t{-5})), -5);
  EXPECT_EQ(value("uint64_t", bytes_of(std::uint64_t{5})), 5);
  EXPECT_EQ(value("double", bytes_of(47.25)), 47.25);
  EXPECT_EQ(value("bool", "\x01"), 1);
  EXPECT_EQ(value("char", "c"), std::nullopt);
  EXPECT_EQ(value("float", bytes_of(std::nanf(""))), std::nullopt);
  EXPECT_EQ(value("double", bytes_of(double{INFINITY})), std::nullopt);
}

TEST(UlogReader, PassesOverWhatIsNotData) {
  const std::string others = ulog_message('I', "\x06int32_t a....") + ulog_message('M', "x") +
                             ulog_message('P', "x") + ulog_message('Q', "x") +
                             ulog_message('L', "x") + ulog_message('C', "x") +
                             ulog_message('S', "x");
  const Read all = read(kBegin + others + row(5, 1) + ulog_message('X', "new") + row(6, 1));
  EXPECT_EQ(all.times.size(), 2u);
  EXPECT_EQ(all.summary.unknown, 1u);
}

TEST(UlogReader, CountsDropouts) {
  const auto dropout = [](std::uint16_t ms) { return ulog_message('O', bytes_of(ms)); };
  const Read all = read(kBegin + dropout(30) + dropout(1500));
  EXPECT_EQ(all.summary.dropouts, 2u);
  EXPECT_NEAR(all.summary.dropout_seconds, 1.53, 1e-12);
  EXPECT_NEAR(all.summary.longest_dropout, 1.5, 1e-12);
}

TEST(UlogReader, KeepsWhatStandsBeforeACut) {
  const std::string whole = kBegin + row(5, 1) + row(6, 2);
  const std::size_t last = whole.size() - row(6, 2).size();
  for (std::size_t size = last + 1; size < whole.size(); ++size) {
    const Read part = read(whole.substr(0, size));
    EXPECT_EQ(part.times, (std::vector<std::uint64_t>{5})) << size;
    EXPECT_EQ(part.summary.cut_at, last);
    EXPECT_EQ(part.summary.cut_why, "the file ends in the middle of a message");
  }
  EXPECT_FALSE(
      read(whole.substr(0, last)).summary.cut_at);  // between two messages: nobody can tell
}

TEST(UlogReader, StopsAtWhatIsNoMessage) {
  const auto why = [](const std::string& bytes) {
    const Read part = read(kBegin + row(5, 1) + bytes + row(6, 1));
    EXPECT_EQ(part.times.size(), 1u) << bytes;
    EXPECT_EQ(part.summary.cut_at, (kBegin + row(5, 1)).size()) << bytes;
    return part.summary.cut_why;
  };
  EXPECT_EQ(why(ulog_message('\x07', "x")), "expected a message, found one of kind \"\\x07\"");
  EXPECT_EQ(why(row(6, 1, 99)), "data of no topic");
  EXPECT_EQ(why(ulog_message('D', "x")), "data of no topic");
  EXPECT_EQ(why(ulog_data(7, "short")), "expected 16 bytes of p, found 5");
  EXPECT_EQ(why(ulog_data(7, std::string(17, 'x'))), "expected 16 bytes of p, found 17");
  EXPECT_EQ(why(ulog_topic("q", 8)), "the format \"q\" of a subscription is not known");
  EXPECT_EQ(why(ulog_message('A', "x")), "a subscription without a name");
  EXPECT_EQ(why(ulog_message('O', "x")), "a dropout without a duration");
  EXPECT_EQ(why(ulog_message('R', "xx")), "the end of a subscription that there is not");
  EXPECT_EQ(why(flags(0, {})), "flags stand in the middle of the log");
  EXPECT_EQ(why(ulog_message('D', "") + std::string(70000, 'x')), "data of no topic");
}

TEST(UlogReader, StopsWhereANumberStandsForTwoTopics) {
  const Read part =
      read(kBegin + row(5, 1) + ulog_message('F', "r:float y;") + ulog_topic("r", 7) + row(6, 1));
  EXPECT_EQ(part.times.size(), 1u);
  EXPECT_EQ(part.summary.cut_why, "the number 7 stands for two topics");
  const Read other = read(kBegin + row(5, 1) + ulog_topic("p", 7, 1) + row(6, 1));
  EXPECT_EQ(other.times.size(), 1u) << "another instance of the topic";
  EXPECT_EQ(other.summary.cut_why, part.summary.cut_why);
}

TEST(UlogReader, EndsASubscription) {
  const Read part =
      read(kBegin + row(5, 1) + ulog_message('R', bytes_of(std::uint16_t{7})) + row(6, 1));
  EXPECT_EQ(part.times.size(), 1u);
  EXPECT_EQ(part.summary.cut_why, "data of no topic");
}

TEST(UlogReader, GoesOnWithAppendedData) {
  const std::string torn = row(6, 2).substr(0, 9);
  const std::string begin = ulog_head() + flags(1, {0}) + kFormat + ulog_topic("p", 7) + row(5, 1);
  const std::uint64_t offset = begin.size() + torn.size();
  const std::string all = ulog_head() + flags(1, {offset}) + kFormat + ulog_topic("p", 7) +
                          row(5, 1) + torn + row(7, 3);
  const Read read_all = read(all);
  EXPECT_EQ(read_all.times, (std::vector<std::uint64_t>{5, 7}));
  EXPECT_EQ(read_all.summary.torn, 1u);
  EXPECT_FALSE(read_all.summary.cut_at);
  for (std::size_t size = offset - torn.size(); size < offset; ++size) {
    EXPECT_TRUE(read(all.substr(0, size)).summary.cut_at) << size;
  }
}

TEST(UlogReader, RefusesFlagsItDoesNotKnow) {
  EXPECT_TRUE(
      support::says(refusal(ulog_head() + flags(2, {})), "features which readers must know"));
  std::string later(40, '\0');
  later[15] = 1;
  EXPECT_TRUE(support::says(refusal(ulog_head() + ulog_message('B', later)), "must know"));
  EXPECT_TRUE(support::says(refusal(ulog_head() + ulog_message('B', "short")),
                            "flags of 40 bytes, found 5"));
  EXPECT_TRUE(support::says(refusal(ulog_head() + flags(1, {10})), "appended data after"));
  EXPECT_TRUE(support::says(refusal(ulog_head() + flags(1, {900, 800})), "found byte 800"));
  std::string compatible(44, '\0');
  compatible[0] = 3;
  EXPECT_EQ(read(ulog_head() + ulog_message('B', compatible)).summary.messages, 1u);
}

TEST(UlogReader, RefusesWhatIsNoLog) {
  EXPECT_TRUE(support::says(refusal(""), "expected a PX4 log (ULog), found \"\""));
  EXPECT_TRUE(support::says(refusal("id,t_s,east_m"), "found \"id,t_s,\""));
  EXPECT_TRUE(support::says(refusal(ulog_head().substr(0, 12)), "a header of 16 bytes, found 12"));
  EXPECT_EQ(read(ulog_head(9, 77)).summary.version, 9);
  EXPECT_EQ(read(ulog_head(9, 77)).summary.start, 77u);
}

TEST(UlogReader, RefusesTopicsWithoutTime) {
  EXPECT_TRUE(
      support::says(refusal(ulog_head() + ulog_message('F', "p:float x;") + ulog_topic("p", 7)),
                    "format p: expected a field \"uint64_t timestamp\""));
  // A topic that nobody asks for may be what it likes.
  EXPECT_EQ(
      read(ulog_head() + ulog_message('F', "q:nonsense x;") + ulog_topic("q", 7)).summary.messages,
      2u);
}

}  // namespace
}  // namespace traj
