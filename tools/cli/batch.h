#pragma once

// How a batch of records came out, for people.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "cli/option/common.h"

namespace cli {

// Counts what each record came to. One that failed alone in its run is no batch: its own message
// says why.
class Batch {
 public:
  void add_good() { ++total_; }
  void add_failed(std::string_view why);  // in a word, such as the record's status

  // Says on stderr, unless -q, how many failed and why, where some of several did: "skyway-plan: 6
  // of 10 queries have no path: 4 goal_blocked, 2 unreachable". `what`: "queries have no path".
  void tell(const Common& common, std::string_view tool, std::string_view what) const;

  // That line's words; empty where there is nothing to say. The most frequent reason comes first.
  std::string text(std::string_view what) const;

 private:
  std::size_t total_ = 0;
  std::size_t failed_ = 0;
  std::map<std::string, std::size_t, std::less<>> reasons_;
};

}  // namespace cli
