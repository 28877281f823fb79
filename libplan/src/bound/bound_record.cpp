#include "plan/bound/bound_record.h"

#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "geom/text/json_line.h"

namespace plan {
namespace {

using Part = LengthProof::Part;

std::vector<double> of_first_level(const Part& part) {
  std::vector<double> out(part.low.data(), part.low.data() + 3);
  if (part.axis == 3) return out;
  for (const double v : {part.high[part.axis], double{1} * part.axis, double{1} * part.outward[0],
                         double{1} * part.outward[1]}) {
    out.push_back(v);
  }
  return out;
}

std::vector<double> of_finer_level(const Part& part) {
  std::vector<double> out{static_cast<double>(part.parent)};
  if (part.axis == 3) return out;
  out.push_back(part.low[part.axis]);
  out.push_back(part.high[part.axis]);
  return out;
}

// Without the sides that no short path comes from.
std::vector<std::optional<double>> written(const LengthProof::Lines& lines) {
  std::vector<std::optional<double>> out;
  for (const int side : {0, 2}) {
    if (!std::isfinite(lines[side])) {
      out.push_back(std::nullopt);
    } else {
      out.push_back(lines[side]);
      out.push_back(lines[side + 1]);
    }
  }
  return out;
}

// [from, to, occluder, to, occluder …] of each part that hides some.
std::vector<std::vector<std::uint32_t>> by_part(std::span<const LengthProof::Hidden> hidden) {
  std::vector<std::vector<std::uint32_t>> out;
  for (const LengthProof::Hidden& h : hidden) {
    if (out.empty() || out.back().front() != h.from) out.push_back({h.from});
    out.back().push_back(h.to);
    out.back().push_back(h.occluder);
  }
  return out;
}

geom::JsonLine to_json(const LengthProof::Level& level, bool first) {
  geom::JsonLine line;
  // The start and the goal are known.
  const std::span<const Part> parts(level.parts.begin() + 2, level.parts.end());
  line.add("parts", parts, first ? of_first_level : of_finer_level);
  line.add("come", level.come, written);
  if (!level.go.empty()) line.add("go", level.go, written);
  line.add("hidden", by_part(level.hidden));
  return line;
}

}  // namespace

std::string to_json_line(const BoundRecord& record) {
  geom::JsonLine line;
  line.add("type", "bound").add("id", record.id);
  add(line, record.provenance);
  line.add("bounds", std::tuple(record.bounds.min, record.bounds.max));
  line.add("from", record.from).add("to", record.to).add("bound", record.bound);
  line.add("occluders", record.proof.occluders,
           [](const geom::Aabb& box) { return std::tuple(box.min, box.max); });
  bool first = true;
  line.add("levels", record.proof.levels, [&](const LengthProof::Level& level) {
    return to_json(level, std::exchange(first, false));
  });
  return line.line();
}

}  // namespace plan
