#include "geom/model/model_format.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "geom/base/error.h"
#include "geom/text/beginning.h"
#include "geom/text/spoken_list.h"

namespace geom {
namespace {

constexpr std::string_view kReaders[] = {"skyway-mesh"};
constexpr Format kCollada{.word = "collada",
                          .what = "a COLLADA model",
                          .begins = xml_with<"<COLLADA">,
                          .readers = kReaders};
constexpr Format k3ds{.word = "3ds", .what = "a 3DS model", .readers = kReaders};

constexpr const ModelFormat* kTable[] = {&kObjModel,     &kPlyModel, &kStlModel,  &kGltfModel,
                                         &kColladaModel, &k3dsModel, &kTilesModel};

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

// ".obj, .ply or .stl"
std::string any_ending() {
  std::vector<std::string_view> endings;
  for (const ModelFormat* format : kTable) {
    if (!format->ending.empty()) endings.push_back(format->ending);
  }
  return spoken_list(endings, "or");
}

}  // namespace

constinit const Format kTileFile{.what = "a tile of 3D Tiles",
                                 .begins = begins_with<"b3dm">,
                                 .advice = "give skyway-mesh the tileset.json that names it"};

constinit const ModelFormat kColladaModel{
    .format = &kCollada, .ending = ".dae", .read = [](const ModelFile& file) {
      return LoadedModel{file.decoders.collada(file.bytes, file.path)};
    }};

constinit const ModelFormat k3dsModel{
    .format = &k3ds, .ending = ".3ds", .read = [](const ModelFile& file) {
      return LoadedModel{file.decoders.studio(file.bytes, file.path)};
    }};

FormatRows<ModelFormat> model_formats() { return kTable; }

const ModelFormat* model_format_by_ending(const std::string& path) {
  const std::string ending = ending_of(path);
  for (const ModelFormat* format : kTable) {
    if (!ending.empty() && format->ending == ending) return format;
  }
  return nullptr;
}

const ModelFormat& model_format_of(std::string_view bytes, const std::string& path) {
  if (bytes.empty()) throw InputError(path, {.says = "the file is empty"});
  if (const Format* const format = recognise(bytes, formats_of(model_formats()))) {
    return *row_of(*format, model_formats());
  }
  for (const ModelFormat* format : kTable) {
    if (format->may_be && format->may_be(bytes, path)) return *format;
  }
  if (kTileFile.begins(bytes)) {
    throw InputError(path, {.says = "this is one tile, which does not say where it stands",
                            .advice = "give the tileset.json that names it"});
  }
  if (const ModelFormat* const format = model_format_by_ending(path)) return *format;
  throw InputError(path, {.expected = "a file whose name ends in " + any_ending() +
                                      ", a glTF file or a tileset.json; --format says what it is"});
}

}  // namespace geom
