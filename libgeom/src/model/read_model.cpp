#include "geom/model/read_model.h"

#include <filesystem>
#include <span>

#include "geom/base/sha256.h"
#include "geom/model/assimp_scene.h"
#include "model/draco_decoder.h"

namespace geom {
namespace {

std::string sha256_of(std::string_view bytes) {
  Sha256 sum;
  sum.update(std::as_bytes(std::span(bytes)));
  return sum.hex();
}

// Files beside the first one, as each is asked for; sums what it gives.
class Folder {
 public:
  Folder(const std::string& path, const ModelFiles& open)
      : folder_(std::filesystem::path(path).parent_path()), open_(open) {}

  std::string read(const std::string& name) {
    std::string bytes = open_((folder_ / name).string());
    add(name, bytes);
    return bytes;
  }

  void add(const std::string& name, std::string_view bytes) {
    ++count_;
    list_ += name + ' ' + sha256_of(bytes) + '\n';
  }

  std::size_t count() const { return count_; }
  std::string hash(const std::string& only) const {
    return "sha256:" + sha256_of(count_ == 1 ? only : list_);
  }

 private:
  std::filesystem::path folder_;
  const ModelFiles& open_;
  std::string list_;
  std::size_t count_ = 0;
};

// All that needs a library.
const ModelDecoders& decoders() {
  static const ModelDecoders all{decode_draco, read_collada, read_3ds};
  return all;
}

}  // namespace

ModelSource read_model(const std::string& path, const ModelFormat* format, const ModelFiles& open) {
  const std::string bytes = open(path);
  const std::string name = std::filesystem::path(path).filename().string();
  Folder folder(path, open);
  folder.add(name, bytes);
  const ModelFiles files = [&](const std::string& p) { return p == name ? bytes : folder.read(p); };
  ModelSource out;
  out.format = format ? format : &model_format_of(bytes, path);
  static_cast<LoadedModel&>(out) = out.format->read({bytes, path, name, files, decoders()});
  out.files = folder.count();
  out.hash = folder.hash(bytes);
  return out;
}

}  // namespace geom
