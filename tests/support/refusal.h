#pragma once

// What a reader says of bad input.

#include <string>

#include "geom/base/error.h"

namespace support {

// The message of the InputError that f() throws; empty where it throws none.
template <class F>
std::string refusal_of(const F& f) {
  try {
    f();
  } catch (const geom::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace support
