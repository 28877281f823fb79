#pragma once

// Ordered work in child processes, for libraries that may run only once in a process.
//
// Example:
//   std::istringstream in("2 3 4");
//   std::string all;
//   const auto next = [&]() -> std::optional<std::string> {
//     std::string word;
//     return in >> word ? std::optional(word) : std::nullopt;
//   };
//   const auto work = [](const std::string& word) { return word + word; };  // in a child process
//   geom::in_processes(2, next, work, [&](const std::string& one) { all += one; });
//   assert(all == "223344");

#include <functional>
#include <optional>
#include <string>

namespace geom {

// Calls next() until it gives nothing, work(text) of each text in one of up to `count` child
// processes, which see what this one holds by the first, and take(answer) here in the order of the
// texts, as soon as those before are taken. An InputError, UsageError, std::bad_alloc or other
// exception of work() is thrown here once all before it were taken, and std::runtime_error in place
// of the answer of a process that was killed: what is thrown is what one process would throw that
// does a text wholly before the next. At most 64 texts and answers are held. `next` and `take` are
// called by one thread at a time each, and may be called at once (in_order.h). With one process, or
// one text, nothing is forked. Call before any thread is running: children have only the caller's.
void in_processes(unsigned count, const std::function<std::optional<std::string>()>& next,
                  const std::function<std::string(const std::string&)>& work,
                  const std::function<void(const std::string&)>& take);

}  // namespace geom
