#pragma once

// The one exception for bad input: a bad file, a bad record, artefacts that do not belong together.
//
// Example:
//   const geom::InputError error("city.csv", 17,
//                                {.key = "half size y", .expected = ">= 0", .found = "-2"});
//   assert(std::string(error.what()) == "city.csv:17: half size y must be >= 0, found -2");

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace geom {

// What is wrong, in fields. An empty field says nothing.
//
//   Fault{.expected = "6 fields", .found = "5"}              expected 6 fields, found 5
//   Fault{.key = "margin", .expected = ">= 0", .found = "-1"}    margin must be >= 0, found -1
//   Fault{.says = "it has animations", .advice = "write one state of it"}
struct Fault {
  std::string item;      // the part of the source: "feature 3", "object \"a\""
  std::string key;       // what has the wrong value: "margin", "segments[2].duration"
  std::string says;      // a sentence, for a fault that neither form fits, or before `expected`
  std::string expected;  // "6 fields", ">= 0"
  std::string found;     // what stood there
  std::string advice;    // what may be the cause, and what to do next

  bool operator==(const Fault&) const = default;
};

// "item: says: expected …, found …: advice", or with a key "item: key must be …, found …: advice".
std::string sentence(const Fault& fault);

// The fault in a part of the source: `item` goes before the item that it has.
Fault within(std::string_view item, Fault fault);

// `text` in double quotes, as messages show what stood in a file.
std::string in_quotes(std::string_view text);

// what() reads "source:line: …", or "source: …" when `line` is 0; then sentence(fault).
class InputError : public std::runtime_error {
 public:
  InputError(std::string_view source, std::size_t line, Fault fault);
  InputError(std::string_view source, Fault fault) : InputError(source, 0, std::move(fault)) {}

  const std::string& source() const noexcept { return fields_->source; }
  std::size_t line() const noexcept { return fields_->line; }
  const Fault& fault() const noexcept { return fields_->fault; }

  // The same for another source, of which ours is a part: our source and line become its item.
  Fault as_item() const;

 private:
  struct Fields {
    std::string source;
    std::size_t line;
    Fault fault;
  };
  std::shared_ptr<const Fields> fields_;  // shared, because a copy of an exception must not throw
};

}  // namespace geom
