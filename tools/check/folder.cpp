#include "folder.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "cli/file/files.h"
#include "cli/option/common.h"
#include "traj/submit/check_submission.h"

namespace checking {
namespace {

// A stream that keeps its file.
std::shared_ptr<std::istream> opened(const std::string& path) {
  const auto file = std::make_shared<cli::InputFile>(path);
  return {file, &file->stream()};
}

}  // namespace

bool is_folder(const CLI::App& app, const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) return false;
  static const std::set<std::string> with{"map",        "--output", "--threads",
                                          "--progress", "--stats",  "--quiet"};
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_single_name().size() > 1 && option->get_positional()
                                 ? option->get_single_name()
                                 : "--" + option->get_single_name();
    if (option->count() == 0 || with.contains(name)) continue;
    throw cli::UsageError(fmt::format(
        "{} is a folder, which is checked as its own files say: leave {} out", path, name));
  }
  return true;
}

cli::Exit check_folder(const cli::Common& common, const std::string& path,
                       const std::string& report) {
  const traj::SubmissionCheck check = traj::check_submission(
      path,
      {.open = opened,
       .open_map =
           [](const std::string& map) { return cli::open_map(map, geom::Verified::contents); },
       .flights = common.execution("flights"),
       .pairs = common.execution("pairs")});
  if (!check.ok()) {
    cli::complain("skyway-check", check.refusal->file + ": refused: " + check.refusal->why);
  }
  cli::OutputFile out(report, cli::OutputKind::text);
  out.stream() << traj::to_json_line(check);
  out.commit();
  common.write_stats({{"flights", check.flights}, {"ok", check.ok()}});
  return check.ok() ? cli::Exit::yes : cli::Exit::no;
}

}  // namespace checking
