#include "traj/home/flight_contingencies.h"

#include <fmt/format.h>

#include <algorithm>
#include <istream>
#include <utility>

#include "geom/base/error.h"
#include "geom/text/record_lines.h"
#include "traj/home/contingency_proof.h"

namespace traj {

void require_of(const HomeFlight& flight, const ContingencyRecord& way, std::string_view source,
                std::size_t line) {
  if (way.id != flight.id) {
    throw geom::InputError(
        source, line,
        {.expected = "ways home of flight " + flight.id, .found = "one of flight " + way.id});
  }
  require_of_flight(way.id, way.flight_hash, {flight.checked_hash}, source, line);
}

FlightContingencies::FlightContingencies(std::istream& in, std::string source,
                                         ContingencyRules rules)
    : source_(std::move(source)), rules_(std::move(rules)) {
  geom::for_each_line(in, source_, [&](const std::string& text, std::size_t line) {
    ContingencyRecord record = parse_contingency_record(text, source_, line);
    records_[record.id].push_back(std::move(record));
  });
}

const std::vector<ContingencyRecord>& FlightContingencies::records_of(
    const HomeFlight& flight) const {
  static const std::vector<ContingencyRecord> none;
  const auto found = records_.find(flight.id);
  return found == records_.end() ? none : found->second;
}

geom::Provenance FlightContingencies::room_of(const HomeFlight& flight) const {
  geom::Provenance out = flight.provenance;
  double margin = std::max(out.margin.value_or(0), least_margin(rules_.models));
  for (const ContingencyRecord& record : records_of(flight)) {
    require_of(flight, record, source_, 0);
    geom::require_map_agrees(record.provenance, flight.provenance, source_, 0);
    margin = std::max(margin, record.provenance.margin.value_or(0));
  }
  out.margin = margin;
  return out;
}

CheckedContingencies FlightContingencies::check(const geom::CollisionScene& scene,
                                                const HomeFlight& flight,
                                                const ContingencyProof& proof) const {
  const auto& records = records_of(flight);
  CheckedContingencies out{check_contingencies(scene, flight.id, flight.stages, records, rules_)};
  out.report.checked_hash = flight.checked_hash;
  if (!out.report.result.ok || !(proof.exact || proof.certificate)) return out;
  const auto ways = proved_ways(scene, flight.stages, records, rules_);
  const ExactTask task{scene.map(), scene.vehicle(), scene.margin()};
  out.report.exact = check_exactly(task, flight.stages, ways);
  if (!proof.certificate || !out.report.exact->ok) return out;
  out.certificate = contingency_certificate_line(scene, flight, ways, rules_);
  return out;
}

void FlightContingencies::require_used(const std::set<std::string>& flights) const {
  for (const auto& [id, records] : records_) {
    if (flights.contains(id)) continue;
    throw geom::InputError(source_, {.expected = "contingencies of the flights that are checked",
                                     .found = fmt::format("some of flight {}", id)});
  }
}

}  // namespace traj
