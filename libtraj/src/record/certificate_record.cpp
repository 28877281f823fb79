#include "traj/record/certificate_record.h"

#include <fmt/format.h>

#include "traj/record/trajectory_record.h"

namespace traj {
namespace {

void append_cover(std::string& out, const char* key, const Cover& cover) {
  if (cover.empty()) return;
  out += fmt::format("\"{}\":[{}],", key, fmt::join(cover, ","));
}

void append_clear(std::string& out, const ClearCover& cover) {
  append_cover(out, "clear", cover.pieces);
  if (cover.planes.empty()) return;
  out += "\"planes\":[";
  for (const PieceAndPlane& p : cover.planes) {
    out += fmt::format("[{},{},\"{}{}\"],", p.piece, p.box, p.towards ? '+' : '-', "xyz"[p.axis]);
  }
  out.back() = ']';
  out += ',';
}

void append_segment(std::string& out, const SegmentProof& proof) {
  out += '{';
  append_clear(out, proof.clear);
  append_cover(out, "bounds", proof.bounds);
  for (const Limit limit : kOrderOfLimits) {
    append_cover(out, kind_of(limit).quantity, proof.limits[limit]);
  }
  if (proof.gap) {
    out += "\"gap\":{";
    append_clear(out, *proof.gap);
    out.back() = '}';
    out += ',';
  }
  out.back() = '}';
}

}  // namespace

void append_overridden(std::string& out, const std::vector<std::string>& names) {
  if (!names.empty()) out += fmt::format("\"overridden\":[\"{}\"],", fmt::join(names, "\",\""));
}

std::string to_json_line(const CertificateRecord& record) {
  std::string line = "{\"type\":\"certificate\",\"id\":";
  geom::append_json(line, std::string_view(record.id));
  line += ",\"of\":";
  geom::append_json(line, std::string_view(record.of));
  line += ',';
  geom::append_json(line, record.provenance);
  geom::append_json(line, record.limits);
  append_overridden(line, record.overridden);
  line += "\"bounds\":[";
  geom::append_json(line, record.bounds.min);
  line += ',';
  geom::append_json(line, record.bounds.max);
  line += "],\"segments\":[";
  for (const SegmentProof& proof : record.proof.segments) {
    append_segment(line, proof);
    line += ',';
  }
  line.back() = ']';
  line += "}\n";
  return line;
}

}  // namespace traj
