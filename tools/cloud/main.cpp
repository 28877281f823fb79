// skyway-cloud: point clouds become box maps.

#include <filesystem>

#include "cli/file/files.h"
#include "cli/option/map_output.h"
#include "cli/option/output_option.h"
#include "cli/run.h"
#include "cli/shard/sharding.h"
#include "cli/tell.h"
#include "geom/base/error.h"
#include "geom/map/map_part.h"
#include "options.h"

namespace {

using cloud::Options;

void refuse_what_needs_more(const std::string& input, const Options& options,
                            const cli::Sharding& sharding) {
  const geom::CloudDraftOptions& draft = options.draft;
  if (input == "-" && draft.drop_ground && draft.ground_by != "class" && !draft.in_memory()) {
    throw cli::UsageError("--ground-points drop reads the file twice: it cannot be stdin");
  }
  if (sharding.asked() && draft.in_memory()) {
    throw cli::UsageError(
        "--outliers, --voxel and --mode objects look at all points together: no --shard");
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Convert a point cloud to a box map.", "skyway-cloud"};
  cli::Common common(app, true);
  Options options;
  std::string input;
  std::string output = "-";
  app.add_option("file", input, "PCD, PLY, LAS, LAZ or XYZ; - for stdin")->required();
  cli::add_output(app, "-o,--output", output, "box map to write (default: stdout)");
  options.add_to(app);
  cli::Sharding sharding;
  sharding.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    options.settle();
    refuse_what_needs_more(input, options, sharding);
    sharding.begin(app, {{"file", input}}, {{"output", output}});
    if (const auto done = sharding.finished(common)) return *done;
    cli::InputFile file(input);
    geom::HashedStream first(file.stream());
    if (first.head().empty()) throw geom::InputError(file.name(), {.says = "the file is empty"});
    options.settle_format(options.format
                              ? *options.format
                              : *geom::row_recognised(first.head(), geom::cloud_formats()),
                          file.name());
    std::optional<geom::RandomFile> random;
    if (std::filesystem::is_regular_file(input)) random.emplace(input);
    const geom::CloudFile cloud{file.name(), first, cli::open_input, random ? &*random : nullptr};
    const geom::Notes notes = cli::notes_of(common, "skyway-cloud");
    if (sharding.asked()) {
      const geom::ColumnDraft draft = geom::draft_columns(cloud, options.draft, sharding.shard(),
                                                          notes, common.execution("points"));
      sharding.write(output, "output", "columns",
                     geom::arrays_of(draft.map, draft.columns, options.draft.columns));
      common.write_stats(cli::to_json(draft.map.facts));
      return cli::Exit::yes;
    }
    cli::write_map(common, output,
                   geom::draft_cloud(cloud, options.draft, notes, common.execution("points")));
    return cli::Exit::yes;
  });
}
