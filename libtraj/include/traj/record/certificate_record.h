#pragma once

// Certificates of trajectories and paths, as JSON Lines records that anyone can follow.
//
// Example:
//   const traj::ExactTask task{.map = map, .vehicle = vehicle, .margin = 0.2, .limits = limits};
//   traj::CertificateRecord record{.id = "q1", .of = "trajectory"};
//   record.proof = traj::check_exactly(task, trajectory);
//   assert(record.proof.ok);
//   record.bounds = map.spec().bounds;
//   record.provenance = geom::provenance_of(scene);
//   record.limits = limits;
//   std::cout << to_json_line(record);

#include <optional>
#include <string>
#include <vector>

#include "geom/record/record.h"
#include "traj/proof/exact/exact_check.h"
#include "traj/record/report_record.h"

namespace traj {

struct CertificateRecord {
  std::string id;
  std::string of;     // "trajectory" or "path"
  ExactResult proof;  // with ok
  geom::Aabb bounds;  // the map's
  geom::Provenance provenance;
  Limits limits;
  std::vector<std::string> overridden;  // as of the report
  // Where boxes that are there for a time were looked at by time: the map's epoch, and when the
  // flight begins after it.
  std::optional<std::string> epoch = {};
  std::optional<double> start = {};
  bool stands = false;  // before and after it, too
};

std::string to_json_line(const CertificateRecord& record);  // ends with a newline

// Why a vehicle comes home by itself from every instant of an accepted record, by the reasons of
// its report's `returns`; ends with a newline.
std::string return_certificate_line(const ReportRecord& report, const geom::BoxMap& map);

}  // namespace traj
