#include "traj/fleet/departure_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/text/parse_json.h"

namespace traj {
namespace {

[[noreturn]] void refuse(const geom::ShardFile& shard, std::string_view what) {
  throw geom::InputError(shard.archive.name(),
                         {.says = std::string(what), .advice = "the file is damaged"});
}

// Whether the pairs follow each other in order, each of two flights.
bool are_pairs(const std::vector<FlightPair>& pairs, std::size_t flights) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].first >= pairs[i].second || pairs[i].second >= flights) return false;
    if (i > 0 && !(pairs[i - 1] < pairs[i])) return false;
  }
  return true;
}

// The conflicts of one shard.
FleetConflicts read(const geom::ShardFile& shard, std::size_t flights) {
  const nlohmann::json content = geom::parse_json(shard.content, shard.archive.name());
  if (shard.kind != "departures") {
    throw geom::InputError(shard.archive.name(),
                           {.expected = "a shard of skyway-fleet", .found = "one of another kind"});
  }
  if (!content.contains("flights") || content["flights"] != flights || !content.contains("near") ||
      !content["near"].is_number_unsigned()) {
    refuse(shard, fmt::format("expected a shard of {} flights, found another", flights));
  }
  FleetConflicts out;
  out.looked_at = content["near"].get<std::size_t>();
  const auto pairs = shard.archive.array<std::uint32_t>("pairs", 2);
  const auto ends = shard.archive.array<std::uint64_t>("ends");
  const auto spans = shard.archive.array<double>("forbidden", 2);
  if (pairs.size() != 2 * ends.size()) refuse(shard, "expected an end for each pair, found others");
  for (std::size_t i = 0; i < ends.size(); ++i) {
    out.pairs.emplace_back(pairs[2 * i], pairs[2 * i + 1]);
  }
  if (!are_pairs(out.pairs, flights)) refuse(shard, "expected pairs of flights in order");
  out.ends.assign(ends.begin(), ends.end());
  std::uint64_t last = 0;
  for (const std::uint64_t end : out.ends) {
    if (end <= last || end > spans.size() / 2) refuse(shard, "expected spans for each pair");
    last = end;
  }
  if (last != spans.size() / 2) refuse(shard, "expected spans for each pair");
  for (std::size_t i = 0; i < spans.size(); i += 2) {
    if (!(spans[i] <= spans[i + 1]))
      refuse(shard, "expected spans that do not end before they begin");
    out.forbidden.push_back({spans[i], spans[i + 1]});
  }
  return out;
}

}  // namespace

geom::PartArrays arrays_of(const FleetConflicts& conflicts, std::size_t flights) {
  struct Columns {
    std::vector<std::uint32_t> pairs;
    std::vector<double> spans;
  };
  const auto columns = std::make_shared<Columns>();
  for (const auto& [a, b] : conflicts.pairs) {
    columns->pairs.push_back(a);
    columns->pairs.push_back(b);
  }
  for (const DepartureSpan& span : conflicts.forbidden) {
    columns->spans.push_back(span.low);
    columns->spans.push_back(span.high);
  }
  const nlohmann::json content = {{"flights", flights}, {"near", conflicts.looked_at}};
  return {content.dump(),
          {geom::named_array<std::uint32_t>("pairs", columns->pairs, 2),
           geom::named_array<std::uint64_t>("ends", conflicts.ends),
           geom::named_array<double>("forbidden", columns->spans, 2)},
          columns};
}

FleetConflicts joined_departures(std::span<const geom::ShardFile> shards, std::size_t flights) {
  std::vector<FleetConflicts> parts;
  for (const geom::ShardFile& shard : shards) {
    parts.push_back(read(shard, flights));
    if (parts.size() > 1 && !parts.back().pairs.empty() && !parts[parts.size() - 2].pairs.empty() &&
        !(parts[parts.size() - 2].pairs.back() < parts.back().pairs.front())) {
      refuse(shard, "expected pairs that follow those of the shard before");
    }
  }
  return joined(parts);
}

}  // namespace traj
