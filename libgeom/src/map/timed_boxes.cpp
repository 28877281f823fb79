#include "timed_boxes.h"

#include <fmt/format.h>

#include "geom/text/instant.h"

namespace geom {

std::optional<Fault> timed_fault(const TimedBoxes& timed, std::size_t boxes,
                                 const std::optional<std::string>& epoch) {
  if (timed.box.size() != timed.time.size()) {
    return Fault{
        .says = fmt::format("timed and times must have one row a timed box, and have {} and {}",
                            timed.box.size(), timed.time.size())};
  }
  if (epoch && epoch_from(*epoch) != epoch) {
    return Fault{.key = "epoch",
                 .expected = "an instant in UTC such as \"2026-05-04T06:30:00Z\"",
                 .found = in_quotes(*epoch)};
  }
  if (timed.box.empty()) return std::nullopt;
  if (!epoch) {
    return Fault{.says =
                     "some boxes are there for a time only, so expected the epoch that their "
                     "seconds count from",
                 .found = "none"};
  }
  for (std::size_t k = 0; k < timed.box.size(); ++k) {
    if (timed.box[k] >= boxes || (k > 0 && timed.box[k] <= timed.box[k - 1])) {
      return Fault{
          .key = fmt::format("timed[{}]", k),
          .expected = fmt::format("the index of a box, below {}, above the one before", boxes),
          .found = fmt::to_string(timed.box[k])};
    }
    if (const auto fault = span_fault(timed.time[k])) {
      return within(fmt::format("box {}", timed.box[k]), *fault);
    }
    if (timed.time[k].always()) {
      return Fault{.item = fmt::format("times of box {}", timed.box[k]),
                   .expected = "one end at least",
                   .found = "an obstacle that is always there"};
    }
  }
  return std::nullopt;
}

}  // namespace geom
