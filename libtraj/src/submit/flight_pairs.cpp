#include "traj/submit/flight_pairs.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "traj/record/pair_record.h"

namespace traj {

ComparedFlights compare_flights(FlightSet& flights, const geom::Execution& run) {
  if (flights.left_out() > 0) {
    throw geom::InputError("flights.jsonl",
                           {.expected = "flights between which distances can be computed",
                            .found = fmt::format("{} of others", flights.left_out())});
  }
  const TogetherResult result = flights.check(true, run);
  const TogetherTask& task = flights.task();
  ComparedFlights out;
  out.found.compared = result.pairs;
  out.found.refused = result.refused.size();
  for (const RefusedPair& pair : result.refused) {
    out.records += to_json_line(pair, task);
    if (out.found.named.size() == kMostNamedPairs) continue;
    out.found.named.push_back({task.ids[pair.flights.first], task.ids[pair.flights.second]});
  }
  out.records += to_json_line(result, task, flights.left_out());
  for (const ProvedPair& pair : result.proved) out.certificates += certificate_line(pair, task);
  if (result.ok()) {
    out.certificates += certificate_line(task, flights.flights());
  } else {
    out.certificates.clear();
  }
  return out;
}

}  // namespace traj
