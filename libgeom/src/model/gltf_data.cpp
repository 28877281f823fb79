#include "gltf_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "buffer_view.h"
#include "geom/base/error.h"
#include "geom/text/parse_json.h"
#include "little_endian.h"
#include "model_path.h"

namespace geom {
namespace {

struct Component {
  std::size_t bytes;
  double most;  // that 1 is stored as where normalised; 0: of floats
  bool with_sign;
};

std::optional<Component> component_of(std::uint64_t type) {
  switch (type) {
    case 5120:
      return Component{1, 127, true};
    case 5121:
      return Component{1, 255, false};
    case 5122:
      return Component{2, 32767, true};
    case 5123:
      return Component{2, 65535, false};
    case 5125:
      return Component{4, 4294967295.0, false};
    case 5126:
      return Component{4, 0, true};
    default:
      return std::nullopt;
  }
}

double component_at(std::string_view bytes, std::size_t at, const Component& c) {
  if (c.most == 0) return static_cast<double>(little_endian<float>(bytes, at));
  if (c.bytes == 1) {
    const auto v = little_endian<std::uint8_t>(bytes, at);
    return c.with_sign ? static_cast<double>(static_cast<std::int8_t>(v)) : v;
  }
  if (c.bytes == 2) {
    const auto v = little_endian<std::uint16_t>(bytes, at);
    return c.with_sign ? static_cast<double>(static_cast<std::int16_t>(v)) : v;
  }
  return little_endian<std::uint32_t>(bytes, at);
}

std::size_t columns_of(const std::string& type) {
  static const std::map<std::string, std::size_t> kColumns = {
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  const auto at = kColumns.find(type);
  return at == kColumns.end() ? 0 : at->second;
}

// What an accessor of this type is made of.
Component component_in(const JsonMembers& accessor, const std::string& type) {
  if (accessor.text("type") != type) {
    accessor.refuse({.expected = fmt::format("type {}", type),
                     .found = in_quotes(accessor.text("type").substr(0, 20))});
  }
  const auto component = component_of(accessor.whole("componentType"));
  if (!component) accessor.refuse({.expected = "a component type of glTF"});
  if (accessor.has("sparse")) accessor.refuse({.says = "it is sparse, which is not read"});
  return *component;
}

// Refuses what is no number, and normalises where the accessor says so.
void finish(GltfData::Numbers& rows, const JsonMembers& accessor, const Component& component) {
  const bool normalised = accessor.truth("normalized") && component.most > 0;
  for (std::size_t i = 0; i < rows.values.size(); ++i) {
    double& v = rows.values[i];
    if (!std::isfinite(v)) {
      accessor.refuse(
          {.expected = "numbers", .found = fmt::format("{} as value {}", v, i / rows.columns)});
    }
    if (normalised) v = std::max(v / component.most, -1.0);
  }
}

}  // namespace

GltfData::GltfData(std::string_view bytes, std::string source, const ModelFiles& files,
                   std::string_view path)
    : source_(std::move(source)), path_(path), files_(files) {
  read_container(bytes);
  root_.emplace(json_, source_, "glTF");
  const JsonMembers asset(root_->members("asset"), source_, "asset");
  const std::string version = asset.text("version");
  if (!version.starts_with("2.")) {
    asset.refuse({.expected = "glTF version 2", .found = in_quotes(version.substr(0, 20))});
  }
  // Readers of 2.0 understand later versions that ask for no more.
  const std::string least = asset.find_text("minVersion").value_or("2.0");
  if (least != "2.0") {
    asset.refuse({.expected = "a glTF file that readers of version 2.0 may read",
                  .found = fmt::format("minVersion \"{}\"", least.substr(0, 20))});
  }
}

// A .glb has a head of 12 bytes, and chunks of which the first is JSON (specification, 4.4).
void GltfData::read_container(std::string_view bytes) {
  if (!bytes.starts_with("glTF")) {
    json_ = parse_json(bytes, source_);
    return;
  }
  const auto refuse = [&](Fault fault) { throw InputError(source_, std::move(fault)); };
  if (bytes.size() < 20)
    refuse({.says = fmt::format("a .glb of {} bytes is cut short", bytes.size())});
  if (const auto version = little_endian<std::uint32_t>(bytes, 4); version != 2) {
    refuse({.expected = "a .glb of version 2", .found = fmt::format("version {}", version)});
  }
  const std::size_t length = little_endian<std::uint32_t>(bytes, 8);
  if (length > bytes.size() || length < 20 || bytes.size() - length >= 8) {
    refuse({.expected = fmt::format("a .glb of {} bytes, as it says", length),
            .found = fmt::to_string(bytes.size())});
  }
  bool text = false;
  for (std::size_t at = 12; at < length;) {
    if (length - at < 8) refuse({.says = "the last chunk of the .glb is cut short"});
    const std::size_t size = little_endian<std::uint32_t>(bytes, at);
    const auto type = little_endian<std::uint32_t>(bytes, at + 4);
    if (size > length - at - 8) {
      refuse({.says = fmt::format("a chunk of the .glb says {} bytes, where {} are left", size,
                                  length - at - 8)});
    }
    const std::string_view chunk = bytes.substr(at + 8, size);
    if (!text) {
      if (type != 0x4E4F534A) refuse({.expected = "the first chunk of the .glb to be JSON"});
      json_ = parse_json(chunk, source_);
      text = true;
    } else if (type == 0x004E4942 && !has_binary_) {
      binary_ = chunk;
      has_binary_ = true;
    }
    at += 8 + size;
  }
}

std::string_view GltfData::buffer(std::uint64_t i) {
  const JsonMembers buffer = root().at("buffers", i, "buffer");
  const std::uint64_t length = buffer.whole("byteLength");
  const auto uri = buffer.find_text("uri");
  std::string_view bytes;
  if (!uri) {
    if (i != 0 || !has_binary_)
      buffer.refuse({.says = "it has no \"uri\", and no bytes in the file"});
    bytes = binary_;
  } else {
    const auto [at, added] = loaded_.try_emplace(i);
    if (added)
      at->second = is_data_uri(*uri) ? data_of_uri(*uri, source_)
                                     : files_(path_of_uri(*uri, path_, source_));
    bytes = at->second;
  }
  if (bytes.size() < length) {
    buffer.refuse({.expected = fmt::format("{} bytes, as it says", length),
                   .found = fmt::to_string(bytes.size())});
  }
  return bytes.substr(0, length);
}

std::string_view GltfData::view(std::uint64_t i, std::uint64_t& stride) {
  const JsonMembers view = root().at("bufferViews", i, "bufferView");
  if (view.members("extensions").contains("EXT_meshopt_compression")) {
    view.refuse(
        {.says = "it is compressed by EXT_meshopt_compression, which is not read",
         .advice =
             "write the file without, for example with `gltf-transform copy in.glb out.glb`"});
  }
  const std::string_view bytes = bytes_of(view, buffer(view.whole("buffer")));
  stride = view.whole("byteStride", 0);
  return bytes;
}

std::string_view GltfData::view(std::uint64_t i) {
  std::uint64_t stride = 0;
  return view(i, stride);
}

bool GltfData::has_rows(std::uint64_t accessor) const {
  return root().at("accessors", accessor, "accessor").has("bufferView");
}

GltfData::Numbers GltfData::numbers(std::uint64_t accessor, const std::string& type) {
  const JsonMembers a = root().at("accessors", accessor, "accessor");
  const Component component = component_in(a, type);
  const auto view_number = a.find_whole("bufferView");
  if (!view_number)
    a.refuse({.says = "it has no \"bufferView\": its numbers are compressed, or missing"});
  Numbers out;
  out.columns = columns_of(type);
  std::uint64_t stride = 0;
  const std::string_view bytes = view(*view_number, stride);
  const std::uint64_t row = out.columns * component.bytes;
  if (stride == 0) stride = row;
  if (stride < row || stride > 255) {
    a.refuse(
        {.expected = fmt::format("a stride from {} to 255", row), .found = fmt::to_string(stride)});
  }
  const std::uint64_t offset = a.whole("byteOffset", 0);
  const std::uint64_t count = a.whole("count");
  // By division: counts that lie are as large as they like.
  const bool fits = offset <= bytes.size() &&
                    (count == 0 || (bytes.size() - offset >= row &&
                                    count - 1 <= (bytes.size() - offset - row) / stride));
  if (!fits) {
    a.refuse({.expected = fmt::format(
                  "{} values within the {} bytes of its view, from {} on, every {} bytes", count,
                  bytes.size(), offset, stride)});
  }
  out.values.reserve(count * out.columns);
  for (std::uint64_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < out.columns; ++k) {
      const std::size_t at = offset + i * stride + k * component.bytes;
      out.values.push_back(component_at(bytes, at, component));
    }
  }
  finish(out, a, component);
  return out;
}

GltfData::Numbers GltfData::numbers(std::uint64_t accessor, const std::string& type,
                                    const DracoMesh::Attribute& unpacked) {
  const JsonMembers a = root().at("accessors", accessor, "accessor");
  const Component component = component_in(a, type);
  Numbers out{columns_of(type), unpacked.values};
  if (unpacked.columns != out.columns || out.count() != a.whole("count")) {
    a.refuse(
        {.expected = fmt::format("{} rows of {}", a.whole("count"), out.columns),
         .found = fmt::format("{} rows of {} in what Draco compressed",
                              unpacked.values.size() / std::max<std::size_t>(unpacked.columns, 1),
                              unpacked.columns)});
  }
  if (a.truth("normalized") && unpacked.component_type != a.whole("componentType")) {
    a.refuse({.says = fmt::format("it is normalised, and expected component type {}",
                                  a.whole("componentType")),
              .found = fmt::format("{} in what Draco compressed", unpacked.component_type)});
  }
  finish(out, a, component);
  return out;
}

}  // namespace geom
