#pragma once

// The proof of a folder for an authority that somebody else made (skyway-submit).
//
// Example, not run:
//   const traj::SubmissionCheck check = traj::check_submission("vienna");
//   if (!check.ok()) std::cerr << check.refusal->file << ": " << check.refusal->why << '\n';
//   std::cout << traj::to_json_line(check);

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/base/open_file.h"
#include "geom/map/box_map.h"

namespace traj {

// How a folder is checked. A program that counts its files, or that has verified its maps before,
// opens them itself.
struct SubmissionRun {
  geom::OpenFile open = geom::open_file;
  std::function<geom::BoxMap(const std::string& path)> open_map = {};  // empty: geom::open_map
  geom::Execution flights = {};
  geom::Execution pairs = {};  // of flights
};

// Why a folder is refused: what is wrong, and of which file.
struct FolderRefusal {
  std::string file;
  std::string why;
};

struct SubmissionCheck {
  std::optional<FolderRefusal> refusal;
  std::string manifest;  // its SHA-256
  std::size_t flights = 0;
  std::size_t files = 0;
  std::vector<std::string> not_verified;  // files and claims that nobody looked at

  bool ok() const { return !refusal; }
};

// Holds every file against the manifest, each flight against the map, and every claim against what
// follows from the files. Nothing in the folder is believed. Throws geom::InputError for files of
// another form, and geom::FileError for those that cannot be read. The same for any number of
// threads.
SubmissionCheck check_submission(const std::filesystem::path& folder,
                                 const SubmissionRun& run = {});

// The report of skyway-check; ends with a newline.
std::string to_json_line(const SubmissionCheck& check);

}  // namespace traj
