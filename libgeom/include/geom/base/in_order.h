#pragma once

// A stream of items that are read one by one, worked on by all threads, and taken in their order.
//
// Example:
//   std::istringstream in("3 4 5");
//   std::vector<int> squares;
//   const auto next = [&]() -> std::optional<int> {
//     int number = 0;
//     return in >> number ? std::optional(number) : std::nullopt;
//   };
//   geom::in_order<int>(
//       {.threads = 2}, 8, next, [](int& number) { number *= number; },
//       [&](int number) { squares.push_back(number); });
//   assert((squares == std::vector{9, 16, 25}));

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "geom/base/parallel.h"

namespace geom {

// What in_order() does for all threads: each calls run_one() of it.
template <class Item, class Next, class Work, class Take>
class OrderedStream {
 public:
  OrderedStream(std::size_t window, const Next& next, const Work& work, const Take& take)
      : next_(next), work_(work), take_(take), held_(window) {}

  // Reads items and works on them until there are no more, and takes those whose turn it is.
  void run_one() noexcept {
    while (Held* const held = read()) {
      if (held->item) work_on(*held);
      finish(*held);
    }
  }

  const std::exception_ptr& failure() const { return failure_; }

 private:
  struct Held {
    std::unique_ptr<Item> item;  // none once next() threw
    std::exception_ptr failure;  // of next() or work(): thrown when its turn comes
    bool done = false;
  };

  // The next item, or nothing after the last.
  Held* read() noexcept {
    const std::lock_guard reading(reading_);
    {
      std::unique_lock lock(mutex_);
      room_.wait(lock, [&] { return ended_ || read_ - taken_ < held_.size(); });
      if (ended_) return nullptr;
    }
    Held& held = held_[read_ % held_.size()];  // nobody else knows it yet
    try {
      if (std::optional<Item> item = next_()) held.item = std::make_unique<Item>(std::move(*item));
    } catch (...) {
      held.failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    const bool any = held.item || held.failure;
    ended_ = ended_ || !held.item;
    read_ += any;
    return any ? &held : nullptr;
  }

  void work_on(Held& held) noexcept {
    try {
      work_(*held.item);
    } catch (...) {
      held.failure = std::current_exception();
    }
  }

  // Takes all whose turn it is, unless another thread does.
  void finish(Held& done) noexcept {
    std::unique_lock lock(mutex_);
    done.done = true;
    if (taking_) return;
    taking_ = true;
    for (Held* held = turn(); held && !failure_; held = turn()) {
      lock.unlock();
      std::exception_ptr failure = take(*held);
      lock.lock();
      failure_ = std::move(failure);
      ended_ = ended_ || failure_;
      ++taken_;
      room_.notify_all();
    }
    taking_ = failure_ != nullptr;  // then nothing more is taken
  }

  // The item whose turn it is, if it is done.
  Held* turn() {
    Held& held = held_[taken_ % held_.size()];
    return taken_ < read_ && held.done ? &held : nullptr;
  }

  std::exception_ptr take(Held& held) noexcept {
    std::exception_ptr failure = std::exchange(held.failure, nullptr);
    try {
      if (!failure) take_(*held.item);
    } catch (...) {
      failure = std::current_exception();
    }
    held.item.reset();
    held.done = false;
    return failure;
  }

  const Next& next_;
  const Work& work_;
  const Take& take_;
  std::mutex reading_;  // taken first
  std::mutex mutex_;    // guards what follows
  std::condition_variable room_;
  std::vector<Held> held_;  // item i at i modulo its size
  std::size_t read_ = 0;
  std::size_t taken_ = 0;
  bool ended_ = false;   // nothing more is read
  bool taking_ = false;  // by some thread
  std::exception_ptr failure_;
};

// Calls `next()` until it gives nothing, `work(item)` of each item, and `take(item)` of each in the
// order in which it came, as soon as those before it are taken. `next` and `take` are called by one
// thread at a time each, which need not be the caller's, and at the same time as the other and as
// `work` of other items; so they must not share what they change. At most `window` items (at least
// one) are held: read, and not yet taken.
//
// Throws the first failure in the order of the items, as one thread would, once all items before it
// are taken. Some items after it may have been worked on. `run.progress` is not called.
template <class Item, class Next, class Work, class Take>
void in_order(const Execution& run, std::size_t window, const Next& next, const Work& work,
              const Take& take) {
  if (run.threads <= 1) {
    while (std::optional<Item> item = next()) {
      work(*item);
      take(*item);
    }
    return;
  }
  OrderedStream<Item, Next, Work, Take> stream(std::max<std::size_t>(window, 1), next, work, take);
  parallel_for(run.threads, {run.threads, {}}, [&](std::size_t) { stream.run_one(); });
  if (stream.failure()) std::rethrow_exception(stream.failure());
}

}  // namespace geom
