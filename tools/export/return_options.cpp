#include "return_options.h"

#include "cli/file/files.h"
#include "cli/option/numbers_option.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/run.h"
#include "traj/home/rally_file.h"
#include "traj/mission/formats/fence_file.h"

namespace exporting {
namespace {

constexpr const char* kAutoFence = "auto";

}  // namespace

void ReturnOptions::add_to(CLI::App& app) {
  app.add_option("--return-height", height_,
                 "metres above home at which a mission's return is flown (default: as --params or "
                 "the firmware says); from which times it is proved is told")
      ->check(CLI::Range(0.0, 1e4));
  app.add_option("--rally", rally_,
                 "a place in the air to which the vehicle may return, x,y,z along the map's axes, "
                 "any number of times; or GeoJSON with such points")
      ->type_name("PLACE|FILE");
  app.add_option(
         "--fence", fence_,
         "fences of a mission: those of a plan or WPL file; or auto: polygons that hold the "
         "mission and each proved return, and keep out of all obstacles as high as returns")
      ->type_name("FILE");
  app.add_option("--fence-budget", budget_,
                 "corners of all fences that the autopilot stores (default: 64 of PX4, 63 before "
                 "1.15, 70 of ArduPilot)")
      ->check(CLI::Range(std::size_t{3}, std::size_t{1000}));
  cli::add_output(app, "--fence-out", fences_out, "WPL: the file for the fences");
  cli::add_output(app, "--rally-out", rally_out, "WPL: the file for the rally points");
  cli::add_output(app, "--params-out", params_out,
                  "also write the parameters of one autopilot with which it returns as proved");
  cli::add_output(app, "--procedure", procedure,
                  "also write in words what happens if the link is lost");
  app.add_option_function<std::vector<std::string>>(
         "--return", [this](const std::vector<std::string>&) { returns_ = true; },
         "volume4d: off-nominal volumes, too, which hold every return (rtl)")
      ->expected(0, 1)
      ->default_str("rtl")
      ->check(CLI::IsMember({"rtl"}))
      ->type_name("ACTION");
}

void ReturnOptions::require_sound(const CLI::App& app, const std::string& word,
                                  bool unchecked) const {
  cli::only_for(app, !unchecked,
                {"--return-height", "--rally", "--fence", "--params-out", "--procedure"},
                "an export that is checked");
  cli::only_for(app, !fence_.empty(), {"--fence-budget", "--fence-out"}, "--fence");
  cli::only_for(app, !rally_.empty(), {"--rally-out"}, "--rally");
  if (word == traj::kVolume4d.format.word) {
    cli::only_for(app, returns_,
                  {"--return-height", "--autopilot", "--params", "--drag", "--navigation"},
                  "volumes of airspace with --return");
  }
  if (word != traj::kWpl.format.word) return;
  if (!fence_.empty() && fences_out.empty()) {
    throw cli::UsageError(
        "ground stations load fences of WPL missions from a file of their own: give --fence-out");
  }
  if (!rally_.empty() && rally_out.empty()) {
    throw cli::UsageError(
        "ground stations load the rally points of WPL missions from a file of their own: name it "
        "with --rally-out");
  }
}

std::vector<geom::Vec3> ReturnOptions::rally_points(const geom::Frame& frame) const {
  std::vector<geom::Vec3> out;
  for (const std::string& text : rally_) {
    if (const auto numbers = cli::parse_numbers(text, 3)) {
      out.emplace_back((*numbers)[0], (*numbers)[1], (*numbers)[2]);
      continue;
    }
    cli::InputFile file(text);
    const auto read = traj::read_rally(file.stream(), file.name(), frame);
    out.insert(out.end(), read.begin(), read.end());
  }
  return out;
}

traj::ReturnWishes ReturnOptions::wishes(const geom::Frame& frame, std::size_t volumes) const {
  traj::ReturnWishes out;
  out.height = height_;
  out.rally = rally_points(frame);
  out.compiles_fences = fence_ == kAutoFence;
  if (!fence_.empty() && !out.compiles_fences) {
    cli::InputFile file(fence_);
    out.fences = traj::read_fences(file.stream(), file.name());
  }
  out.budget = budget_;
  out.params = !params_out.empty();
  out.procedure = !procedure.empty();
  out.off_nominal = returns_ ? volumes : 0;
  return out;
}

}  // namespace exporting
