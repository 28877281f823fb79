#include "laz_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "integer_decoder.h"
#include "laz_items.h"
#include "streaming_median.h"

namespace geom {
namespace {

using Kind = LazItem::Kind;

constexpr std::size_t kReturns = 14;  // the number of the return and, above it, of how many
constexpr std::size_t kFlags = 15;
constexpr std::size_t kPointLayers = 9;

std::size_t layers_of(const LazItem& item) {
  switch (item.kind) {
    case Kind::point14:
      return kPointLayers;
    case Kind::rgb_nir14:
      return 2;
    case Kind::byte14:
      return item.size;
    default:
      return 1;
  }
}

// By the number of returns and the number of the return, in any order: which points resemble each
// other.
constexpr unsigned return_kind(unsigned a, unsigned b) {
  constexpr std::uint8_t kNone[] = {0, 1, 2, 3, 4, 5, 3, 4, 4, 5, 5, 5, 5, 5, 5, 5};
  if (a > b) return return_kind(b, a);
  if (a == 0) return kNone[b];
  if (a == 1) return b <= 2 ? b - 1 : 3;
  if (a == 2) return b == 2 ? 2 : b <= 10 ? 4 : 3;
  return a == b || (a >= 11 && b == a + 1) ? 5 : 4;
}

constexpr auto kReturnKind = [] {
  std::array<std::array<std::uint8_t, 16>, 16> table{};
  for (unsigned of = 0; of < 16; ++of) {
    for (unsigned number = 0; number < 16; ++number) {
      table[of][number] = static_cast<std::uint8_t>(return_kind(of, number));
    }
  }
  return table;
}();

std::int32_t wrapped_sum(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}

// The code of one layer, all of whose bytes its points must take. An empty one changes nothing.
class Layer {
 public:
  Layer(const LazLayers::Layer& layer, std::string_view source)
      : end_(layer.at + layer.bytes.size()), bytes_(layer.bytes, layer.at, source) {
    if (!layer.bytes.empty()) code_.emplace(bytes_);
  }

  bool empty() const { return !code_; }
  RangeDecoder& code() { return *code_; }

  void require_end() const {
    if (code_) code_->require_end();
    if (bytes_.position() != end_) {
      bytes_.refuse(
          {.says = fmt::format(
               "its compressed points are damaged: a layer ends at byte {}, and its points at {}",
               end_, bytes_.position())});
    }
  }

 private:
  std::uint64_t end_;
  ByteSource bytes_;
  std::optional<RangeDecoder> code_;
};

struct Layers {
  Layer place;  // of returns, scanner channels, x and y
  Layer height;
  Layer cls;
};

// What is known of one scanner channel.
class Channel {
 public:
  Channel(const LazPoint& last, unsigned returns)
      : last_(last), number_(returns & 15), of_(returns >> 4) {
    heights_.fill(last.z);
  }

  const LazPoint& last() const { return last_; }
  unsigned returns() const { return number_ | of_ << 4; }

  unsigned what_changed(RangeDecoder& code) {
    return code.symbol(changed_[(number_ == 1) + 2 * (number_ >= of_) + 4 * time_changed_]);
  }

  // How many channels further the point is.
  unsigned other_channel(RangeDecoder& code) { return code.symbol(channel_) + 1; }

  void next(Layers& layers, unsigned changed) {
    const bool time_changed = changed & 16;
    next_return(layers.place.code(), changed, time_changed);
    const unsigned level = std::min(number_ > of_ ? number_ - of_ : of_ - number_, 7u);
    const unsigned single = of_ == 1;
    next_place(layers.place.code(), 2u * kReturnKind[of_][number_] + time_changed, single);
    if (!layers.height.empty()) {
      const unsigned k = (dx_.correction_bits() + dy_.correction_bits()) / 2;
      last_.z = z_.next(layers.height.code(), heights_[level], single + (k < 18 ? k & ~1u : 18));
      heights_[level] = last_.z;
    }
    if (!layers.cls.empty()) {
      const bool only = number_ == 1 && number_ >= of_;
      const std::size_t like = (last_.cls & 31u) * 2 + only;
      last_.cls = static_cast<std::uint8_t>(layers.cls.code().symbol(classes_[like]));
    }
    time_changed_ = time_changed;
  }

 private:
  void next_return(RangeDecoder& code, unsigned changed, bool time_changed) {
    if (changed & 4) of_ = code.symbol(ofs_[of_]);
    switch (changed & 3) {
      case 1:
        number_ = (number_ + 1) & 15;
        break;
      case 2:
        number_ = (number_ + 15) & 15;
        break;
      case 3:
        number_ = time_changed ? code.symbol(numbers_[number_])
                               : (number_ + code.symbol(number_steps_) + 2) & 15;
        break;
      default:
        break;
    }
  }

  void next_place(RangeDecoder& code, unsigned kind, unsigned single) {
    const std::int32_t dx = dx_.next(code, x_steps_[kind].get(), single);
    x_steps_[kind].add(dx);
    last_.x = wrapped_sum(last_.x, dx);
    const unsigned k = dx_.correction_bits();
    const std::int32_t dy = dy_.next(code, y_steps_[kind].get(), single + (k < 20 ? k & ~1u : 20));
    y_steps_[kind].add(dy);
    last_.y = wrapped_sum(last_.y, dy);
  }

  static std::vector<SymbolModel> models(std::size_t count, unsigned symbols) {
    return std::vector<SymbolModel>(count, SymbolModel(symbols));
  }

  LazPoint last_;
  unsigned number_;
  unsigned of_;
  bool time_changed_ = false;
  std::vector<SymbolModel> changed_ = models(8, 128);
  SymbolModel channel_{3};
  std::vector<SymbolModel> ofs_ = models(16, 16);
  std::vector<SymbolModel> numbers_ = models(16, 16);
  SymbolModel number_steps_{13};
  std::vector<SymbolModel> classes_ = models(64, 256);
  IntegerDecoder dx_{32, 2};
  IntegerDecoder dy_{32, 22};
  IntegerDecoder z_{32, 20};
  std::array<StreamingMedian, 12> x_steps_;
  std::array<StreamingMedian, 12> y_steps_;
  std::array<std::int32_t, 8> heights_;
};

// The four channels; one begins with the last point of the one before it.
class Channels {
 public:
  Channels(const LazPoint& first, std::span<const unsigned char> raw) : now_(raw[kFlags] >> 4 & 3) {
    channels_[now_].emplace(first, raw[kReturns]);
  }

  const LazPoint& next(Layers& layers) {
    const unsigned changed = channels_[now_]->what_changed(layers.place.code());
    if (changed & 64) {
      const unsigned before = now_;
      now_ = (now_ + channels_[before]->other_channel(layers.place.code())) & 3;
      if (!channels_[now_]) {
        channels_[now_].emplace(channels_[before]->last(), channels_[before]->returns());
      }
    }
    channels_[now_]->next(layers, changed);
    return channels_[now_]->last();
  }

 private:
  std::array<std::optional<Channel>, 4> channels_;
  unsigned now_;
};

}  // namespace

LazLayers read_laz_layers(ByteSource& bytes, const LazSetup& setup, std::uint64_t at_most) {
  LazLayers out;
  bytes.read(setup.point_bytes, out.first);
  out.points = bytes.number<std::uint32_t>();
  if (out.points == 0 || out.points > at_most) {
    bytes.refuse({.says = fmt::format(
                      "a chunk of compressed points says that it holds {}, and 1 to {} are left",
                      out.points, at_most)});
  }
  std::vector<std::uint32_t> sizes;
  for (const LazItem& item : setup.items) {
    for (std::size_t i = layers_of(item); i > 0; --i) {
      sizes.push_back(bytes.number<std::uint32_t>());
    }
  }
  for (std::size_t i = 0; i < out.layers.size(); ++i) {
    out.layers[i].at = bytes.position();
    bytes.read(sizes[i], out.layers[i].bytes);
  }
  if (sizes[0] == 0) bytes.refuse({.says = "a chunk of compressed points has no layer of places"});
  for (std::size_t i = out.layers.size(); i < sizes.size(); ++i) {
    if (bytes.skip(sizes[i]) < sizes[i]) {
      bytes.refuse({.says = "a chunk of compressed points is cut short"});
    }
  }
  return out;
}

void decode_laz_layers(const LazLayers& chunk, const LazSetup& setup, std::string_view source,
                       const LazPointSink& sink) {
  Layers layers{{chunk.layers[0], source}, {chunk.layers[1], source}, {chunk.layers[2], source}};
  const LazPoint point = first_laz_point(setup, chunk.first);
  Channels channels(point, chunk.first);
  sink(point);
  for (std::uint64_t i = 1; i < chunk.points; ++i) sink(channels.next(layers));
  for (const Layer* layer : {&layers.place, &layers.height, &layers.cls}) layer->require_end();
}

}  // namespace geom
