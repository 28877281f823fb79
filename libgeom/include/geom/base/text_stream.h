#pragma once

// Streams of a text in memory that throw std::bad_alloc if memory runs out.
//
// Example:
//   geom::TextInput in("first\nsecond\n");
//   std::string line;
//   std::getline(in, line);
//   geom::TextOutput out;
//   out << line;
//   assert(out.str() == "first");
//
// The plain streams of the standard library catch that exception: what is read then looks as if it
// ended there, and what is written lacks its end, and nobody is told.

#include <sstream>
#include <string>
#include <utility>

namespace geom {

class TextInput : public std::istringstream {
 public:
  explicit TextInput(std::string text = {}) : std::istringstream(std::move(text)) {
    exceptions(std::ios::badbit);
  }
};

class TextOutput : public std::ostringstream {
 public:
  TextOutput() { exceptions(std::ios::badbit); }
};

}  // namespace geom
