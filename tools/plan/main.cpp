// skyway-plan: collision-free paths through a box map, one per query.

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "cli/batch.h"
#include "cli/content/artefacts.h"
#include "cli/file/files.h"
#include "cli/option/ground_option.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/quality_option.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "cli/shard/record_output.h"
#include "cli/tell.h"
#include "geom/base/mapped_file.h"
#include "geom/base/parallel.h"
#include "geom/map/wider_bounds.h"
#include "geom/record/query_record.h"
#include "geom/text/counted.h"
#include "home.h"
#include "plan/planner/moved_ends.h"
#include "plan/planner/path_record.h"
#include "plan/planner/proof_line.h"
#include "plan/sampling/search_tree_file.h"
#include "queries_option.h"
#include "search_options.h"
#include "snapped_ends.h"

namespace {

// What a query came to.
struct Answer {
  geom::PathRecord record;
  std::vector<std::string> moved;  // ends, in words
  std::string why;                 // a line of certificates, or nothing
  plan::SearchTree tree;           // where it is to be written
  bool open = false;               // its bound is further away than was asked for
  std::vector<geom::Aabb> ends;    // the vehicle at both, where one of them is outside
};

// What all came to.
struct Planned {
  bool of_one = false;  // then main() says why there is no path
  std::size_t records = 0;
  std::size_t found = 0;
  cli::Batch batch;
  std::size_t timed = 0;  // boxes that are there for a time only
  std::size_t open = 0;
  planning::SnappedEnds snapped;
  std::optional<geom::WiderBounds> wider;  // that would hold all ends
  Answer last;

  void add(Answer answer) {
    const bool is_found = answer.record.status == geom::PathStatus::found;
    ++records;
    found += is_found;
    open += answer.open;
    if (is_found) {
      batch.add_good();
    } else {
      batch.add_failed(name(answer.record.status),
                       of_one ? "" : answer.record.id + ": " + answer.record.message);
    }
    snapped.add(answer.moved);
    for (const geom::Aabb& end : answer.ends) wider->add(end);
    last = std::move(answer);
  }
};

// Paths and, where asked for, why there is none.
class Outputs {
 public:
  Outputs(const std::string& paths, const std::string& certificates, const cli::Sharding& sharding)
      : paths_(paths, "output", sharding) {
    if (!certificates.empty()) certificates_.emplace(certificates, "certificate", sharding);
  }

  void add(const Answer& answer) {
    paths_.add(geom::to_json_line(answer.record));
    if (certificates_) certificates_->add(answer.why);
  }
  void pass_on() { paths_.pass_on(); }
  void commit(std::size_t total, cli::Exit exit) {
    paths_.commit(total, exit);
    if (certificates_) certificates_->commit(total, exit);
  }

 private:
  cli::RecordOutput paths_;
  std::optional<cli::RecordOutput> certificates_;
};

bool is_outside(geom::PathStatus status) {
  return status == geom::PathStatus::start_outside || status == geom::PathStatus::goal_outside;
}

// Answers queries, by layers where these were named.
class Answers {
 public:
  Answers(plan::Planner& planner, const geom::CollisionScene& scene,
          const planning::SearchOptions& search)
      : planner_(planner), scene_(scene), search_(search) {
    if (search.layers) layered_.emplace(scene, planner, *search.layers);
  }

  Answer to(const geom::PlanQuery& query) {
    plan::PlanResult result = plan(query);
    Answer answer{plan::path_record(scene_, query.id, result),
                  plan::moved_ends(scene_, query, result),
                  "",
                  std::move(result.tree),
                  result.bound && !result.bound->closed,
                  {}};
    answer.record.time = query.time;
    if (is_outside(answer.record.status)) answer.ends = ends_of(query);
    answer.why = plan::proof_line(scene_, query, std::move(result));
    return answer;
  }

  const geom::Aabb& bounds() const { return scene_.map().spec().bounds; }

 private:
  std::vector<geom::Aabb> ends_of(const geom::PlanQuery& query) const {
    std::vector<geom::Aabb> out;
    for (const geom::Vec3& end : {query.from, query.to}) {
      if (end.allFinite()) out.push_back({end - scene_.half(), end + scene_.half()});
    }
    return out;
  }

  plan::PlanResult plan(const geom::PlanQuery& query) {
    return layered_ ? layered_->plan(query.from, query.to, search_.started())
                    : planner_.plan(query.from, query.to, search_.started());
  }

  plan::Planner& planner_;
  const geom::CollisionScene& scene_;
  const planning::SearchOptions& search_;
  std::optional<plan::LayerPlanner> layered_;
};

// Paths are written block by block, for the next tool of a pipe.
Planned plan_each(Answers answers, const std::vector<geom::PlanQuery>& queries,
                  const geom::Shard& shard, const geom::Execution& run, Outputs& out) {
  constexpr std::size_t kBlock = 1024;
  const std::vector<std::size_t> chosen = shard.items(queries.size());
  Planned planned{.of_one = queries.size() == 1,
                  .wider = std::optional<geom::WiderBounds>(answers.bounds())};
  for (std::size_t begin = 0; begin < chosen.size(); begin += kBlock) {
    std::vector<Answer> block(std::min(kBlock, chosen.size() - begin));
    const auto progress = [&](std::size_t done, std::size_t) {
      if (run.progress) run.progress(begin + done, chosen.size());
    };
    geom::parallel_for(block.size(), {run.threads, progress}, [&](std::size_t i) {
      block[i] = answers.to(queries[chosen[begin + i]]);
      geom::trim_mapped_files();
    });
    for (Answer& answer : block) {
      out.add(answer);
      planned.add(std::move(answer));
    }
    out.pass_on();
  }
  return planned;
}

void write_tree(const std::string& path, const plan::SearchTree& tree,
                const geom::PathRecord& record) {
  cli::OutputFile out(path, cli::OutputKind::text);
  plan::write_jsonl(out.stream(), tree, record.id, record.provenance);
  out.commit();
}

// What came of it, on stderr.
void tell(const cli::Common& common, const Planned& planned, double gap, bool of_one) {
  planned.snapped.say(common);
  if (planned.open > 0) {
    cli::tell(common, "skyway-plan",
              fmt::format("no proof within {} for {} of {}: there may be shorter ones", gap,
                          planned.open, geom::counted(planned.found, "path")));
  }
  if (planned.timed > 0) {
    cli::tell(common, "skyway-plan",
              fmt::format("{} there for a time only, and counted as always there: no path passes "
                          "them, and bounds and unreachable are of the map with them",
                          geom::counted(planned.timed, "box is", "boxes are")));
  }
  planned.batch.tell(common, "skyway-plan", "queries have no path");
  if (!of_one && planned.wider->any()) {
    cli::tell(common, "skyway-plan",
              fmt::format("ends lie outside the bounds, at most {}: {}", planned.wider->in_words(),
                          planned.wider->advice()));
  }
  if (of_one && !planned.found) cli::complain("skyway-plan", planned.last.record.message);
}

struct Options {
  cli::VehicleOptions vehicle;
  cli::ArtefactFiles prepared;
  planning::SearchOptions search;
  planning::QueriesOption asked;
  planning::HomeOption home;
  cli::AglOption agl;
  std::string map_file;
  std::string output = "-";

  void add_to(CLI::App& app) {
    app.add_option("map", map_file, "box map; - for stdin")->required();
    prepared.add_to(app);
    cli::add_quality(app, search.plan.quality);
    asked.add_to(app);
    cli::add_output(app, "-o,--output", output, "paths (default: stdout)");
    search.add_to(app);
    vehicle.add_to(app);
    vehicle.add_memory_to(app);
    home.add_to(app);
    agl.add_to(app);
  }

  void begin(cli::Sharding& sharding, CLI::App& app) const {
    cli::at_most_one_stdin(
        {map_file, prepared.lattice, prepared.roadmap, asked.file(), home.sites(), home.flights()});
    sharding.begin(app,
                   {{"map", map_file},
                    {"lattice", prepared.lattice},
                    {"roadmap", prepared.roadmap},
                    {"queries", asked.file()},
                    {"home", home.sites()},
                    {"flights", home.flights()}},
                   {{"output", output}, {"certificate", search.certificate}});
  }
};

cli::Exit plan_home(Options& options, const CLI::App& app, const cli::Common& common,
                    const cli::Sharding& sharding) {
  const bool chosen = app.count("--quality") > 0;
  return options.home.plan({common, options.map_file, options.vehicle, options.asked.metres(),
                            chosen ? std::optional(options.search.plan.quality) : std::nullopt,
                            options.output, sharding});
}

cli::Exit plan_paths(Options& options, const cli::Common& common, const cli::Sharding& sharding) {
  planning::SearchOptions& search = options.search;
  // A certificate stands for the map.
  const auto trust =
      search.certificate.empty() ? geom::Verified::extents : geom::Verified::contents;
  const geom::BoxMap map = cli::open_map(options.map_file, trust, common.execution("verify"));
  cli::Scenes scenes(options.agl.applied(map, options.map_file), options.vehicle,
                     cli::Scenes::Differences::refused);
  const geom::CollisionScene& scene = scenes.scene();
  const cli::Artefacts given(options.prepared);
  given.require_made_for(scene);
  const auto named = given.lattice() ? std::nullopt : search.named_lattice(scene);
  const std::vector<geom::PlanQuery> queries = options.asked.read(scene);
  search.check(queries.size());
  plan::Planner planner(scene, named ? &*named : given.lattice(), given.roadmap());
  Outputs out(options.output, search.certificate, sharding);
  Planned planned = plan_each(Answers(planner, scene, search), queries, sharding.shard(),
                              common.execution("paths"), out);
  planned.timed = scene.map().timed().size();
  const cli::Exit exit = planned.found == planned.records ? cli::Exit::yes : cli::Exit::no;
  out.commit(queries.size(), exit);
  if (!search.tree_file.empty()) {
    write_tree(search.tree_file, planned.last.tree, planned.last.record);
  }
  common.write_stats(
      {{"queries", planned.records}, {"found", planned.found}, {"collision", scenes.stats()}});
  tell(common, planned, search.plan.gap, queries.size() == 1);
  return exit;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Plan collision-free paths through a box map.", "skyway-plan"};
  cli::Common common(app, true);
  Options options;
  cli::Sharding sharding;
  options.add_to(app);
  sharding.add_to(app)->excludes("--tree");
  return cli::run_tool(app, argc, argv, [&] {
    options.home.refuse_idle(app);
    if (!options.home.asked()) options.asked.require_some(sharding.asked());
    options.search.refuse_idle(app, options.prepared);
    options.agl.refuse_idle(app);
    cli::only_for(app, !options.home.asked(), {"--agl"}, "paths, not ways home");
    options.begin(sharding, app);
    if (const auto done = sharding.finished(common)) return *done;
    if (options.home.asked()) return plan_home(options, app, common, sharding);
    return plan_paths(options, common, sharding);
  });
}
