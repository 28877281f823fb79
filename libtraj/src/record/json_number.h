#pragma once

// A number of a JSON record, by its key.

#include <string>
#include <string_view>

#include "geom/record/record.h"

namespace traj {

inline void append_number(std::string& out, std::string_view key, double value) {
  out += ",\"";
  out += key;
  out += "\":";
  geom::append_json(out, value);
}

}  // namespace traj
