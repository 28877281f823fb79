#include "answer.h"

#include "traj/record/corridor_record.h"

namespace solving {
namespace {

constexpr double kDrawnReach = 10;  // metres: how far a corridor is drawn from its piece

}  // namespace

namespace {

std::string found(const traj::TrajectoryRecord& record) {
  const bool solved = record.status == traj::TrajectoryStatus::solved && record.rung;
  return std::string(solved ? name(*record.rung) : name(record.status));
}

std::string records(const traj::SolvedRecord& solved, bool with_corridor) {
  const traj::TrajectoryRecord& record = solved.record;
  std::string out = traj::to_json_line(record);
  if (with_corridor) {
    out += traj::to_json_line(record.id, record.provenance, solved.corridor, kDrawnReach);
  }
  return out;
}

// The line that begins at `at`, with its end, which is then behind it.
std::string_view next_line(std::string_view text, std::size_t& at) {
  const std::size_t begin = at;
  at = text.find('\n', begin) + 1;
  return text.substr(begin, at - begin);
}

std::string_view without_end(std::string_view line) { return line.substr(0, line.size() - 1); }

}  // namespace

std::string to_text(const traj::SolvedRecord& solved, bool with_corridor) {
  return found(solved.record) + "\n\n\n\n" + records(solved, with_corridor);
}

std::string to_text(const traj::TubeSolved& solved, bool with_corridor, const geom::BoxMap& map) {
  const traj::SolvedRecord& record = solved.solved;
  return found(record.record) + '\n' + solved.why + '\n' + traj::in_words(solved.rounds) + '\n' +
         traj::to_json_line(solved.report, {}, &map) + records(record, with_corridor);
}

Answer parse_answer(std::string_view text) {
  std::size_t at = 0;
  Answer out;
  out.found = without_end(next_line(text, at));
  out.why = without_end(next_line(text, at));
  out.rounds = without_end(next_line(text, at));
  out.report = next_line(text, at);
  if (out.report.size() == 1) out.report = {};
  out.trajectory = next_line(text, at);
  out.corridor = text.substr(at);
  return out;
}

}  // namespace solving
