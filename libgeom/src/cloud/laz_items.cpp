#include "laz_items.h"

#include <array>

#include "integer_decoder.h"
#include "laz_gps_time.h"
#include "laz_point10.h"
#include "point_chunks.h"

namespace geom {
namespace {

using Kind = LazItem::Kind;

class RgbVersion1 : public LazItemDecoder {
 public:
  void next(RangeDecoder& code, LazPoint&) override {
    const unsigned changed = code.symbol(changed_);
    for (unsigned i = 0; i < 6; ++i) {
      if (changed >> i & 1) byte_.next(code, 0, i);
    }
  }

 private:
  SymbolModel changed_{64};
  IntegerDecoder byte_{8, 6};
};

class RgbVersion2 : public LazItemDecoder {
 public:
  void next(RangeDecoder& code, LazPoint&) override {
    const unsigned changed = code.symbol(changed_);
    const bool grey = !(changed >> 6 & 1);
    for (const unsigned i : {0u, 1u, 2u, 4u, 3u, 5u}) {
      if ((changed >> i & 1) && (i < 2 || !grey)) code.symbol(bytes_[i]);
    }
  }

 private:
  SymbolModel changed_{128};
  std::array<SymbolModel, 6> bytes_;
};

class BytesVersion1 : public LazItemDecoder {
 public:
  explicit BytesVersion1(unsigned count) : count_(count), byte_(8, count) {}
  void next(RangeDecoder& code, LazPoint&) override {
    for (unsigned i = 0; i < count_; ++i) byte_.next(code, 0, i);
  }

 private:
  unsigned count_;
  IntegerDecoder byte_;
};

class BytesVersion2 : public LazItemDecoder {
 public:
  explicit BytesVersion2(std::size_t count) : bytes_(count) {}
  void next(RangeDecoder& code, LazPoint&) override {
    for (SymbolModel& byte : bytes_) code.symbol(byte);
  }

 private:
  std::vector<SymbolModel> bytes_;
};

class WavePacket : public LazItemDecoder {
 public:
  void next(RangeDecoder& code, LazPoint&) override {
    code.symbol(index_);
    offset_kind_ = code.symbol(offset_kinds_[offset_kind_]);
    if (offset_kind_ == 2) offset_.next(code, 0);
    if (offset_kind_ == 3) {
      code.bits(32);
      code.bits(32);
    }
    size_.next(code, 0);
    place_.next(code, 0);
    for (const unsigned i : {0u, 1u, 2u}) direction_.next(code, 0, i);
  }

 private:
  SymbolModel index_;
  unsigned offset_kind_ = 0;
  std::array<SymbolModel, 4> offset_kinds_{SymbolModel(4), SymbolModel(4), SymbolModel(4),
                                           SymbolModel(4)};
  IntegerDecoder offset_{32};
  IntegerDecoder size_{32};
  IntegerDecoder place_{32};
  IntegerDecoder direction_{32, 3};
};

std::unique_ptr<LazItemDecoder> decoder(const LazItem& item, const LazPoint& first,
                                        std::span<const unsigned char> raw) {
  const bool old = item.version == 1;
  switch (item.kind) {
    case Kind::point10:
      return point10_decoder(item.version, first, raw);
    case Kind::gps_time:
      return gps_time_decoder(item.version);
    case Kind::rgb:
      if (old) return std::make_unique<RgbVersion1>();
      return std::make_unique<RgbVersion2>();
    case Kind::byte:
      if (old) return std::make_unique<BytesVersion1>(item.size);
      return std::make_unique<BytesVersion2>(item.size);
    case Kind::wave_packet:
      return std::make_unique<WavePacket>();
    default:
      return nullptr;  // parse_laz_setup lets none of the layered ones in
  }
}

}  // namespace

LazPoint first_laz_point(const LazSetup& setup, std::span<const unsigned char> first) {
  const bool layered = setup.layout == LazSetup::Layout::layers;
  return {number_at<std::int32_t>(&first[0]), number_at<std::int32_t>(&first[4]),
          number_at<std::int32_t>(&first[8]),
          layered ? first[16] : static_cast<std::uint8_t>(first[15] & 0x1f)};
}

std::vector<std::unique_ptr<LazItemDecoder>> laz_item_decoders(
    const LazSetup& setup, std::span<const unsigned char> first) {
  const LazPoint point = first_laz_point(setup, first);
  std::vector<std::unique_ptr<LazItemDecoder>> out;
  for (const LazItem& item : setup.items) out.push_back(decoder(item, point, first));
  return out;
}

}  // namespace geom
