#pragma once

// The one exception for bad input: a bad file, a bad record, artefacts that do not belong together.
//
// Example:
//   const geom::InputError error("city.csv", 17, "half size y must be >= 0, found \"-2\"");
//   assert(std::string(error.what()) == "city.csv:17: half size y must be >= 0, found \"-2\"");

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace geom {

// what() reads "source:line: message", or "source: message" when `line` is 0.
class InputError : public std::runtime_error {
 public:
  InputError(std::string_view source, std::size_t line, std::string_view message)
      : std::runtime_error(std::string(source) + (line ? ":" + std::to_string(line) : "") + ": " +
                           std::string(message)) {}
  InputError(std::string_view source, std::string_view message) : InputError(source, 0, message) {}
};

}  // namespace geom
