// skyway-check: prove that trajectories and paths are clear of a map and inside their limits.

#include <fmt/format.h>

#include "cli/drone_file.h"
#include "cli/files.h"
#include "cli/limit_options.h"
#include "cli/record_output.h"
#include "cli/run.h"
#include "cli/vehicle_option.h"
#include "geom/io/csv_field.h"
#include "traj/check.h"
#include "traj/clearance.h"
#include "traj/exact_check.h"
#include "traj/flown.h"
#include "traj/io/certificate_record.h"
#include "traj/io/report_record.h"
#include "traj/io/trajectory_record.h"

namespace {

// --profile: CSV.
struct ProfileFile {
  std::string file;
  double step = 0.1;
  std::optional<cli::RecordOutput> out = std::nullopt;
  std::string lines = {};  // of the record at hand

  void open(const cli::Sharding& sharding) {
    if (file.empty()) return;
    out.emplace(file, "profile", sharding);
    out->head("id,begin,end,clearance_m\n");
  }
  void add(const std::string& id, const std::vector<traj::ClearanceSpan>& spans) {
    for (const traj::ClearanceSpan& span : spans) {
      lines += geom::csv_field(id);
      for (const double value : {span.begin, span.end, span.clearance}) {
        lines += ',';
        geom::append_json(lines, value);
      }
      lines += '\n';
    }
  }
  void finish_record() {
    if (out) out->add(lines);
    lines.clear();
  }
};

struct Checker {
  cli::Scenes& scenes;
  ProfileFile& profile;
  traj::Limits asked;  // by the options
  bool override_record;
  bool exact;

  // The record's limits, or stricter ones that were asked for.
  traj::Limits limits_for(const traj::Limits& record) const {
    const auto pick = [&](std::optional<double> option, std::optional<double> own) {
      if (!option || !own || override_record) return option ? option : own;
      return std::optional(std::min(*option, *own));
    };
    return traj::combined(asked, record, pick);
  }

  // The scene says only what vehicle it is for; the exact check looks at the map itself.
  static traj::ExactTask task(const geom::CollisionScene& scene, const traj::Limits& limits) {
    return {scene.map(), scene.vehicle(), scene.margin(), limits};
  }

  traj::ReportRecord trajectory(const std::string& text, const std::string& source,
                                std::size_t line) const {
    const auto record = traj::parse_trajectory_record(text, source, line);
    traj::ReportRecord report{record.id, "trajectory", {}, record.provenance, {}};
    if (record.status != "solved") {
      report.result.reason = record.status;
      return report;
    }
    const auto& scene = scenes.scene_for(record.provenance, source, line);
    report.limits = limits_for(record.limits);
    report.provenance = geom::provenance_of(scene);
    report.result = traj::check(scene, record.trajectory, report.limits);
    if (exact) report.exact = traj::check_exactly(task(scene, report.limits), record.trajectory);
    if (profile.out && report.result.reason != "duration") {
      profile.add(record.id, traj::clearance_profile(scene, record.trajectory, profile.step));
    }
    return report;
  }

  traj::ReportRecord path(const std::string& text, const std::string& source,
                          std::size_t line) const {
    const auto record = geom::parse_path_record(text, source, line);
    traj::ReportRecord report{record.id, "path", {}, record.provenance, {}};
    if (record.status != "found") {
      report.result.reason = "no_path";
      return report;
    }
    const auto& scene = scenes.scene_for(record.provenance, source, line);
    report.provenance = geom::provenance_of(scene);
    report.result = traj::check_path(scene, record.points);
    if (exact) report.exact = traj::check_exactly(task(scene, {}), record.points);
    if (profile.out)
      profile.add(record.id, traj::clearance_profile(scene, record.points, profile.step));
    return report;
  }

  // What a drone makes of a file.
  traj::ReportRecord flown(const cli::DroneFile& file) const {
    const auto& scene = scenes.scene();
    const bool path = !file.flown.path.empty();
    if (exact && !path) {
      throw cli::UsageError("--exact takes paths and records, not files of trajectories");
    }
    traj::ReportRecord report{file.id, path ? "path" : "trajectory", {}, {}, {}};
    report.limits = limits_for(scenes.profile()->limits);  // a scene without a record has a profile
    report.provenance = geom::provenance_of(scene);
    report.result = traj::check_flown(scene, file.flown, report.limits);
    const auto way = path ? traj::whole_way(scene, file.flown) : std::nullopt;
    if (way && exact) report.exact = traj::check_exactly(task(scene, {}), *way);
    if (!profile.out) return report;
    if (way) profile.add(file.id, traj::clearance_profile(scene, *way, profile.step));
    if (!path)
      profile.add(file.id, traj::clearance_profile(scene, file.flown.trajectory, profile.step));
    return report;
  }

  traj::ReportRecord check(const std::string& text, const std::string& source,
                           std::size_t line) const {
    const geom::JsonFields fields(text, source, line);
    return fields.text("type") == "path" ? path(text, source, line)
                                         : trajectory(text, source, line);
  }

  // What the shard takes of the file, in order. Returns how much is in the file.
  std::size_t each(cli::InputFile& file, const cli::DroneFileOptions& drone_file,
                   const geom::Shard& shard,
                   const std::function<void(const traj::ReportRecord&)>& answer) const {
    std::size_t total = 0;
    if (drone_file.format.empty()) {
      file.for_each_line([&](const std::string& line, std::size_t number) {
        if (shard.takes(total++)) answer(check(line, file.name(), number));
      });
      return total;
    }
    const geom::Frame& frame = scenes.map().spec().frame;
    const std::string text = file.read_all();
    for (const auto& one : cli::read_drone_file(text, file.name(), drone_file, frame)) {
      if (shard.takes(total++)) answer(flown(one));
    }
    return total;
  }
};

traj::CertificateRecord certificate_of(const traj::ReportRecord& report, const geom::BoxMap& map) {
  return {report.id,         report.checked,    *report.exact,
          map.spec().bounds, report.provenance, report.limits};
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Prove trajectories and paths free of collision and inside their limits.",
               "skyway-check"};
  cli::Common common(app);
  cli::VehicleOptions vehicle;
  cli::LimitOptions limits;
  std::string map_file;
  std::string input = "-";
  std::string output = "-";
  std::string certificate;
  ProfileFile profile;
  bool override_record = false;
  bool exact = false;
  cli::DroneFileOptions drone_file;
  cli::Sharding sharding;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  app.add_option("file", input, "trajectories or paths, JSON Lines (default: stdin)");
  app.add_option("-o,--output", output, "reports (default: stdout)");
  vehicle.add_to(app);
  limits.add_to(app);
  app.add_flag("--override", override_record,
               "let the options be looser than what the records carry");
  app.add_flag("--exact", exact, "check once more in exact numbers; both must accept");
  app.add_option("--profile", profile.file,
                 "write the least clearance of each part of the way, CSV");
  app.add_option("--profile-step", profile.step,
                 "length of those parts: seconds, or metres along a path (default 0.1)")
      ->check(CLI::Range(1e-4, 1e6));
  app.add_option("--certificate", certificate,
                 "write why each accepted record is clear, JSON Lines; implies --exact");
  drone_file.add_to(app);
  sharding.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({map_file, input});
    if ((certificate == "-") + (output == "-") + (profile.file == "-") > 1) {
      throw cli::UsageError("reports, certificates and profiles cannot share stdout");
    }
    sharding.begin(app, {{"map", map_file}, {"file", input}},
                   {{"output", output}, {"certificate", certificate}, {"profile", profile.file}});
    if (const auto done = sharding.finished(common)) return *done;
    using Differences = cli::Scenes::Differences;
    cli::Scenes scenes(cli::open_map(map_file), vehicle,
                       override_record ? Differences::allowed : Differences::stricter_allowed);
    const Checker checker{scenes, profile, limits.limits(), override_record,
                          exact || !certificate.empty()};
    cli::InputFile file(input);
    cli::RecordOutput out(output, "output", sharding);
    std::optional<cli::RecordOutput> reasons;
    if (!certificate.empty()) reasons.emplace(certificate, "certificate", sharding);
    profile.open(sharding);
    std::size_t failed = 0;
    std::size_t count = 0;
    const auto answer = [&](const traj::ReportRecord& report) {
      const bool ok = traj::accepted(report);
      failed += !ok;
      ++count;
      if (reasons)
        reasons->add(ok ? to_json_line(certificate_of(report, scenes.map())) : std::string());
      profile.finish_record();
      out.add(traj::to_json_line(report, scenes.map()));
      out.flush();
    };
    const std::size_t total = checker.each(file, drone_file, sharding.shard(), answer);
    const cli::Exit exit = failed ? cli::Exit::no : cli::Exit::yes;
    out.commit(total, exit);
    if (reasons) reasons->commit(total, exit);
    if (profile.out) profile.out->commit(total, exit);
    common.write_stats({{"records", count}, {"failed", failed}});
    return exit;
  });
}
