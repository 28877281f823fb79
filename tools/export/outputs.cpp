#include "outputs.h"

#include <filesystem>
#include <list>

#include "cli/file/files.h"

namespace exporting {

Outputs::Outputs(const Options& options) : source_(options.source()) {
  for (const Options::Output& one : options.outputs()) {
    names_.emplace_back();
    if (!one.name.empty()) names_.back().emplace(one.name, one.option);
  }
}

void Outputs::add(const std::string& id) {
  Files files;
  for (auto& names : names_) files.push_back(names ? names->of(id, source_) : "");
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
  const std::string* const texts[] = {&written.text,     &written.python, &written.csv,
                                      &written.fences,   &written.rally,  &written.params,
                                      &written.procedure};
  std::list<cli::OutputFile> outputs;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (names_[i]) outputs.emplace_back(files_[index][i], kind).stream() << *texts[i];
  }
  for (cli::OutputFile& file : outputs) each() ? file.commit_now() : file.commit();
}

void warn_of_stale(const cli::Common& common, const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    common.warn(file + " is of an earlier run, and not what was refused now: do not fly it");
  }
}

}  // namespace exporting
