// skyway-plan: collision-free paths through a box map, one per query.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "cli/batch.h"
#include "cli/content/artefacts.h"
#include "cli/file/files.h"
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
#include "plan/bound/bound_record.h"
#include "plan/planner/path_record.h"
#include "plan/reach/enclosure_record.h"
#include "plan/sampling/search_tree_file.h"
#include "queries_option.h"
#include "search_options.h"
#include "snapped_ends.h"

namespace {

struct Planned {
  std::size_t records = 0;
  std::size_t found = 0;
  cli::Batch batch;
  std::size_t timed = 0;  // boxes that are there for a time only
  std::size_t open = 0;   // paths whose bound is further away than was asked for
  planning::SnappedEnds snapped;
  std::optional<geom::WiderBounds> wider;  // that would hold all ends
  geom::PathRecord last;
  plan::SearchTree tree;  // of the last query, where it is to be written
};

// Paths and, where asked for, why there is none.
class Outputs {
 public:
  Outputs(const std::string& paths, const std::string& certificates, const cli::Sharding& sharding)
      : paths_(paths, "output", sharding) {
    if (!certificates.empty()) certificates_.emplace(certificates, "certificate", sharding);
  }

  // `why`: a line, or nothing.
  void add(const geom::PathRecord& record, const std::string& why) {
    paths_.add(geom::to_json_line(record));
    if (certificates_) certificates_->add(why);
  }
  void flush() { paths_.flush(); }
  void commit(std::size_t total, cli::Exit exit) {
    paths_.commit(total, exit);
    if (certificates_) certificates_->commit(total, exit);
  }

 private:
  cli::RecordOutput paths_;
  std::optional<cli::RecordOutput> certificates_;
};

std::string certificate(const geom::CollisionScene& scene, const geom::PlanQuery& query,
                        plan::PlanResult& result) {
  const geom::Vec3 from = result.snapped_start.value_or(query.from);
  const geom::Vec3 to = result.snapped_goal.value_or(query.to);
  const geom::Aabb& bounds = scene.map().spec().bounds;
  if (result.enclosure) {
    return plan::to_json_line(plan::EnclosureRecord{
        query.id, from, to, std::move(*result.enclosure), bounds, geom::provenance_of(scene)});
  }
  if (!result.bound || !result.bound->proof) return "";
  return plan::to_json_line(plan::BoundRecord{query.id, from, to, result.bound->bound,
                                              std::move(*result.bound->proof), bounds,
                                              geom::provenance_of(scene)});
}

// Answers queries, by layers where these were named.
class Answers {
 public:
  Answers(plan::Planner& planner, const geom::CollisionScene& scene,
          const planning::SearchOptions& search)
      : planner_(planner), search_(search) {
    if (search.layers) layered_.emplace(scene, planner, *search.layers);
  }

  plan::PlanResult to(const geom::PlanQuery& query) {
    return layered_ ? layered_->plan(query.from, query.to, search_.started())
                    : planner_.plan(query.from, query.to, search_.started());
  }

 private:
  plan::Planner& planner_;
  const planning::SearchOptions& search_;
  std::optional<plan::LayerPlanner> layered_;
};

bool is_outside(geom::PathStatus status) {
  return status == geom::PathStatus::start_outside || status == geom::PathStatus::goal_outside;
}

// Paths are written block by block, for the next tool of a pipe.
Planned plan_each(plan::Planner& planner, const geom::CollisionScene& scene,
                  const std::vector<geom::PlanQuery>& queries, const geom::Shard& shard,
                  const planning::SearchOptions& search, const geom::Execution& run, Outputs& out) {
  constexpr std::size_t kBlock = 1024;
  const std::vector<std::size_t> chosen = shard.items(queries.size());
  Planned planned;
  planned.wider.emplace(scene.map().spec().bounds);
  Answers answers(planner, scene, search);
  for (std::size_t begin = 0; begin < chosen.size(); begin += kBlock) {
    std::vector<geom::PathRecord> records(std::min(kBlock, chosen.size() - begin));
    std::vector<std::vector<std::string>> moved(records.size());
    std::vector<std::string> why(records.size());
    std::vector<char> open(records.size());
    const auto progress = [&](std::size_t done, std::size_t) {
      if (run.progress) run.progress(begin + done, chosen.size());
    };
    geom::parallel_for(records.size(), {run.threads, progress}, [&](std::size_t i) {
      const geom::PlanQuery& query = queries[chosen[begin + i]];
      plan::PlanResult result = answers.to(query);
      records[i] = plan::path_record(scene, query.id, result);
      records[i].time = query.time;
      moved[i] = planning::moved_ends(scene, query, result);
      why[i] = certificate(scene, query, result);
      open[i] = result.bound && !result.bound->closed;
      if (!search.tree_file.empty()) planned.tree = std::move(result.tree);
      geom::trim_mapped_files();
    });
    for (std::size_t i = 0; i < records.size(); ++i) {
      const geom::PathRecord& record = records[i];
      const bool found = record.status == geom::PathStatus::found;
      planned.found += found;
      planned.open += static_cast<std::size_t>(open[i]);
      found ? planned.batch.add_good() : planned.batch.add_failed(name(record.status));
      if (is_outside(record.status)) {
        const geom::PlanQuery& query = queries[chosen[begin + i]];
        for (const geom::Vec3& end : {query.from, query.to}) {
          if (end.allFinite()) planned.wider->add({end - scene.half(), end + scene.half()});
        }
      }
      out.add(record, why[i]);
    }
    out.flush();
    for (const auto& ends : moved) planned.snapped.add(ends);
    planned.records += records.size();
    planned.last = std::move(records.back());
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
  if (of_one && !planned.found) cli::complain("skyway-plan", planned.last.message);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Plan collision-free paths through a box map.", "skyway-plan"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  cli::ArtefactFiles prepared;
  planning::SearchOptions search;
  planning::QueriesOption asked;
  std::string map_file;
  std::string output = "-";
  cli::Sharding sharding;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  prepared.add_to(app);
  cli::add_quality(app, search.plan.quality);
  CLI::Option* queries_option = asked.add_to(app);
  cli::add_output(app, "-o,--output", output, "paths (default: stdout)");
  search.add_to(app);
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  sharding.add_to(app)->needs(queries_option)->excludes("--tree");
  return cli::run_tool(app, argc, argv, [&] {
    asked.require_some();
    search.refuse_idle(app, prepared);
    cli::at_most_one_stdin({map_file, prepared.lattice, prepared.roadmap, asked.file()});
    sharding.begin(app,
                   {{"map", map_file},
                    {"lattice", prepared.lattice},
                    {"roadmap", prepared.roadmap},
                    {"queries", asked.file()}},
                   {{"output", output}, {"certificate", search.certificate}});
    if (const auto done = sharding.finished(common)) return *done;
    // A certificate stands for the map.
    const auto trust =
        search.certificate.empty() ? geom::Verified::extents : geom::Verified::contents;
    cli::Scenes scenes(cli::open_map(map_file, trust, common.execution("verify")), vehicle,
                       cli::Scenes::Differences::refused);
    const geom::CollisionScene& scene = scenes.scene();
    const cli::Artefacts given(prepared);
    given.require_made_for(scene);
    const auto named = given.lattice() ? std::nullopt : search.named_lattice(scene);
    const std::vector<geom::PlanQuery> queries = asked.read(scene.map());
    search.check(queries.size());
    plan::Planner planner(scene, named ? &*named : given.lattice(), given.roadmap());
    Outputs out(output, search.certificate, sharding);
    Planned planned = plan_each(planner, scene, queries, sharding.shard(), search,
                                common.execution("paths"), out);
    planned.timed = scene.map().timed().size();
    const cli::Exit exit = planned.found == planned.records ? cli::Exit::yes : cli::Exit::no;
    out.commit(queries.size(), exit);
    if (!search.tree_file.empty()) {
      write_tree(search.tree_file, planned.tree, planned.last);
    }
    common.write_stats(
        {{"queries", planned.records}, {"found", planned.found}, {"collision", scenes.stats()}});
    tell(common, planned, search.plan.gap, queries.size() == 1);
    return exit;
  });
}
