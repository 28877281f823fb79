#pragma once

// The readers of a room, to be fed damaged bytes: only InputError may come out of one.

#include <istream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "geom/base/error.h"

namespace fuzz {

struct Reader {
  const char* name;  // also the folder of its corpus
  void (*read)(std::istream& in);
};

// The readers of the room that the program feeds.
std::vector<Reader> readers();

inline std::string rest_of(std::istream& in) {
  return std::string(std::istreambuf_iterator<char>(in), {});
}

// Whether `read` takes the bytes and does not refuse them.
template <class Read>
bool takes(const std::string& bytes, const Read& read) {
  std::istringstream in(bytes);
  try {
    read(in);
  } catch (const geom::InputError&) {
    return false;
  }
  return true;
}

}  // namespace fuzz
