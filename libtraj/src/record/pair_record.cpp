#include "traj/record/pair_record.h"

#include <fmt/format.h>

#include <cmath>
#include <tuple>

#include "geom/text/json_line.h"

namespace traj {
namespace {

using geom::JsonLine;

JsonLine object_of(const Zone& zone) {
  JsonLine line;
  line.add("shape", zone.round ? "cylinder" : "box").add("reach", zone.reach);
  return line;
}

void add(JsonLine& line, const Spacing& spacing) {
  if (spacing.zone) {
    line.add("separation", object_of(*spacing.zone));
  } else {
    line.add("separation", "vehicles");
  }
  if (spacing.downwash) line.add("downwash", object_of(*spacing.downwash));
}

// Without a begin or end: null.
std::tuple<std::optional<double>, std::optional<double>> list_of(const TimeSpan& span) {
  const auto end = [](double t) { return std::isfinite(t) ? std::optional(t) : std::nullopt; };
  return {end(span.begin), end(span.end)};
}

const char* reason_of(const PairResult& result) {
  if (result.apart) return "exact";  // never, unless one of the two checks is wrong
  return result.undecided ? "undecided" : "separation";
}

JsonLine list_of_cover(const ApartCover& cover) {
  JsonLine line;
  line.add("pieces", cover.pieces).add("sides", cover.sides);
  return line;
}

double across(const PairResult& result) {
  const Vec3 apart = result.place - result.other;
  return std::hypot(apart.x(), apart.y());
}

double up(const PairResult& result) { return std::abs((result.place - result.other).z()); }

}  // namespace

std::string to_json_line(const RefusedPair& pair, const TogetherTask& task) {
  const PairResult& result = pair.result;
  JsonLine line;
  line.add("type", "pair");
  line.add("ids", std::tuple(task.ids[pair.flights.first], task.ids[pair.flights.second]));
  line.add("ok", false).add("reason", reason_of(result));
  line.add("time", result.time).add("place", result.place).add("other", result.other);
  line.add("share", result.share).add("worst", result.depth);
  line.add("across", across(result)).add("up", up(result));
  line.add("zone", object_of(pair.zones[result.zone]));
  line.add("when", result.when, list_of).add("epoch", task.epoch);
  return line.line();
}

std::string to_json_line(const TogetherResult& result, const TogetherTask& task,
                         std::size_t left_out) {
  JsonLine line;
  line.add("type", "together").add("ok", result.ok() && left_out == 0);
  line.add("flights", task.ids.size());
  if (left_out > 0) line.add("left_out", left_out);
  if (!task.dropped.empty()) line.add("dropped", task.dropped);
  line.add("pairs", result.pairs).add("near", result.near).add("pieces", result.pieces);
  line.add("refused", result.refused.size());
  add(line, task.rule.spacing);
  if (task.overridden) line.add("overridden", std::tuple("vehicle"));
  return line.add("parked", name(task.rule.parked))
      .add("map", task.map)
      .add("epoch", task.epoch)
      .add("flights_hash", task.flights_hash)
      .line();
}

std::string certificate_line(const ProvedPair& pair, const TogetherTask& task) {
  JsonLine line;
  line.add("type", "apart");
  line.add("ids", std::tuple(task.ids[pair.flights.first], task.ids[pair.flights.second]));
  std::vector<std::vector<JsonLine>> stretches;
  for (const auto& covers : pair.proof.stretches) {
    auto& out = stretches.emplace_back();
    for (const ApartCover& cover : covers) out.push_back(list_of_cover(cover));
  }
  return line.add("stretches", stretches).line();
}

std::string certificate_line(const TogetherTask& task, std::span<const TimedFlight> flights) {
  JsonLine line;
  line.add("type", "together").add("flights", task.ids);
  add(line, task.rule.spacing);
  if (!task.rule.spacing.zone) line.add("rooms", flights, &TimedFlight::room);
  return line.add("parked", name(task.rule.parked)).add("epoch", task.epoch).line();
}

std::string in_words(const RefusedPair& pair, const TogetherTask& task) {
  const PairResult& result = pair.result;
  const Zone& zone = pair.zones[result.zone];
  return fmt::format(
      "{} and {} are {:.4g} m apart across and {:.4g} m in height at {:.6g} s, near ({:.2f}, "
      "{:.2f}, {:.2f}); {}",
      task.ids[pair.flights.first], task.ids[pair.flights.second], across(result), up(result),
      result.time, result.place.x(), result.place.y(), result.place.z(),
      result.undecided
          ? "that could not be shown to be enough"
          : fmt::format("expected more than {:.4g} m{} or more than {:.4g} m in height",
                        zone.reach.x(),
                        zone.round ? "" : fmt::format(" ({:.4g} m along y)", zone.reach.y()),
                        zone.reach.z()));
}

}  // namespace traj
