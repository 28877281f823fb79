#pragma once

// What each fuzz target does with its bytes: only InputError may come out.

#include <cstdint>
#include <sstream>
#include <string>

#include "geom/base/error.h"

template <class Read>
int refuses_or_reads(const std::uint8_t* data, std::size_t size, const Read& read) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  try {
    read(in);
  } catch (const geom::InputError&) {
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
