#pragma once

// Where the name of an output leads: to a file that is replaced, or to something written in place.

#include <sys/types.h>

#include <optional>
#include <string>

namespace cli {

struct Destination {
  std::string path;            // symbolic links followed: what they lead to is replaced, they stay
  int descriptor = -1;         // it names one of ours: /dev/stdout, /dev/stderr, /dev/fd/3
  bool in_place = false;       // a device or a pipe: written, not replaced
  std::optional<mode_t> mode;  // permissions of the file that will be replaced
};

// Throws std::system_error where links lead in a circle, and where a file is there that may not be
// written. "-" is stdout.
Destination destination_of(const std::string& path);

}  // namespace cli
