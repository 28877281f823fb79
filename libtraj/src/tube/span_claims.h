#pragma once

// Bounds that a certificate claims, chosen while a proof goes on.

#include <deque>
#include <vector>

#include "traj/tube/prove_tube.h"

namespace traj {

// The spans of a flight, one after the other. Bounds are guessed for a span, and its periods show
// whether they hold. The first guess is the deviation in the span's first period, larger by as much
// as deviations grew in the span before. If it fails, the coordinates that failed get larger
// bounds; if that fails too, the span gets fewer periods. Bounds of a single period hold at once.
//
//   SpanClaims claims(least, 1);
//   do {
//     // From the span's start, claims.periods() times: a period in which deviations are at most
//     // claims.taken_for(found).
//   } while (!claims.settle());
class SpanClaims {
 public:
  using Bounds = std::vector<double>;

  // `least`: room that each coordinate gets beside its share, in the coordinate's unit. `order`:
  // after so many periods the loops run alike again. A deviation that only swings within that time
  // has not changed.
  SpanClaims(Bounds least, std::size_t order) : room_(std::move(least)), order_(order) {}

  // Periods that the span in progress should have.
  int periods() const { return periods_; }

  // The bounds that are taken to hold in a period of the span, in which deviations are at most
  // `found`.
  const Bounds& taken_for(const Bounds& found);

  // After the last period of the span (the flight's end may come first): whether there is room
  // between what was found and what was taken. Then a new span begins, else the same one does.
  bool settle();

  // The span in progress once more, for fewer periods; false: it has a single one.
  bool shorten();

  const std::vector<SpanBounds>& spans() const { return spans_; }

 private:
  void propose(const Bounds& found);
  bool has_room(std::size_t i) const;
  bool raise();  // where there is no room; false: there is everywhere
  int next_periods() const;

  // What was found at most in the last order_ periods.
  Bounds level() const;

  Bounds room_;
  std::size_t order_;
  std::deque<Bounds> last_;    // what was found in up to order_ periods,
  std::deque<Bounds> before_;  // and when the span began
  std::vector<SpanBounds> spans_;
  int periods_ = 1;
  int met_ = 0;    // periods of this span
  int tries_ = 0;  // of this span
  Bounds taken_;
  Bounds first_;   // the level in the span's first period,
  Bounds least_;   // the least,
  Bounds most_;    // and the most that was found
  Bounds growth_;  // of a period, in the span before
};

}  // namespace traj
