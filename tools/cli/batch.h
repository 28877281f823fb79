#pragma once

// How a batch of records came out, for people.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cli/option/common.h"

namespace cli {

// Counts what each record came to.
class Batch {
 public:
  void add_good() { ++total_; }
  // `why` in a word, such as the record's status, and in a sentence that names the record; empty
  // where something else says that.
  void add_failed(std::string_view why, std::string sentence = "");

  // Says on stderr, unless -q, the sentences of the first that failed. Where some of several did,
  // says how many and why, too: "skyway-plan: 6 of 10 queries have no path: 4 goal_blocked, 2
  // unreachable". `what`: "queries have no path".
  void tell(const Common& common, std::string_view tool, std::string_view what) const;

  // That line's words; empty where there is nothing to say. The most frequent reason comes first.
  std::string text(std::string_view what) const;

 private:
  std::size_t total_ = 0;
  std::size_t failed_ = 0;
  std::map<std::string, std::size_t, std::less<>> reasons_;
  std::vector<std::string> sentences_;
};

}  // namespace cli
