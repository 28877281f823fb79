#include "outputs.h"

#include <filesystem>
#include <list>

#include "cli/file/files.h"

namespace exporting {

Outputs::Outputs(const Options& options)
    : names_{geom::OutputNames(options.output, "--output"),
             geom::OutputNames(options.python, "--python"),
             geom::OutputNames(options.table, "--table")},
      source_(options.source()),
      wanted_{true, !options.python.empty(), !options.table.empty()} {}

void Outputs::add(const std::string& id) {
  Files files;
  for (int i = 0; i < 3; ++i) {
    if (wanted_[i]) files[i] = names_[i].of(id, source_);
  }
  files_.push_back(files);
}

std::vector<std::string> Outputs::stale(std::size_t index) const {
  std::vector<std::string> stale;
  for (const std::string& file : files_[index]) {
    if (!file.empty() && std::filesystem::exists(file)) stale.push_back(file);
  }
  return stale;
}

void Outputs::save(std::size_t index, const traj::MissionFormat& format,
                   const traj::WrittenMission& written) const {
  const auto kind = format.is_binary ? cli::OutputKind::artefact : cli::OutputKind::text;
  const std::string* const texts[] = {&written.text, &written.python, &written.csv};
  std::list<cli::OutputFile> outputs;
  for (int i = 0; i < 3; ++i) {
    if (wanted_[i]) outputs.emplace_back(files_[index][i], kind).stream() << *texts[i];
  }
  for (cli::OutputFile& file : outputs) each() ? file.commit_now() : file.commit();
}

void warn_of_stale(const cli::Common& common, const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    common.warn(file + " is of an earlier run, and not what was refused now: do not fly it");
  }
}

}  // namespace exporting
