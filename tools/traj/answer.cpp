#include "answer.h"

#include "traj/record/corridor_record.h"
#include "traj/record/verdict.h"

namespace solving {
namespace {

constexpr double kDrawnReach = 10;  // metres: how far a corridor is drawn from its piece

}  // namespace

Answer answer_of(const traj::SolvedRecord& solved, bool with_corridor) {
  const traj::TrajectoryRecord& record = solved.record;
  const bool is_solved = record.status == traj::TrajectoryStatus::solved;
  Answer out{.id = record.id};
  out.found = is_solved && record.rung ? name(*record.rung) : name(record.status);
  if (!is_solved) out.why = traj::in_words(record);
  out.trajectory = traj::to_json_line(record);
  if (with_corridor) {
    out.corridor = traj::to_json_line(record.id, record.provenance, solved.corridor, kDrawnReach);
  }
  return out;
}

Answer answer_of(const traj::TubeSolved& solved, bool with_corridor, const geom::BoxMap& map) {
  Answer out = answer_of(solved.solved, with_corridor);
  out.rounds = traj::in_words(solved.rounds);
  if (!out.rounds.empty() && !out.why.empty()) out.why = "no trajectory: " + solved.why;
  out.report = traj::to_json_line(solved.report, {}, &map);
  return out;
}

}  // namespace solving
