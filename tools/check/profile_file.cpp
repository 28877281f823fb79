#include "profile_file.h"

#include <fmt/format.h>

#include "cli/option/output_option.h"
#include "cli/run.h"
#include "traj/check/profile_csv.h"

namespace checking {
namespace {

constexpr double kMostParts = 1e6;  // of one way: 40 MB of text

}  // namespace

void ProfileFile::add_to(CLI::App& app) {
  cli::add_output(app, "--profile", file_,
                  "write the least clearance of each part of the way, CSV");
  app.add_option("--profile-step", step_,
                 "length of those parts: seconds, or metres along a path (default 0.1)")
      ->check(CLI::Range(1e-4, 1e6));
}

void ProfileFile::open(const cli::Sharding& sharding) {
  if (file_.empty()) return;
  out_.emplace(file_, "profile", sharding);
  out_->head(std::string(traj::kProfileHead));
}

void ProfileFile::require_room(double extent) const {
  if (extent / step_ <= kMostParts) return;
  throw cli::UsageError(
      fmt::format("--profile-step: expected at most {:g} parts of a way, found {:.0f} of {} each; "
                  "--profile-step {:g} or more fits",
                  kMostParts, extent / step_, step_, extent / kMostParts));
}

std::string ProfileFile::rows(const std::string& id, const geom::CollisionScene& scene,
                              const traj::Trajectory& trajectory, double duration) const {
  if (!out_ || duration <= 0) return {};
  require_room(duration);
  return traj::profile_rows(id, traj::clearance_profile(scene, trajectory, step_));
}

std::string ProfileFile::rows(const std::string& id, const geom::CollisionScene& scene,
                              const geom::Polyline& path) const {
  if (!out_) return {};
  require_room(geom::length(path));
  return traj::profile_rows(id, traj::clearance_profile(scene, path, step_));
}

void ProfileFile::add(const std::string& rows) {
  if (out_) out_->add(rows);
}

void ProfileFile::commit(std::size_t total, cli::Exit exit) {
  if (out_) out_->commit(total, exit);
}

}  // namespace checking
