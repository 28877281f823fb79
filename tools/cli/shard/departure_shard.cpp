#include "departure_shard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/base/error.h"

namespace cli {
namespace {

[[noreturn]] void refuse(const ShardFile& shard, std::string_view what) {
  throw geom::InputError(shard.archive.name(),
                         {.says = std::string(what), .advice = "the file is damaged"});
}

// Whether the pairs follow each other in order, each of two flights.
bool are_pairs(const std::vector<traj::FlightPair>& pairs, std::size_t flights) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].first >= pairs[i].second || pairs[i].second >= flights) return false;
    if (i > 0 && !(pairs[i - 1] < pairs[i])) return false;
  }
  return true;
}

// The conflicts of one shard.
traj::FleetConflicts read(const ShardFile& shard, std::size_t flights) {
  const nlohmann::json& content = shard.content;
  if (shard.kind != "departures") {
    throw geom::InputError(shard.archive.name(),
                           {.expected = "a shard of skyway-fleet", .found = "one of another kind"});
  }
  if (!content.contains("flights") || content["flights"] != flights || !content.contains("near") ||
      !content["near"].is_number_unsigned()) {
    refuse(shard, fmt::format("expected a shard of {} flights, found another", flights));
  }
  traj::FleetConflicts out;
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

void write_shard(const Sharding& sharding, const std::string& file,
                 const traj::FleetConflicts& conflicts, std::size_t flights) {
  std::vector<std::uint32_t> pairs;
  for (const auto& [a, b] : conflicts.pairs) {
    pairs.push_back(a);
    pairs.push_back(b);
  }
  std::vector<double> spans;
  for (const traj::DepartureSpan& span : conflicts.forbidden) {
    spans.push_back(span.low);
    spans.push_back(span.high);
  }
  const nlohmann::json content = {{"flights", flights}, {"near", conflicts.looked_at}};
  const geom::NamedArray arrays[] = {geom::named_array<std::uint32_t>("pairs", pairs, 2),
                                     geom::named_array<std::uint64_t>("ends", conflicts.ends),
                                     geom::named_array<double>("forbidden", spans, 2)};
  sharding.write(file, "output", "departures", content.dump(), arrays, Exit::yes);
}

traj::FleetConflicts joined_departures(std::span<const ShardFile> shards, std::size_t flights) {
  std::vector<traj::FleetConflicts> parts;
  for (const ShardFile& shard : shards) {
    parts.push_back(read(shard, flights));
    if (parts.size() > 1 && !parts.back().pairs.empty() && !parts[parts.size() - 2].pairs.empty() &&
        !(parts[parts.size() - 2].pairs.back() < parts.back().pairs.front())) {
      refuse(shard, "expected pairs that follow those of the shard before");
    }
  }
  return traj::joined(parts);
}

}  // namespace cli
