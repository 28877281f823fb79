#pragma once

// The property that no reader leaves an obstacle out in silence: a marked feature of a random file
// is in what was read, or the reader says that something is not.

#include <fmt/format.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "geom/base/error.h"
#include "geom/base/skipped.h"
#include "geom/shape/aabb.h"
#include "geom/text/excerpt.h"
#include "support/random_city.h"

namespace support {

// A file in one of the spellings of its format.
struct MarkedFile {
  std::string bytes;
  std::vector<geom::Vec3> marks;  // all of these are in the map, or the reader refuses or skips
  bool must_tell = false;         // the file says what no map can hold: it must refuse or skip
};

enum class Outcome { held, told, lost };

inline Outcome outcome_of(bool all_held, const geom::Skipped& skipped) {
  return !skipped.empty() ? Outcome::told : all_held ? Outcome::held : Outcome::lost;
}

inline bool held(const std::vector<geom::Aabb>& boxes, const std::vector<geom::Vec3>& marks) {
  for (const geom::Vec3& mark : marks) {
    bool in = false;
    for (const geom::Aabb& box : boxes) in = in || geom::contains(box, mark);
    if (!in) return false;
  }
  return true;
}

// Reads `count` files: make(random) writes one, read(stream, file) gives what became of its marks.
// Prints how many were held, told and lost; gives how many were lost. A reader that refuses nearly
// everything fails as well: at least a third must be held.
template <class Make, class Read>
std::size_t left_out(const char* reader, std::size_t count, const Make& make, const Read& read) {
  std::size_t counts[3] = {};
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    Random random(seed);
    const MarkedFile file = make(random);
    Outcome outcome = Outcome::told;
    std::string why;
    try {
      std::istringstream in(file.bytes);
      outcome = read(in, file);
      if (file.must_tell && outcome == Outcome::held) outcome = Outcome::lost;
    } catch (const geom::InputError& error) {
      why = error.what();
    }
    ++counts[static_cast<int>(outcome)];
    if (outcome == Outcome::lost && counts[2] <= 3) {
      fmt::print("{}, seed {}: left out in silence: {}\n", reader, seed,
                 geom::printable(std::string_view(file.bytes).substr(0, 2000)));
    }
  }
  fmt::print("{}: files {} held {} told {} lost {}\n", reader, count, counts[0], counts[1],
             counts[2]);
  if (3 * counts[0] < count) {
    fmt::print("{}: expected at least a third of the files to be read\n", reader);
    return counts[2] + 1;
  }
  return counts[2];
}

// One of several.
template <class T>
const T& one_of(Random& random, const std::vector<T>& some) {
  return some[static_cast<std::size_t>(random.below(static_cast<int>(some.size())))];
}
inline std::string one_of(Random& random, std::initializer_list<const char*> some) {
  return *(some.begin() + random.below(static_cast<int>(some.size())));
}
inline bool chance(Random& random, int in) { return random.below(in) == 0; }

// A place of six decimals within 1 km, unlike any other in its digits.
inline geom::Vec3 random_place(Random& random) {
  const auto rounded = [&] { return std::round(random.uniform(-1e9, 1e9)) / 1e6; };
  return {rounded(), rounded(), rounded()};
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

// Line ends as programs write them; some are a carriage return alone, in one line or in all.
inline std::string with_line_ends(Random& random, const std::string& text) {
  switch (random.below(8)) {
    case 0:
      return replaced(text, "\n", "\r\n");
    case 1:
      return replaced(text, "\n", "\r");
    case 2: {
      std::string out = text;
      const std::size_t at =
          out.find('\n', static_cast<std::size_t>(random.below(static_cast<int>(out.size()))));
      if (at != std::string::npos) out[at] = '\r';
      return out;
    }
    default:
      return text;
  }
}

}  // namespace support
