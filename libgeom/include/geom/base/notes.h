#pragma once

// What a reader says of a file beside its answer.
//
// Example:
//   std::vector<std::string> warnings;
//   geom::Notes notes;
//   notes.warning = [&](const std::string& text) { warnings.push_back(text); };

#include <functional>
#include <string>

namespace geom {

// Each text is one sentence or more and names the file first. Both are called by the thread that
// reads, in the order in which things are found. A note that came before an exception stays.
struct Notes {
  // What was read, and what was taken for granted.
  std::function<void(const std::string&)> remark = [](const std::string&) {};
  // What may be wrong.
  std::function<void(const std::string&)> warning = [](const std::string&) {};
};

}  // namespace geom
