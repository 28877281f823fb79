// skyway-traj: minimum-snap trajectories along paths, each proved before it is written.

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <map>
#include <optional>

#include "answer.h"
#include "cli/batch.h"
#include "cli/file/files.h"
#include "cli/option/output_option.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "cli/shard/record_output.h"
#include "cli/tell.h"
#include "geom/base/in_order.h"
#include "geom/text/record_lines.h"
#include "options.h"
#include "tube.h"

namespace {

// What a shard takes of the paths: read one by one, while those before are solved.
class Share {
 public:
  Share(cli::InputFile& file, geom::Shard shard)
      : source_(file.name()), lines_(file.stream(), file.name()), shard_(shard) {}

  std::optional<geom::RecordLine> next() {
    while (auto line = lines_.next()) {
      if (!shard_.takes(total_++)) continue;
      ++taken_;
      return line;
    }
    return std::nullopt;
  }

  const std::string& source() const { return source_; }
  std::size_t total() const { return total_; }  // of all shards, once all is read
  std::size_t taken() const { return taken_; }  // so far, by this one

 private:
  std::string source_;
  geom::RecordLines lines_;
  geom::Shard shard_;
  std::size_t total_ = 0;
  std::atomic<std::size_t> taken_ = 0;
};

// How many paths a shard will take of a file; of a pipe, that is known at its end only: 0.
std::size_t count_of(const std::string& path, const geom::Shard& shard) {
  if (path == "-" || !std::filesystem::is_regular_file(path)) return 0;
  std::size_t total = 0;
  std::size_t taken = 0;
  cli::InputFile(path).for_each_line(
      [&](const std::string&, std::size_t) { taken += shard.takes(total++); });
  return taken;
}

struct Outputs {
  cli::RecordOutput trajectories;
  std::optional<cli::RecordOutput> corridors = {};
  std::optional<cli::RecordOutput> reports = {};

  void add(const solving::Answer& answer) {
    trajectories.add(answer.trajectory);
    trajectories.pass_on();
    if (corridors) corridors->add(answer.corridor);
    if (reports) reports->add(answer.report);
  }
  void commit(std::size_t total, cli::Exit exit) {
    trajectories.commit(total, exit);
    if (corridors) corridors->commit(total, exit);
    if (reports) reports->commit(total, exit);
  }
};

using Counts = std::map<std::string, std::size_t, std::less<>>;  // by rung or status

traj::SolvedRecord answer_to(const geom::PathRecord& path, const std::string& source,
                             std::size_t line, const solving::Options& options,
                             cli::Scenes& scenes) {
  if (path.status != geom::PathStatus::found) {
    const auto vehicle =
        scenes.profile() ? std::optional(scenes.profile()->vehicle) : path.provenance.vehicle;
    return {traj::without_path(path, options.limits_for(vehicle.value_or(geom::Vehicle{})))};
  }
  const auto scene = scenes.shared_scene_for(path.provenance, source, line);
  options.metres.check_input(scene->map().spec().frame, path.points, source, line);
  const solving::Task task = options.task(scene->vehicle());
  return traj::solve_record(*scene, path, task.options, task.yaw);
}

struct Tally {
  Counts counts;
  cli::Batch batch;
  std::size_t told = 0;  // searches for a tube
};

constexpr std::size_t kMostTold = 5;  // of these, on stderr

// How the search for a tube went, of the first few that took several rounds.
void tell_rounds(const cli::Common& common, const solving::Answer& answer, Tally& tally) {
  if (answer.rounds.find(';') == std::string::npos || tally.told++ >= kMostTold) return;
  cli::tell(common, "skyway-traj", answer.id + ": " + answer.rounds);
}

bool is_failure(std::string_view found) { return found == "no_path" || found == "infeasible"; }

void add(const cli::Common& common, const solving::Answer& answer, Tally& tally) {
  ++tally.counts[answer.found];
  tell_rounds(common, answer, tally);
  if (!is_failure(answer.found)) return tally.batch.add_good();
  tally.batch.add_failed(answer.found, answer.id + ": " + answer.why);
}

struct Item {
  geom::RecordLine line;
  solving::Answer answer = {};
};

constexpr std::size_t kHeld = 64;  // paths and answers

// `expected`: how many there are, 0 where that is not known.
Tally solve_each(const cli::Common& common, Share& share, std::size_t expected,
                 const solving::Options& options, cli::Scenes& scenes, Outputs& out) {
  const geom::Execution run = common.execution("trajectories");
  std::optional<solving::TubeSolver> tubes;
  if (options.proved_tube) tubes.emplace(options, scenes);
  const auto next = [&]() -> std::optional<Item> {
    auto line = share.next();
    return line ? std::optional(Item{*std::move(line)}) : std::nullopt;
  };
  const auto work = [&](Item& item) {
    const auto& [text, number] = item.line;
    const geom::PathRecord path = geom::parse_path_record(text, share.source(), number);
    const bool corridors = out.corridors.has_value();
    if (tubes) {
      options.metres.check_input(scenes.map().spec().frame, path.points, share.source(), number);
      item.answer =
          solving::answer_of(tubes->solve(path, share.source(), number), corridors, scenes.map());
    } else {
      item.answer =
          solving::answer_of(answer_to(path, share.source(), number, options, scenes), corridors);
    }
  };
  Tally tally;
  std::size_t done = 0;
  const auto tell = [&](std::size_t at_least) {
    if (run.progress) run.progress(done, std::max({expected, share.taken(), at_least}));
  };
  const auto take = [&](const Item& item) {
    add(common, item.answer, tally);
    ++done;
    if (expected != done) tell(done + 1);
    out.add(item.answer);
  };
  geom::in_order<Item>(run, kHeld, next, work, take);
  tell(done);
  return tally;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Solve minimum-snap trajectories along paths, and prove them.", "skyway-traj"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  solving::Options options;
  std::string map_file;
  std::string input = "-";
  std::string output = "-";
  cli::Sharding sharding;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  app.add_option("paths", input, "paths, JSON Lines (default: stdin)");
  cli::add_output(app, "-o,--output", output, "trajectories (default: stdout)");
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  options.add_to(app);
  sharding.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({map_file, input});
    options.require_sound(app);
    options.choose_solver();
    sharding.begin(app, {{"map", map_file}, {"paths", input}},
                   {{"output", output},
                    {"corridor-file", options.corridor_file},
                    {"report-file", options.report_file}});
    if (const auto done = sharding.finished(common)) return *done;
    cli::Scenes scenes(cli::open_map(map_file, geom::Verified::extents, common.execution("verify")),
                       vehicle, geom::Differences::refused);
    if (scenes.profile()) options.task(scenes.profile()->vehicle);  // refuses before it reads
    cli::InputFile file(input);
    Share share(file, sharding.shard());
    Outputs out{{output, "output", sharding}};
    if (options.proved_tube) out.reports.emplace(options.report_file, "report-file", sharding);
    if (!options.corridor_file.empty()) {
      out.corridors.emplace(options.corridor_file, "corridor-file", sharding);
    }
    const bool counted = common.execution("trajectories").progress != nullptr;
    const Tally tally = solve_each(common, share, counted ? count_of(input, sharding.shard()) : 0,
                                   options, scenes, out);
    const Counts& counts = tally.counts;
    const bool no = std::any_of(counts.begin(), counts.end(),
                                [](const auto& count) { return is_failure(count.first); });
    const cli::Exit exit = no ? cli::Exit::no : cli::Exit::yes;
    out.commit(share.total(), exit);
    tally.batch.tell(common, "skyway-traj", "paths have no trajectory");
    common.write_stats({{"records", counts}});
    return exit;
  });
}
