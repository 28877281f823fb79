#include "tubes.h"

#include <filesystem>

#include "cli/file/files.h"
#include "geom/base/text_stream.h"
#include "traj/submit/submitted_flights.h"

namespace submitting {

std::optional<traj::TubeReports> take_tubes(const std::string& path, traj::SubmissionMethod& method,
                                            SubmissionFolder& folder) {
  if (path.empty()) return std::nullopt;
  const std::string text = cli::InputFile(path).read_all();
  geom::TextInput in(text);
  traj::TubeReports tubes = traj::TubeReports::read(in, path);
  method.tubes = {std::filesystem::path(path).filename().string(),
                  traj::listed_file(traj::kTubesFile, text).sha256};
  method.risk.geography = traj::GeographyRule::proved_tube;
  folder.add(traj::kTubesFile, text);
  return tubes;
}

}  // namespace submitting
