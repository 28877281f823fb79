#pragma once

// What can be said of one piece of a curve in whole numbers: whether it is off every box near it,
// or inside one.

#include <optional>
#include <utility>
#include <vector>

#include "gmp_bernstein.h"
#include "traj/proof/exact/exact_check.h"

namespace traj::exact {

enum class Verdict { holds, fails_at_begin, fails_at_end, unknown };

// Closed, in 2^-1074 m.
struct Box {
  Point low;
  Point high;
  std::size_t index = 0;
};

// A curve and the boxes that its bounding box meets. The boxes outlive it.
struct Exposed {
  Curve curve;
  std::vector<const Box*> near;
};

Exposed exposed(Curve curve, const std::vector<const Box*>& boxes);
std::pair<Exposed, Exposed> halves(const Exposed& piece);

// Off every box by planes, which it appends; fails where an end of the piece is in a box.
class JudgeClear {
 public:
  explicit JudgeClear(std::vector<PieceAndPlane>& planes) : planes_(planes) {}
  std::optional<std::size_t> culprit;  // the box of the last verdict that was not `holds`

  Verdict operator()(const Exposed& piece, std::size_t number);

 private:
  std::vector<PieceAndPlane>& planes_;
};

// All control points in the box.
struct JudgeInside {
  const Box& bounds;

  Verdict operator()(const Curve& curve, std::size_t number) const;
};

}  // namespace traj::exact
