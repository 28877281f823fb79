#include "traj/mission/formats/fence_file.h"

#include <algorithm>
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

bool is_fence_text(std::string_view head) {
  if (!head.starts_with("QGC WPL")) return false;
  bool fence = false;
  for (std::size_t at = head.find('\n'); at < head.size(); at = head.find('\n', at + 1)) {
    std::size_t field = at + 1;
    for (int i = 0; i < 3 && field > 0; ++i) {
      field = head.find('\t', std::min(field, head.size())) + 1;
    }
    if (field == 0 || field >= head.size()) break;
    const std::string_view command = head.substr(field, 5);
    if (!fence && head.substr(at + 1).starts_with("0\t") && command.starts_with("16\t")) continue;
    if (command != "5100\t" && !(command.starts_with("500") && command.ends_with('\t')))
      return false;
    fence = true;
  }
  return fence;
}

}  // namespace traj
