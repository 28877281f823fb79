#include "traj/submit/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/base/sha256.h"
#include "geom/text/json_line.h"
#include "geom/text/parse_json.h"

namespace traj {
namespace {

constexpr std::string_view kType = "manifest";

bool stays_inside(const std::string& path) {
  if (path.empty() || path.front() == '/' || path.find('\\') != std::string::npos) return false;
  for (std::size_t at = 0; at <= path.size();) {
    const std::size_t end = std::min(path.find('/', at), path.size());
    const std::string_view part = std::string_view(path).substr(at, end - at);
    if (part.empty() || part == "." || part == "..") return false;
    at = end + 1;
  }
  return true;
}

ListedFile read_file(const nlohmann::json& json, std::string_view source, std::size_t index) {
  const auto refuse = [&](const char* expected) -> ListedFile {
    throw geom::InputError(source, {.item = fmt::format("files[{}]", index),
                                    .expected = expected,
                                    .found = geom::shown(json)});
  };
  if (!json.is_object() || json.size() != 3 || !json.contains("path") || !json.contains("bytes") ||
      !json.contains("sha256")) {
    return refuse("path, bytes and sha256");
  }
  if (!json["path"].is_string() || !stays_inside(json["path"].get<std::string>())) {
    return refuse("a path within the folder");
  }
  if (!json["bytes"].is_number_unsigned()) return refuse("a number of bytes");
  if (!json["sha256"].is_string() || json["sha256"].get_ref<const std::string&>().size() != 64) {
    return refuse("64 hexadecimal digits");
  }
  return {json["path"].get<std::string>(), json["bytes"].get<std::uint64_t>(),
          json["sha256"].get<std::string>()};
}

}  // namespace

ListedFile listed_file(std::string path, std::string_view contents) {
  geom::Sha256 sum;
  sum.update(std::as_bytes(std::span(contents)));
  return {std::move(path), contents.size(), sum.hex()};
}

std::string to_json(std::vector<ListedFile> files, std::string_view made_by) {
  std::sort(files.begin(), files.end(),
            [](const ListedFile& a, const ListedFile& b) { return a.path < b.path; });
  std::string out =
      fmt::format("{{\"type\":\"{}\",\"made_by\":\"{}\",\"files\":[\n", kType, made_by);
  for (std::size_t i = 0; i < files.size(); ++i) {
    out += geom::JsonLine()
               .add("path", files[i].path)
               .add("bytes", files[i].bytes)
               .add("sha256", files[i].sha256)
               .object();
    out += i + 1 < files.size() ? ",\n" : "\n";
  }
  return out + "]}\n";
}

std::vector<ListedFile> read_manifest(std::string_view json, std::string_view source) {
  const nlohmann::json file = geom::parse_json(json, source);
  if (!file.is_object() || file.size() != 3 || file.value("type", "") != kType ||
      !file.contains("made_by") || !file.contains("files") || !file["files"].is_array()) {
    throw geom::InputError(source, {.expected = "a manifest: type, made_by and files"});
  }
  std::vector<ListedFile> out;
  for (std::size_t i = 0; i < file["files"].size(); ++i) {
    out.push_back(read_file(file["files"][i], source, i));
    if (i == 0 || out[i - 1].path < out[i].path) continue;
    throw geom::InputError(source, {.item = fmt::format("files[{}]", i),
                                    .expected = "files in the order of their paths, each once",
                                    .found = geom::in_quotes(out[i].path)});
  }
  return out;
}

std::optional<std::string> why_not_as_listed(std::span<const ListedFile> listed,
                                             std::span<const ListedFile> found) {
  std::size_t i = 0;
  std::size_t k = 0;
  while (i < listed.size() || k < found.size()) {
    if (k == found.size() || (i < listed.size() && listed[i].path < found[k].path)) {
      return fmt::format("{} is missing", listed[i].path);
    }
    if (i == listed.size() || found[k].path < listed[i].path) {
      return fmt::format("{} is not in the manifest", found[k].path);
    }
    if (listed[i].sha256 != found[k].sha256 || listed[i].bytes != found[k].bytes) {
      return fmt::format("{} was changed: its SHA-256 is {}, expected {}", listed[i].path,
                         found[k].sha256, listed[i].sha256);
    }
    ++i;
    ++k;
  }
  return std::nullopt;
}

}  // namespace traj
