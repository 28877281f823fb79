#include "geom/base/in_order.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <optional>
#include <stdexcept>
#include <string>

namespace geom {
namespace {

struct Item {
  int number = 0;
  int square = 0;
};

// Squares of 0 to count - 1; what is thrown where, -1: nowhere.
struct Squares {
  int count = 200;
  int next_throws = -1;
  int work_throws = -1;
  int take_throws = -1;
  std::vector<int> taken = {};

  void run(unsigned threads, std::size_t window) {
    int at = 0;
    const auto throw_at = [](int number, int where, const char* what) {
      if (number == where) throw std::runtime_error(what + std::to_string(number));
    };
    const auto next = [&]() -> std::optional<Item> {
      throw_at(at, next_throws, "next ");
      if (at == count) return std::nullopt;
      return Item{at++, 0};
    };
    const auto work = [&](Item& item) {
      throw_at(item.number, work_throws, "work ");
      item.square = item.number * item.number;
    };
    const auto take = [&](const Item& item) {
      throw_at(item.number, take_throws, "take ");
      taken.push_back(item.square);
    };
    in_order<Item>({threads, {}}, window, next, work, take);
  }

  std::string thrown(unsigned threads, std::size_t window) {
    try {
      run(threads, window);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
};

constexpr unsigned kThreads[] = {1, 2, 7};
constexpr std::size_t kWindows[] = {0, 7, 64, 5000};

TEST(InOrder, TakesEachItemOnceInItsOrder) {
  for (const unsigned threads : kThreads) {
    for (const std::size_t window : kWindows) {
      for (const int count : {0, 1, 2, 200}) {
        Squares squares{.count = count};
        squares.run(threads, window);
        ASSERT_EQ(squares.taken.size(), static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i) {
          ASSERT_EQ(squares.taken[static_cast<std::size_t>(i)], i * i);
        }
      }
    }
  }
}

// Whatever the threads: the first by item, and of one item next before work before take.
TEST(InOrder, ThrowsWhatOneThreadWouldHaveThrown) {
  for (const unsigned threads : kThreads) {
    for (const std::size_t window : kWindows) {
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ((Squares{.next_throws = 11, .work_throws = 12}).thrown(threads, window),
                  "next 11");
        EXPECT_EQ((Squares{.next_throws = 12, .work_throws = 11}).thrown(threads, window),
                  "work 11");
        EXPECT_EQ((Squares{.next_throws = 12, .take_throws = 11}).thrown(threads, window),
                  "take 11");
        EXPECT_EQ((Squares{.work_throws = 12, .take_throws = 11}).thrown(threads, window),
                  "take 11");
        EXPECT_EQ((Squares{.next_throws = 200, .work_throws = 199}).thrown(threads, window),
                  "work 199");
      }
    }
  }
}

TEST(InOrder, TakesAllItemsBeforeTheOneThatThrew) {
  for (const unsigned threads : kThreads) {
    for (const std::size_t window : kWindows) {
      for (Squares squares : {Squares{.next_throws = 77}, Squares{.work_throws = 77}}) {
        EXPECT_NE(squares.thrown(threads, window), "");
        EXPECT_EQ(squares.taken.size(), 77u);
      }
    }
  }
}

// One who waits for the answer to an item before the next is there gets it.
TEST(InOrder, TakesAnItemBeforeTheNextIsThere) {
  for (const unsigned threads : kThreads) {
    std::promise<int> answer;
    std::future<int> answered = answer.get_future();
    int at = 0;
    const auto next = [&]() -> std::optional<Item> {
      if (at == 20) return std::nullopt;
      if (at > 0) {
        EXPECT_EQ(answered.wait_for(std::chrono::seconds(60)), std::future_status::ready);
        EXPECT_EQ(answered.get(), at - 1);
        answer = {};
        answered = answer.get_future();
      }
      return Item{at++, 0};
    };
    in_order<Item>(
        {threads, {}}, 64, next, [](Item&) {},
        [&](const Item& item) { answer.set_value(item.number); });
    EXPECT_EQ(at, 20);
  }
}

TEST(InOrder, HoldsNoMoreThanTheWindow) {
  std::atomic<int> held = 0;
  std::atomic<int> most = 0;
  int left = 300;
  const auto next = [&]() -> std::optional<Item> {
    if (left-- == 0) return std::nullopt;
    const int now = ++held;
    if (now > most) most = now;
    return Item{};
  };
  in_order<Item>(
      {7, {}}, 5, next, [](Item&) {}, [&](const Item&) { --held; });
  EXPECT_LE(most, 5);
  EXPECT_EQ(held, 0);
}

}  // namespace
}  // namespace geom
