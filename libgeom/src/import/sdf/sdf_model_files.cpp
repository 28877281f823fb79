#include "geom/import/sdf_model_files.h"

#include <filesystem>
#include <iterator>
#include <span>

#include "geom/base/sha256.h"
#include "geom/text/text_table.h"
#include "geom/text/xml_element.h"

namespace geom {
namespace {

namespace fs = std::filesystem;

// What follows the scheme, where the URI has it.
std::optional<std::string> after(const std::string& uri, std::string_view scheme) {
  if (!uri.starts_with(scheme)) return std::nullopt;
  return uri.substr(scheme.size());
}

std::optional<std::string> existing(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return std::nullopt;
  return path.lexically_normal().string();
}

// Minor version of an SDFormat 1.x that is read here; nothing of another.
std::optional<int> minor_of(const std::string& version) {
  if (!version.starts_with("1.")) return std::nullopt;
  const auto minor = parse_number(version.substr(2));
  if (!minor || !(*minor >= 4 && *minor <= 12)) return std::nullopt;
  return static_cast<int>(*minor);
}

std::string text_of(const std::string& path, const OpenFile& open) {
  const auto file = open(path);
  return {std::istreambuf_iterator<char>(*file), {}};
}

// The file of a model's folder.
std::string model_in(const fs::path& folder, const OpenFile& open) {
  const fs::path config = folder / "model.config";
  std::string best = "model.sdf";
  std::error_code error;
  if (fs::exists(config, error)) {
    int newest = 0;
    const std::string text = text_of(config.string(), open);
    for (const XmlElement& child : parse_xml(text, config.string()).children) {
      if (child.name != "sdf") continue;
      for (const auto& [key, value] : child.attributes) {
        const auto minor = key == "version" ? minor_of(value) : std::nullopt;
        if (!minor || *minor < newest) continue;
        newest = *minor;
        best = trimmed(child.text);
      }
    }
  }
  return (folder / best).string();
}

}  // namespace

std::optional<std::string> SdfModelFiles::path_of(const std::string& uri,
                                                  const std::string& from) const {
  const auto in_folders = [&](const std::string& rest) -> std::optional<std::string> {
    for (const std::string& folder : folders_) {
      if (const auto found = existing(fs::path(folder) / rest)) return found;
    }
    return std::nullopt;
  };
  for (const char* scheme : {"model://", "package://"}) {
    if (const auto rest = after(uri, scheme)) return in_folders(*rest);
  }
  const auto local = after(uri, "file://");
  if (!local && uri.find("://") != std::string::npos) return std::nullopt;
  const std::string path = local.value_or(uri);
  const fs::path beside = fs::path(from).parent_path() / path;  // of a whole path, the path itself
  if (const auto found = existing(beside)) return found;
  return in_folders(path);
}

void SdfModelFiles::serve(SdfOptions& options) {
  options.open = [this](const std::string& uri, const std::string& from) {
    return open(uri, from);
  };
  options.open_mesh = [this](const std::string& uri, const std::string& from) {
    return open_mesh(uri, from);
  };
}

const SdfFile* SdfModelFiles::open(const std::string& uri, const std::string& from) {
  const auto named = path_of(uri, from);
  if (!named) return nullptr;
  std::error_code error;
  return load(fs::is_directory(*named, error) ? model_in(*named, open_) : *named);
}

const SdfFile* SdfModelFiles::open_mesh(const std::string& uri, const std::string& from) {
  const auto named = path_of(uri, from);
  return named ? load(*named) : nullptr;
}

const SdfFile* SdfModelFiles::load(const std::string& path) {
  const auto known = files_.find(path);
  if (known != files_.end()) return &known->second;
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return nullptr;
  std::string text = text_of(path, open_);
  Sha256 sum;
  sum.update(std::as_bytes(std::span(text)));
  hashes_.push_back("sha256:" + sum.hex());
  return &(files_[path] = {path, std::move(text)});
}

}  // namespace geom
