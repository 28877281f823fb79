#include "answer.h"

#include "traj/record/corridor_record.h"

namespace solving {
namespace {

constexpr double kDrawnReach = 10;  // metres: how far a corridor is drawn from its piece

}  // namespace

std::string to_text(const traj::SolvedRecord& solved, bool with_corridor) {
  const traj::TrajectoryRecord& record = solved.record;
  const bool solved_one = record.status == traj::TrajectoryStatus::solved && record.rung;
  std::string out(solved_one ? name(*record.rung) : name(record.status));
  out += '\n' + traj::to_json_line(record);
  if (with_corridor) {
    out += traj::to_json_line(record.id, record.provenance, solved.corridor, kDrawnReach);
  }
  return out;
}

Answer parse_answer(std::string_view text) {
  const std::size_t first = text.find('\n') + 1;
  const std::size_t second = text.find('\n', first) + 1;
  return {text.substr(0, first - 1), text.substr(first, second - first), text.substr(second)};
}

}  // namespace solving
