#pragma once

// The search for a bound: level by level, forward and backward, over parts that are halved.

#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "geom/collision/collision.h"
#include "level.h"
#include "occluders.h"
#include "plan/bound/bound.h"
#include "proof_log.h"

namespace plan {

inline constexpr double kPart = 10;  // metres: the longest part of the first level

// What a bound must be for a path of `length` to have the gap.
double bound_for(double length, double gap);

// Of one question. What it refers to must outlive it.
class BoundSearch {
 public:
  // `slack`: see line_label.h.
  BoundSearch(const geom::CollisionScene& scene, const Occluders& occluders,
              const BoundOptions& options, double length, double slack);

  // `parts`: all that a path of the map may bend at.
  LengthBound bound(const PartTree& parts, const Vec3& from, const Vec3& to);

 private:
  // One way through a level. Links are followed as they point, or against that.
  struct Pass {
    bool forward;
    const std::vector<LineLabel>& floors;  // known lower bounds of what is labelled
    const std::vector<LineLabel>& ahead;   // … and of what is left of the way
    std::vector<LineLabel> labels;         // of each state that a short path may use
    std::vector<char> waits;               // whether the label is to be carried on
    std::priority_queue<std::pair<double, State>, std::vector<std::pair<double, State>>,
                        std::greater<>>
        queue;
  };

  // Lower bounds of the way to each state, where it is short enough.
  std::vector<LineLabel> forward(Level& level);
  // … and from each state that `come` reaches to the goal.
  std::vector<LineLabel> backward(Level& level, const std::vector<LineLabel>& come);
  static Pass pass(bool forward, const Level& level, const std::vector<LineLabel>& ahead);
  static std::optional<State> next(Pass& pass);
  // The state's label to the other end of a link, which starts at part `owner`.
  void carry(Level& level, Pass& pass, State state, std::uint32_t owner, Link& link);
  bool lowers(const Pass& pass, State next, const LineLabel& by) const;
  bool in_sight(Level& level, std::uint32_t owner, Link& link);
  // Whether an occluder that hid other parts from `i` hides `j`.
  bool is_hinted(Level& level, std::uint32_t i, std::uint32_t j);

  void link(Level& level, std::uint32_t i, double come);
  void link_group(Level& level, std::uint32_t i, double come, std::uint32_t begin,
                  const PartGroup& group);
  void borrow_hints(Level& level, std::uint32_t i) const;
  static std::optional<Link> unseen_link(const std::vector<EdgePart>& parts, std::uint32_t i,
                                         std::uint32_t j);

  // What both passes leave of a level, its parts of more than `most` metres halved.
  Level finer(Level& level, std::vector<LineLabel> g, std::vector<LineLabel> h, double most);
  void drop_long(std::vector<LineLabel>& g, std::vector<LineLabel>& h) const;
  bool may_use(const std::vector<EdgePart>& parts, const std::vector<LineLabel>& come,
               const std::vector<LineLabel>& go, std::uint32_t i, const Link& link) const;

  std::vector<EdgePart> chain(const Level& level) const;
  // Looks for a shorter path: along the chain of the goal's label, or along any links.
  void shorten_by_chain(const Level& level, LengthBound& result);
  void shorten_by_links(const Level& level, const std::vector<LineLabel>& go, LengthBound& result);
  void take(geom::Polyline path, LengthBound& result);
  LengthBound levels(Level level);
  // Takes up what a pass says of the whole way; whether it is enough.
  bool closes(const LineLabel& label, LengthBound& result) const;
  bool spent() const { return steps_ > options_.most; }

  const geom::CollisionScene& scene_;
  const Occluders& occluders_;
  const BoundOptions& options_;
  double shortest_;  // metres: of a path that is known
  double wanted_;    // falls with it
  double target_;    // a little more: what is left out leads to paths of this length or more
  const double slack_;
  std::vector<State> before_;  // of each state: the one that its label came from last
  std::optional<ProofLog> log_;
  std::size_t steps_ = 0;
};

}  // namespace plan
