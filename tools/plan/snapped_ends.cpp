#include "snapped_ends.h"

#include <fmt/format.h>

#include "cli/tell.h"

namespace planning {
namespace {

constexpr std::size_t kSaid = 10;
}  // namespace

void SnappedEnds::add(const std::vector<std::string>& moved) {
  for (const std::string& one : moved) {
    if (count_++ < kSaid) first_.push_back(one);
  }
}

void SnappedEnds::say(const cli::Common& common) const {
  for (const std::string& one : first_) cli::tell(common, "skyway-plan", one);
  if (count_ > first_.size()) {
    cli::tell(common, "skyway-plan",
              fmt::format("{} more ends were moved: snapped_start and snapped_goal in the records "
                          "say where to",
                          count_ - first_.size()));
  }
}

}  // namespace planning
