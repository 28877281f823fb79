#pragma once

// The list of all files of a folder with their hashes.
//
// Example:
//   const std::vector<traj::ListedFile> files{traj::listed_file("a.txt", "abc")};
//   const std::string text = traj::to_json(files, "skyway 0.1");
//   assert(traj::read_manifest(text, "manifest.json") == files);
//   assert(!traj::why_not_as_listed(files, files));

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace traj {

struct ListedFile {
  std::string path;  // in the folder, with "/" between folders
  std::uint64_t bytes = 0;
  std::string sha256;  // 64 hexadecimal digits

  friend bool operator==(const ListedFile&, const ListedFile&) = default;
};

ListedFile listed_file(std::string path, std::string_view contents);

// A file a line, in the order of their paths.
std::string to_json(std::vector<ListedFile> files, std::string_view made_by);

// Throws geom::InputError(source, …) for anything that to_json() does not write: a path that leads
// out of the folder, one that comes twice, and files that are not in order.
std::vector<ListedFile> read_manifest(std::string_view json, std::string_view source);

// Nothing where the files of a folder are those of its list. Else the first that is missing, is not
// listed, or has other contents, in words. Both are in the order of their paths.
std::optional<std::string> why_not_as_listed(std::span<const ListedFile> listed,
                                             std::span<const ListedFile> found);

}  // namespace traj
