#include "traj/mission/formats/fence_file.h"

#include <istream>

#include "geom/base/error.h"
#include "traj/mission/formats/qgc_plan.h"
#include "traj/mission/formats/wpl.h"

namespace traj {

std::vector<GeodeticFence> read_fences(std::istream& in, std::string_view source) {
  in >> std::ws;
  auto fences = in.peek() == '{' ? read_qgc_fences(in, source) : read_wpl_fences(in, source);
  if (fences.empty()) throw geom::InputError(source, {.expected = "a fence", .found = "none"});
  return fences;
}

}  // namespace traj
