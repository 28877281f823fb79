#include "timed_boxes.h"

#include <fmt/format.h>

#include "geom/text/instant.h"

namespace geom {

std::optional<std::string> timed_fault(const TimedBoxes& timed, std::size_t boxes,
                                       const std::optional<std::string>& epoch) {
  if (timed.box.size() != timed.time.size()) {
    return fmt::format("timed and times must have one row a timed box, and have {} and {}",
                       timed.box.size(), timed.time.size());
  }
  if (epoch && epoch_from(*epoch) != epoch) {
    return fmt::format(
        "epoch must be an instant in UTC such as \"2026-05-04T06:30:00Z\", found \"{}\"", *epoch);
  }
  if (timed.box.empty()) return std::nullopt;
  if (!epoch) {
    return "some boxes are there for a time only, so expected the epoch that their seconds count "
           "from, found none";
  }
  for (std::size_t k = 0; k < timed.box.size(); ++k) {
    if (timed.box[k] >= boxes || (k > 0 && timed.box[k] <= timed.box[k - 1])) {
      return fmt::format(
          "timed[{}] must be the index of a box, below {}, above the one before, "
          "found {}",
          k, boxes, timed.box[k]);
    }
    if (const auto fault = span_fault(timed.time[k])) {
      return fmt::format("box {}: {}", timed.box[k], *fault);
    }
    if (timed.time[k].always()) {
      return fmt::format(
          "times of box {}: expected one end at least, found an obstacle that is "
          "always there",
          timed.box[k]);
    }
  }
  return std::nullopt;
}

}  // namespace geom
