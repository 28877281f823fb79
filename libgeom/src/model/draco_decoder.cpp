#include "model/draco_decoder.h"

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "geom/base/error.h"
#include "geom/text/excerpt.h"

namespace geom {
namespace {

struct Component {
  std::uint64_t type;  // of glTF
  double (*at)(const std::uint8_t* bytes);
};

template <class T>
double number_at(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

// Nothing for those that glTF has not.
std::optional<Component> component_of(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return Component{5120, number_at<std::int8_t>};
    case draco::DT_UINT8:
      return Component{5121, number_at<std::uint8_t>};
    case draco::DT_INT16:
      return Component{5122, number_at<std::int16_t>};
    case draco::DT_UINT16:
      return Component{5123, number_at<std::uint16_t>};
    case draco::DT_UINT32:
      return Component{5125, number_at<std::uint32_t>};
    case draco::DT_FLOAT32:
      return Component{5126, number_at<float>};
    default:
      return std::nullopt;
  }
}

// The next number of a row of them, seven bits a byte, the least first; nothing where it is cut.
std::optional<std::uint64_t> next_number(std::string_view& bytes) {
  std::uint64_t number = 0;
  for (unsigned shift = 0; shift < 35 && !bytes.empty(); shift += 7) {
    const auto byte = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    number |= std::uint64_t{byte & 0x7fu} << shift;
    if (byte < 0x80) return number;
  }
  return std::nullopt;
}

// libdraco makes room for as many triangles and vertices as the first bytes say, before it looks
// for any: refuses where that is far more than so many bytes have ever held. What is cut is left to
// it.
void require_plausible_counts(std::string_view bytes, const std::string& source) {
  constexpr std::size_t kHeader = 11;  // name, version, kind, method, flags
  constexpr std::uint64_t kMostOfAByte = 1000;
  if (bytes.size() < kHeader || !bytes.starts_with("DRACO")) return;
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  if (at(5) != 2 || at(6) != 2) {
    throw InputError(source, {.expected = "the Draco bitstream 2.2 of glTF",
                              .found = fmt::format("{}.{}", at(5), at(6))});
  }
  if ((at(10) & 0x80) != 0) {  // it would stand before the counts
    throw InputError(source, {.says = "metadata in what Draco compressed is not read"});
  }
  const bool edgebreaker = at(8) == 1;  // whose kind of traversal comes first
  std::string_view rest = bytes.substr(std::min(bytes.size(), kHeader + (edgebreaker ? 1 : 0)));
  for (int i = 0; i < 2; ++i) {
    const auto count = next_number(rest);
    if (!count) return;
    if (*count > kMostOfAByte * bytes.size()) {
      throw InputError(
          source, {.says = fmt::format("what Draco compressed says that it has {} triangles or "
                                       "vertices in {} bytes; more than {} a byte are not read",
                                       *count, bytes.size(), kMostOfAByte)});
    }
  }
}

class Decoded {
 public:
  Decoded(const draco::Mesh& mesh, const std::string& source) : mesh_(mesh), source_(source) {}

  DracoMesh mesh() const {
    DracoMesh out;
    out.vertices = mesh_.num_points();
    out.corners.reserve(std::size_t{3} * mesh_.num_faces());
    for (std::uint32_t f = 0; f < mesh_.num_faces(); ++f) {
      for (const draco::PointIndex& corner : mesh_.face(draco::FaceIndex(f))) {
        if (corner.value() >= out.vertices)
          refuse({.says = "a triangle has a vertex that is not there"});
        out.corners.push_back(corner.value());
      }
    }
    for (int i = 0; i < mesh_.num_attributes(); ++i) {
      const draco::PointAttribute& attribute = *mesh_.attribute(i);
      const auto component = component_of(attribute.data_type());
      if (!component) continue;
      const auto [at, added] =
          out.attributes.try_emplace(attribute.unique_id(), rows(attribute, *component));
      if (!added) refuse({.says = fmt::format("two attributes have the number {}", at->first)});
    }
    return out;
  }

 private:
  [[noreturn]] void refuse(Fault fault) const {
    throw InputError(source_, within("what Draco compressed", std::move(fault)));
  }

  DracoMesh::Attribute rows(const draco::PointAttribute& attribute,
                            const Component& component) const {
    DracoMesh::Attribute out{component.type, attribute.num_components(), {}};
    const std::int64_t width = draco::DataTypeLength(attribute.data_type());
    const auto row = static_cast<std::int64_t>(out.columns) * width;
    const auto end = static_cast<std::int64_t>(attribute.buffer()->data_size());
    if (!attribute.is_mapping_identity() && attribute.indices_map_size() < mesh_.num_points()) {
      refuse({.says = "a vertex has no value"});
    }
    out.values.reserve(out.columns * mesh_.num_points());
    for (std::uint32_t p = 0; p < mesh_.num_points(); ++p) {
      const draco::AttributeValueIndex value = attribute.mapped_index(draco::PointIndex(p));
      const std::int64_t at = attribute.GetBytePos(value);
      if (value.value() >= attribute.size() || at < 0 || at > end - row) {
        refuse({.says = "a vertex has a value that is not there"});
      }
      for (std::size_t k = 0; k < out.columns; ++k) {
        out.values.push_back(
            component.at(attribute.GetAddress(value) + static_cast<std::int64_t>(k) * width));
      }
    }
    return out;
  }

  const draco::Mesh& mesh_;
  const std::string& source_;
};

}  // namespace

DracoMesh decode_draco(std::string_view bytes, const std::string& source) {
  require_plausible_counts(bytes, source);
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  const auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) {
    throw InputError(source,
                     {.expected = fmt::format(
                          "triangles that Draco compressed, which libdraco could not decode: {}",
                          excerpt(decoded.status().error_msg_string(), 120))});
  }
  return Decoded(*decoded.value(), source).mesh();
}

}  // namespace geom
