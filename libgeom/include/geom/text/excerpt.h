#pragma once

// Text of a file as a message may show it: nothing that steers a terminal, and not too much.
//
// Example:
//   assert(geom::printable("a\tb\x1b[0m") == "a\\tb\\x1b[0m");
//   assert(geom::excerpt(std::string(100, 'x'), 10).ends_with("..."));

#include <cstddef>
#include <string>
#include <string_view>

namespace geom {

// `text`, in which control characters, marks that turn the direction of writing, and bytes that are
// not UTF-8 are written as \n, \t, \x1b or \u202e. Everything else stays as it is.
std::string printable(std::string_view text);

// The same, cut to about `most` bytes. A text that was cut ends in "...".
std::string excerpt(std::string_view text, std::size_t most = 60);

}  // namespace geom
