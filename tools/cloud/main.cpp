// skyway-cloud: point clouds become box maps.

#include <filesystem>

#include "cli/file/files.h"
#include "cli/option/map_output.h"
#include "cli/option/output_option.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "geom/base/error.h"
#include "options.h"

namespace {

using cloud::Options;

void refuse_what_needs_more(const std::string& input, const Options& options) {
  const geom::CloudDraftOptions& draft = options.draft;
  if (input == "-" && draft.drop_ground && draft.ground_by != "class" && !draft.in_memory()) {
    throw cli::UsageError("--ground-points drop reads the file twice: it cannot be stdin");
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
  return cli::run_tool(app, argc, argv, [&] {
    options.settle();
    refuse_what_needs_more(input, options);
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
    cli::write_map(common, output,
                   geom::draft_cloud(cloud, options.draft, cli::notes_of(common, "skyway-cloud"),
                                     common.execution("points")));
    return cli::Exit::yes;
  });
}
