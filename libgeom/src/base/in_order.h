#pragma once

// A stream of items that are read one by one, worked on by all threads, and taken in their order.

#include <cstddef>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

#include "geom/base/parallel.h"

namespace geom {

// Calls `next()` until it gives nothing, `work(item)` of each item, and `take(item)` of each in the
// order in which it came. `next` and `take` are called by one thread at a time each, which need not
// be the caller's, and at the same time as the other and as `work` of other items; so they must not
// share what they change. Three times as many items as `window` (at least one) are held at most.
//
// What is thrown is what one thread would throw that does an item wholly before the next, and all
// items before it were taken; some after it may have been worked on. `run.progress` is not called.
template <class Item, class Next, class Work, class Take>
void in_order(const Execution& run, std::size_t window, const Next& next, const Work& work,
              const Take& take) {
  struct Held {
    std::optional<Item> item;
    std::exception_ptr failure;  // of next() or work(): thrown when its turn comes
  };
  bool more = true;
  const auto read = [&] {
    std::vector<Held> out;
    while (more && (out.empty() || out.size() < window)) {
      Held& held = out.emplace_back();
      try {
        held.item = next();
        more = held.item.has_value();
      } catch (...) {
        held.failure = std::current_exception();
        more = false;
      }
    }
    return out;
  };
  std::vector<Held> worked_on;
  std::vector<Held> ready;
  while (more || !worked_on.empty() || !ready.empty()) {
    std::vector<Held> fresh;
    parallel_for(worked_on.size() + 2, {run.threads, {}}, [&](std::size_t i) {
      if (i == 0) {
        for (Held& held : ready) {
          if (held.failure) std::rethrow_exception(held.failure);
          if (held.item) take(*held.item);
          held.item.reset();
        }
        return;
      }
      if (i == 1) {
        fresh = read();
        return;
      }
      Held& held = worked_on[i - 2];
      try {
        if (held.item) work(*held.item);
      } catch (...) {
        held.failure = std::current_exception();
      }
    });
    ready = std::move(worked_on);
    worked_on = std::move(fresh);
  }
}

}  // namespace geom
