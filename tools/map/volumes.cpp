#include "volumes.h"

#include <fmt/format.h>

#include "cli/file/files.h"
#include "cli/run.h"
#include "geom/text/counted.h"
#include "traj/mission/flown/fence_boxes.h"
#include "traj/mission/formats/fence_file.h"

namespace verbs {
namespace {

using geom::Vec2;
using geom::Vec3;

// A polygon of degrees is one of parts of a metre, if they are taken for metres.
void require_metres(const geom::KeepOut& zones, const geom::Frame& frame, const std::string& name,
                    const cli::MetresOption& metres) {
  for (const geom::Footprint& zone : zones.volumes) {
    std::vector<Vec3> corners;
    for (const Vec2& p : zone.polygon.outer) corners.emplace_back(p.x(), p.y(), 0);
    metres.check_outline(frame, corners, fmt::format("{}: feature {}", name, zone.id));
  }
}

// Such volumes reach from the bottom of the map to its top.
void warn_of_unread(const geom::KeepOut& zones, const std::string& name,
                    const cli::Common& common) {
  for (const auto& [key, count] : zones.unread) {
    common.warn(fmt::format(
        "{}: \"{}\" of {} is not read: without \"lower\" and \"upper\", metres in the map's z, a "
        "volume reaches from the bottom of the map to its top; without \"from\" and \"until\" it "
        "is always there",
        name, key, geom::counted(count, "volume")));
  }
}

}  // namespace

std::size_t patch_keep_out(const std::string& path, const geom::VolumeOptions& options,
                           const cli::MetresOption& metres, const cli::Common& common,
                           geom::MapPatch& patch) {
  cli::InputFile file(path);
  const geom::BoxMapSpec& spec = patch.spec();
  const geom::KeepOut zones = geom::read_volumes(file.read_all(), file.name(), spec, options);
  if (options.local) require_metres(zones, spec.frame, file.name(), metres);
  warn_of_unread(zones, file.name(), common);
  patch.note_cut_to_heights(zones.open_below, zones.open_above);
  return patch.add("keep_out", geom::keep_out_boxes(zones, file.name(), spec, options));
}

std::size_t patch_fence(const std::string& path, const geom::VolumeOptions& options,
                        geom::MapPatch& patch) {
  traj::require_place_for_fences(patch.spec());
  cli::InputFile file(path);
  patch.note_cut_to_bounds();
  return patch.add("fence", traj::fence_boxes(traj::read_fences(file.stream(), file.name()),
                                              file.name(), patch.spec(), options));
}

}  // namespace verbs
