#pragma once

// Tasks beside the thread that hands them out, one after the other.

#include <atomic>
#include <cstddef>
#include <deque>
#include <functional>
#include <future>
#include <system_error>

namespace geom {

// Runs each task after the one before, on a thread of its own, or at once where no such thread is
// wanted or had. What a task throws is thrown by a later call of run() or finish(), and no task
// after it runs.
class Beside {
 public:
  // So many tasks may be under way; 0: each is run at once.
  explicit Beside(std::size_t most) : most_(most) {}
  ~Beside() {
    for (const std::shared_future<void>& task : tasks_) task.wait();
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  // Waits for the oldest task where there are as many as may be.
  void run(const std::function<void()>& task) {
    while (!tasks_.empty() && tasks_.size() >= most_) finish_oldest();
    if (most_ > 0) {
      try {
        const auto before = tasks_.empty() ? std::shared_future<void>() : tasks_.back();
        ++waiting_;
        const auto next = [this, before, task] {
          if (before.valid()) before.get();
          --waiting_;
          task();
        };
        tasks_.push_back(std::async(std::launch::async, next).share());
        return;
      } catch (const std::system_error&) {  // no more threads
        --waiting_;
        finish();
      }
    }
    task();
  }

  // Whether a task waits for its turn: for a task that has work only while none does.
  bool is_waited_for() const { return waiting_ > 0; }

  void finish() {
    while (!tasks_.empty()) finish_oldest();
  }

 private:
  void finish_oldest() {
    const std::shared_future<void> oldest = tasks_.front();
    tasks_.pop_front();
    oldest.get();
  }

  std::size_t most_;
  std::atomic<int> waiting_ = 0;
  std::deque<std::shared_future<void>> tasks_;
};

}  // namespace geom
