#pragma once

// What --snap-ends did, said on stderr.

#include <cstddef>
#include <string>
#include <vector>

#include "cli/run.h"

namespace planning {

// The ends of a batch that were moved: the first ones each, of the others how many.
class SnappedEnds {
 public:
  // `moved`: of plan::moved_ends(), query by query.
  void add(const std::vector<std::string>& moved);
  void say(const cli::Common& common) const;

 private:
  std::vector<std::string> first_;
  std::size_t count_ = 0;
};

}  // namespace planning
