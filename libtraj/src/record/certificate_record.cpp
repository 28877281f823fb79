#include "traj/record/certificate_record.h"

#include <tuple>

#include "geom/text/json_line.h"
#include "traj/record/trajectory_record.h"

namespace traj {
namespace {

using geom::JsonLine;

void add_cover(JsonLine& line, const char* key, const Cover& cover) {
  if (!cover.empty()) line.add(key, cover);
}

// A piece, a box, and on which side of which axis: "+x"; "+t" is later.
std::tuple<std::size_t, std::size_t, std::string> list_of(const PieceAndPlane& plane) {
  return {plane.piece, plane.box, {plane.towards ? '+' : '-', "xyzt"[plane.axis]}};
}

void add_clear(JsonLine& line, const ClearCover& cover) {
  add_cover(line, "clear", cover.pieces);
  if (!cover.planes.empty()) line.add("planes", cover.planes, list_of);
}

JsonLine object_of(const SegmentProof& proof) {
  JsonLine line;
  add_clear(line, proof.clear);
  add_cover(line, "bounds", proof.bounds);
  for (const Limit limit : kOrderOfLimits) {
    add_cover(line, kind_of(limit).quantity, proof.limits[limit]);
  }
  if (proof.gap) {
    JsonLine gap;
    add_clear(gap, *proof.gap);
    line.add("gap", gap);
  }
  return line;
}

}  // namespace

std::string to_json_line(const CertificateRecord& record) {
  JsonLine line;
  line.add("type", "certificate").add("id", record.id).add("of", record.of);
  add(line, record.provenance);
  add(line, record.limits);
  if (!record.overridden.empty()) line.add("overridden", record.overridden);
  line.add("epoch", record.epoch).add("start", record.start);
  if (record.stands) line.add("parked", "pad");
  line.add("bounds", std::tuple(record.bounds.min, record.bounds.max));
  line.add("segments", record.proof.segments, object_of);
  return line.line();
}

std::string return_certificate_line(const ReportRecord& report, const geom::BoxMap& map) {
  const ReturnReport& returns = *report.returns;
  JsonLine line;
  const bool is_mission = !returns.way.empty();
  line.add("type", "returns").add("id", report.id);
  line.add("of", is_mission ? std::string_view("mission") : report.checked);
  add(line, report.provenance);
  if (report.by_time) {
    line.add("epoch", map.spec().epoch).add("start", report.time.start);
  }
  line.add("bounds", std::tuple(map.spec().bounds.min, map.spec().bounds.max));
  line.add("action", returns.action).add("home", returns.home);
  line.add("duration", returns.duration);
  if (is_mission) line.add("way", returns.way);
  line.add_json("autopilots", returns.reasons);
  return line.line();
}

}  // namespace traj
