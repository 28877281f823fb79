#include "geom/base/processes.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "geom/base/error.h"

namespace geom {
namespace {

std::vector<std::string> all(std::size_t n, unsigned count,
                             const std::function<std::string(std::size_t)>& work) {
  std::vector<std::string> out;
  in_processes(n, count, work, [&](std::size_t i, const std::string& text) {
    EXPECT_EQ(i, out.size());
    out.push_back(text);
  });
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
  const auto ids = all(4, 2, [](std::size_t) { return std::to_string(::getpid()); });
  EXPECT_EQ(ids[0], ids[2]);
  EXPECT_NE(ids[0], ids[1]);
  EXPECT_NE(ids[0], std::to_string(::getpid()));
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
    in_processes(9, 3, work, [&](std::size_t, const std::string& text) { taken.push_back(text); });
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
  EXPECT_THROW(in_processes(9, 3, work, [&](std::size_t, const std::string&) { ++taken; }),
               std::bad_alloc);
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
