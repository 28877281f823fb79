// skyway-synth: a made-up city as an FCND table, the same for the same seed everywhere.

#include "cli/file/files.h"
#include "cli/option/output_option.h"
#include "cli/run.h"
#include "geom/import/synth_city.h"

int main(int argc, char** argv) {
  CLI::App app{"Make up a city: an FCND-style table of boxes.", "skyway-synth"};
  cli::Common common(app);
  geom::SynthSpec spec;
  std::string output = "-";
  double size = 0;
  app.add_option("--seed", spec.seed, "seed: which city (default 0)");
  app.add_option("--size", size, "side of the square, metres (default 900)")
      ->check(CLI::Range(200.0, 200000.0));
  app.add_option("--height", spec.height, "height of the tallest tower, metres (default 200)")
      ->check(CLI::Range(20.0, 1000.0));
  cli::add_output(app, "-o,--output", output, "FCND CSV to write (default: stdout)");
  return cli::run_tool(app, argc, argv, [&] {
    if (size > 0) spec.size_x = spec.size_y = size;
    const auto boxes = geom::synth_city(spec);
    cli::OutputFile file(output, cli::OutputKind::text);
    geom::write_fcnd_csv(file.stream(), {37.0, -122.0, 0.0}, boxes);
    file.commit();
    common.write_stats({{"boxes", boxes.size()}, {"seed", spec.seed}});
    return cli::Exit::yes;
  });
}
