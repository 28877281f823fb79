#pragma once

// The one exception for "the world is wrong": a bad file, a bad record, artefacts that do not
// belong together.

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
