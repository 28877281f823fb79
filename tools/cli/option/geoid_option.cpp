#include "geoid_option.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

#include "cli/file/files.h"
#include "geom/base/usage_error.h"

namespace cli {
namespace {

// Where packages put the grids, the finest first.
std::vector<std::string> grids_of(const std::string& word) {
  std::vector<std::string> out;
  const auto add = [&](std::initializer_list<const char*> names) {
    for (const char* name : names) {
      for (const char* folder : {"/usr/local/share/GeographicLib", "/usr/share/GeographicLib"}) {
        out.push_back(fmt::format("{}/geoids/{}.pgm", folder, name));
      }
    }
  };
  if (word == "egm96") {
    add({"egm96-5", "egm96-15"});
    out.emplace_back("/usr/share/proj/egm96_15.gtx");
  } else if (word == "egm2008") {
    add({"egm2008-1", "egm2008-2_5", "egm2008-5"});
  } else {
    out.push_back(word);
  }
  return out;
}

}  // namespace

NamedGeoidGrid geoid_grid_of(const std::string& word) {
  const std::vector<std::string> paths = grids_of(word);
  for (const std::string& path : paths) {
    if (!std::filesystem::exists(path)) continue;
    return {geom::read_geoid_grid(*open_input(path), path), path};
  }
  throw geom::UsageError(fmt::format(
      "--geoid-grid: expected the grid of a geoid (egm96, egm2008 or a file, .gtx or .pgm), found "
      "\"{}\", of which there is no file {}: geographiclib-get-geoids of the package "
      "geographiclib-tools gets grids",
      word, fmt::join(paths, ", ")));
}

void add_geoid_grid(CLI::App& app, traj::Placement& placement) {
  app.add_option_function<std::string>(
         "--geoid-grid",
         [&placement](const std::string& word) {
           NamedGeoidGrid named = geoid_grid_of(word);
           placement.geoid_name = std::filesystem::path(named.path).filename().string();
           placement.geoid_grid = std::make_shared<const geom::GeoidGrid>(std::move(named.grid));
         },
         kGeoidGridHelp)
      ->excludes("--geoid");
}

}  // namespace cli
