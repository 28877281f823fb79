#pragma once

// What a search for a bound writes down, for others to follow.

#include <vector>

#include "level.h"
#include "occluders.h"
#include "plan/bound/length_proof.h"

namespace plan {

class ProofLog {
 public:
  // Each level in turn: its parts, that some are hidden, and its labels once they are complete.
  void begin(const Level& level);
  void hide(std::uint32_t from, std::uint32_t to, std::uint32_t occluder);
  void come(const std::vector<LineLabel>& labels) { proof_.levels.back().come = lines(labels); }
  void go(const std::vector<LineLabel>& labels) { proof_.levels.back().go = lines(labels); }

  // Without a level whose labels never were complete; the occluders that are named, each once.
  LengthProof take(const Occluders& occluders) &&;

 private:
  static std::vector<LengthProof::Lines> lines(const std::vector<LineLabel>& labels);

  LengthProof proof_;
};

}  // namespace plan
