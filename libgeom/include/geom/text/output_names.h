#pragma once

// Names of the files of a stream of records: a pattern with one %s, which stands for the id.
//
// Example:
//   geom::OutputNames names("flights/%s.csv", "--output");
//   assert(names.of("tower 1", "flights.jsonl") == "flights/tower_1.csv");

#include <map>
#include <string>

namespace geom {

// The id as part of a file's name: letters, digits, ".", "_" and "-" stay, all else becomes "_",
// and so does a "." at the beginning. Never empty, at most 100 characters. Different ids may give
// the same.
std::string safe_name(const std::string& id);

class OutputNames {
 public:
  // Throws UsageError for a name with more than one %s. `option` names it there.
  OutputNames(std::string pattern, const char* option);

  bool each() const { return at_ != std::string::npos; }  // a file for each id

  // Throws InputError(source, …) where another id has that name, or one that differs by upper
  // and lower case alone: many drives and sticks keep one file for both.
  std::string of(const std::string& id, const std::string& source);

 private:
  std::string pattern_;
  std::size_t at_;                            // of %s
  std::map<std::string, std::string> id_of_;  // by the name in lower case
};

}  // namespace geom
