#pragma once

// What files hold, to be compared.

#include <span>
#include <sstream>
#include <string>

#include "plan/lattice/lattice_file.h"
#include "plan/roadmap/roadmap_file.h"

namespace plan {

inline std::string bytes(const Lattice& lattice) {
  std::ostringstream out;
  write_lattice(out, lattice);
  return out.str();
}

inline std::string bytes(std::span<const Roadmap> parts) {
  std::ostringstream out;
  write_roadmap(out, parts);
  return out.str();
}

inline std::string bytes(const Roadmap& roadmap) {
  std::ostringstream out;
  write_roadmap(out, roadmap);
  return out.str();
}

}  // namespace plan
