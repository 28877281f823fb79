#pragma once

// What --snap-ends did, said on stderr.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/run.h"
#include "geom/collision/collision.h"
#include "geom/record/query_record.h"
#include "plan/planner/plan.h"

namespace planning {

// Empty where no end was moved. The result is that of the query.
std::vector<std::string> moved_ends(const geom::CollisionScene& scene, const geom::PlanQuery& query,
                                    const plan::PlanResult& result);

// The ends of a batch that were moved: the first ones each, of the others how many.
class SnappedEnds {
 public:
  // `moved`: of moved_ends(), query by query.
  void add(const std::vector<std::string>& moved);
  void say(const cli::Common& common) const;

 private:
  std::vector<std::string> first_;
  std::size_t count_ = 0;
};

}  // namespace planning
