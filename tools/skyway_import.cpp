// skyway-import: city tables and block texts become box maps.

#include <fmt/format.h>

#include <sstream>

#include "cli/files.h"
#include "cli/map_output.h"
#include "cli/run.h"
#include "geom/error.h"
#include "geom/io/block_text.h"
#include "geom/io/box_csv.h"
#include "geom/io/fcnd_csv.h"
#include "geom/make_map.h"
#include "geom/sha256.h"

namespace {

struct Source {
  geom::BoxTable table;
  geom::Frame frame;
  std::size_t flat = 0;
  double largest_change = 0;
};

struct Options {
  std::string format = "auto";
  std::string frame;
  cli::MapOptions map;
};

std::string detect(const std::string& text) {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.find("min_x_m") != std::string::npos) return "box-csv";
    const std::size_t at = line.find_first_not_of(" \t\r");
    if (at == std::string::npos || line[at] == '#') continue;
    if (line.compare(at, 8, "boundary") == 0 || line.compare(at, 5, "block") == 0)
      return "block-text";
    return "fcnd";
  }
  return "fcnd";
}

Source read(const std::string& text, const std::string& name, const Options& options,
            geom::MakeMapOptions& map, const cli::Common& common) {
  map = options.map.make(options.format == "fcnd" ? 1 : 0);
  std::istringstream in(text);
  Source source;
  if (options.format == "fcnd") {
    geom::FcndTable fcnd = geom::read_fcnd_csv(in, name);
    source = {
        std::move(fcnd.table), {geom::Axes::neu, fcnd.origin, ""}, fcnd.flat, fcnd.largest_change};
    if (!map.floor) map.floor = 0;
  } else if (options.format == "box-csv") {
    source.table = geom::read_box_csv(in, name);
  } else {
    geom::BlockText block = geom::read_block_text(in, name);
    for (const std::string& word : block.unknown) common.warn(name + ": unknown keyword, " + word);
    source.table = std::move(block.table);
    source.flat = block.flat;
    map.source_bounds = block.boundary;
  }
  if (!options.frame.empty()) source.frame.axes = *geom::axes_from_name(options.frame);
  return source;
}

std::string history_of(const std::string& text, const Options& options,
                       const geom::MakeMapOptions& map) {
  geom::Sha256 sum;
  sum.update(std::as_bytes(std::span(text)));
  nlohmann::ordered_json step = {
      {"tool", "skyway-import"}, {"input", "sha256:" + sum.hex()}, {"format", options.format}};
  step.update(cli::history_of(map));
  return nlohmann::ordered_json::array({step}).dump();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Convert a city table or a block text to a box map.", "skyway-import"};
  cli::Common common(app);
  Options options;
  std::string input;
  std::string output = "-";
  app.add_option("file", input, "FCND CSV, box CSV or block text; - for stdin")->required();
  app.add_option("-o,--output", output, "box map to write (default: stdout)");
  app.add_option("--format", options.format, "auto, fcnd, box-csv or block-text")
      ->check(CLI::IsMember({"auto", "fcnd", "box-csv", "block-text"}));
  app.add_option("--frame", options.frame, "enu or neu (default: neu for FCND tables, else enu)")
      ->check(CLI::IsMember({"enu", "neu"}));
  options.map.add_to(app, "1 for FCND tables, else 0");
  return cli::run_tool(app, argc, argv, [&] {
    cli::InputFile file(input);
    const std::string text = file.read_all();
    if (options.format == "auto") options.format = detect(text);
    geom::MakeMapOptions map_options;
    Source source = read(text, file.name(), options, map_options, common);
    if (source.flat > 0)
      common.warn(fmt::format("{}: {} flat box(es) kept", file.name(), source.flat));
    const geom::MadeMap made =
        geom::make_map(std::move(source.table), source.frame,
                       history_of(text, options, map_options), file.name(), map_options);
    cli::write_map(common, output, made, file.name(),
                   {{"format", options.format},
                    {"flat", source.flat},
                    {"largest_change_m", source.largest_change}});
    return cli::Exit::yes;
  });
}
