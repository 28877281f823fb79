// skyway-view: everything in one HTML page that opens in any browser, without a server or network.

#include "cli/files.h"
#include "cli/run.h"
#include "cli/vehicle_option.h"
#include "view/layers.h"
#include "view/page.h"

namespace {

void require_one_stdin(const std::vector<std::string>& files) {
  if (std::count(files.begin(), files.end(), "-") > 1) {
    throw cli::UsageError("only one input may be -");
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Show maps, lattices, search trees, paths, trajectories, flights and reports in one "
      "HTML page.",
      "skyway-view"};
  cli::Common common(app);
  cli::VehicleOptions vehicle;
  std::vector<std::string> files;
  std::string title = "Skyway";
  std::string output = "-";
  app.add_option("files", files,
                 "box map, lattices, records (JSON Lines) and flight logs (CSV); - for stdin")
      ->required();
  app.add_option("-o,--output", output, "HTML page to write (default: stdout)");
  app.add_option("--title", title, "what the page is called");
  vehicle.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    require_one_stdin(files);
    const view::Contents contents = view::read_contents(files);
    view::Bundle bundle;
    const view::Json meta = view::describe(contents, vehicle, bundle);
    const std::string page = view::page(title, meta, bundle);
    cli::OutputFile out(output, cli::OutputKind::artefact);
    out.stream() << page;
    out.commit();
    common.write_stats({{"boxes", contents.map ? contents.map->record.size() : 0},
                        {"trees", contents.trees.size()},
                        {"paths", contents.paths.size()},
                        {"motions", meta["motions"].size()},
                        {"reports", contents.reports.size()},
                        {"bytes", page.size()}});
    return cli::Exit::yes;
  });
}
