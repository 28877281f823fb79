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

// Closed, in 2^-1074 m; there from one instant to another, closed, in 2^-1074 s after the epoch. An
// end that it has not is absent.
struct Box {
  Point low;
  Point high;
  std::size_t index = 0;
  std::optional<Whole> from = {};
  std::optional<Whole> until = {};
};

// When a piece begins and ends, times 2^(1074 + shift).
struct Stretch {
  Whole begin;
  Whole end;
  unsigned shift = 0;
};

// 1 where the box is there only after the stretch, -1 where only before it; 0 where they share an
// instant.
int side_in_time(const Box& box, const Stretch& when);
bool holds_point(const Box& box, const Point& p, unsigned shift);

// A curve and the boxes that its bounding box meets. The boxes outlive it.
struct Exposed {
  Curve curve;
  std::vector<const Box*> near;
  Stretch when;
};

Exposed exposed(Curve curve, const std::vector<const Box*>& boxes, Stretch when);
std::pair<Exposed, Exposed> halves(const Exposed& piece);

// Off every box by planes and times, which it appends; fails where an end of the piece is in a box
// that is there at that instant.
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
