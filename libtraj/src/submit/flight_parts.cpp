#include "traj/submit/flight_parts.h"

#include "geom/base/text_stream.h"
#include "geom/record/volume4d.h"
#include "traj/record/verdict.h"
#include "traj/submit/risk_geojson.h"

namespace traj {
namespace {

constexpr const char* kWritten = "what was written";

FlightParts refused(FlightParts parts, std::string why) {
  parts.refusal = std::move(why);
  return parts;
}

}  // namespace

FlightParts flight_parts(const SubmittedFlight& flight, const geom::BoxMap& map) {
  FlightParts out{.id = flight.report().id};
  if (std::string why = flight.refusal(); !why.empty()) {
    return refused(out, accepted(flight.report()) ? why : in_words(flight.report(), map));
  }
  out.volumes = volumes_json(flight.intent());
  geom::TextInput in(out.volumes);
  const geom::IntentVolumes intent = geom::read_intent_volumes(in, kWritten);
  if (const auto why = flight.why_not_held(intent)) return refused(out, *why);
  out.risk = risk_geojson(out.id, intent, risk_volumes(intent, flight.risk_task(), out.id));
  const ReadRisk risk = read_risk_geojson(out.risk, kWritten);
  if (const auto why = why_risk_not_held(intent, risk.volumes, flight.risk_task(), kWritten)) {
    return refused(out, *why);
  }
  out.claims = flight.claims(intent, risk.volumes);
  out.buffers = risk.volumes.buffers;
  if (const auto* trajectory = dynamic_cast<const SubmittedTrajectory*>(&flight)) {
    out.certificate = trajectory->certificate();
  }
  return out;
}

}  // namespace traj
