#include "geom/base/processes.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <functional>
#include <new>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "geom/base/error.h"

namespace geom {
namespace {

using Work = std::function<std::string(std::size_t)>;
using Take = std::function<void(const std::string&)>;

// Of the numbers below n.
void each(std::size_t n, unsigned count, const Work& work, const Take& take) {
  std::size_t at = 0;
  in_processes(
      count,
      [&]() -> std::optional<std::string> {
        return at < n ? std::optional(std::to_string(at++)) : std::nullopt;
      },
      [&](const std::string& text) { return work(std::stoul(text)); }, take);
}

std::vector<std::string> all(std::size_t n, unsigned count, const Work& work) {
  std::vector<std::string> out;
  each(n, count, work, [&](const std::string& text) { out.push_back(text); });
  return out;
}

TEST(Processes, GiveTheSameInOrderForAnyNumber) {
  const auto work = [](std::size_t i) { return std::string(i * 20000, 'a') + std::to_string(i); };
  const auto one = all(20, 1, work);
  EXPECT_EQ(one, all(20, 3, work));
  EXPECT_EQ(one, all(20, 100, work));
  EXPECT_TRUE(all(0, 4, work).empty());
}

TEST(Processes, AreOthersThanThisOne) {
  const auto ids = all(40, 2, [](std::size_t) { return std::to_string(::getpid()); });
  const std::set<std::string> different(ids.begin(), ids.end());
  EXPECT_LE(different.size(), 2u);
  EXPECT_EQ(different.count(std::to_string(::getpid())), 0u);
}

// One text is answered here: no child is worth its start.
TEST(Processes, AreNotForkedForOneText) {
  EXPECT_EQ(all(1, 4, [](std::size_t) { return std::to_string(::getpid()); }),
            (std::vector<std::string>{std::to_string(::getpid())}));
}

// One that takes long does not keep the other from what follows.
TEST(Processes, ShareWhatThereIsByWhatItCosts) {
  const auto ids = all(20, 2, [](std::size_t i) {
    if (i == 0) ::usleep(300'000);
    return std::to_string(::getpid());
  });
  EXPECT_EQ(std::count(ids.begin(), ids.end(), ids[0]), 1);
}

TEST(Processes, HandOnWhatTheStreamThrowsWhenItIsItsTurn) {
  for (const unsigned count : {1u, 2u, 5u}) {
    for (const int good : {0, 1, 2, 30}) {
      int at = 0;
      int taken = 0;
      const auto next = [&]() -> std::optional<std::string> {
        if (at == good) throw geom::InputError("f", 7, {.says = "broken"});
        return std::to_string(at++);
      };
      EXPECT_THROW(in_processes(
                       count, next, [](const std::string& text) { return text; },
                       [&](const std::string&) { ++taken; }),
                   geom::InputError);
      EXPECT_EQ(taken, good) << count;
    }
  }
}

TEST(Processes, HandOnErrorsAfterWhatCameBefore) {
  std::vector<std::string> taken;
  const geom::Fault fault{.item = "item 1",
                          .key = "k: 1",
                          .says = std::string("\0 3 ", 4),
                          .expected = "",
                          .found = "\xff\n",
                          .advice = "7 a"};
  const auto work = [&](std::size_t i) -> std::string {
    if (i == 5) throw geom::InputError("a: paths", 6, fault);
    return std::to_string(i);
  };
  try {
    each(9, 3, work, [&](const std::string& text) { taken.push_back(text); });
    FAIL();
  } catch (const geom::InputError& error) {
    EXPECT_EQ(error.source(), "a: paths");
    EXPECT_EQ(error.line(), 6u);
    EXPECT_EQ(error.fault(), fault);
  }
  EXPECT_EQ(taken.size(), 5u);
}

// Never a record less: what a worker could not do is thrown, whatever came before.
TEST(Processes, HandOnThatMemoryRanOut) {
  std::size_t taken = 0;
  const auto work = [](std::size_t i) -> std::string {
    if (i == 4) throw std::bad_alloc();
    return "x";
  };
  EXPECT_THROW(each(9, 3, work, [&](const std::string&) { ++taken; }), std::bad_alloc);
  EXPECT_EQ(taken, 4u);
}

TEST(Processes, SayThatOneWasKilledForItsMemory) {
  const auto work = [](std::size_t i) {
    if (i == 3) std::raise(SIGKILL);
    return std::string("x");
  };
  try {
    all(4, 2, work);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("memory"), std::string::npos) << error.what();
  }
}

TEST(Processes, SayWhereOneDied) {
  EXPECT_THROW(all(4, 2,
                   [](std::size_t i) {
                     if (i == 3) std::raise(SIGKILL);
                     return std::string("x");
                   }),
               std::runtime_error);
}

}  // namespace
}  // namespace geom
