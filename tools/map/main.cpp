// skyway-map: look at box maps and make others of them.

#include "cli/run.h"
#include "verbs.h"

int main(int argc, char** argv) {
  CLI::App app{"Look at box maps, and make others of them.", "skyway-map"};
  cli::Common common(app, true);
  const verbs::Verb all[] = {
      verbs::info(app, common),    verbs::crop(app, common),    verbs::bounds(app, common),
      verbs::join(app, common),    verbs::merge(app, common),   verbs::simplify(app, common),
      verbs::inflate(app, common), verbs::tile(app, common),    verbs::diff(app, common),
      verbs::patch(app, common),   verbs::to_csv(app, common),  verbs::to_geojson(app, common),
      verbs::to_ply(app, common),  verbs::to_gltf(app, common), verbs::to_sdf(app, common)};
  app.require_subcommand(1);
  return cli::run_tool(app, argc, argv, [&] {
    for (const verbs::Verb& verb : all) {
      if (verb.app->parsed()) return verb.run();
    }
    return cli::Exit::usage;
  });
}
