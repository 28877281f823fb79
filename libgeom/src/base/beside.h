#pragma once

// One task at a time beside the thread that hands it out.

#include <functional>
#include <future>
#include <system_error>

namespace geom {

// Runs tasks one after the other on a thread of their own, or at once where no such thread is
// wanted or had. What a task throws is thrown by the next call of run() or finish().
class Beside {
 public:
  explicit Beside(bool alone) : alone_(alone) {}
  ~Beside() {
    if (task_.valid()) task_.wait();
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  // Waits for the task before.
  void run(const std::function<void()>& task) {
    finish();
    if (!alone_) {
      try {
        task_ = std::async(std::launch::async, task);
        return;
      } catch (const std::system_error&) {  // no more threads
      }
    }
    task();
  }

  void finish() {
    if (task_.valid()) task_.get();
  }

 private:
  bool alone_;
  std::future<void> task_;
};

}  // namespace geom
