#pragma once

// LAZ files of made-up points, in every format and layout, by an encoder of the tests' own.

#include <optional>

#include "support/laz_encoders.h"

namespace support {

// Channels, returns, x and y in one layer, z and classes in two more; the others hold chance.
class LayerEncoder {
 public:
  explicit LayerEncoder(const LazFilePoint& first) : now_(first.channel) {
    channels_[now_].emplace(first);
  }

  void put(const LazFilePoint& p) {
    Channel& before = *channels_[now_];
    const bool other = p.channel != now_;
    if (other && !channels_[p.channel]) channels_[p.channel].emplace(before.last);
    Channel& c = *channels_[p.channel];
    const unsigned step = (p.number - c.last.number) & 15;
    const unsigned how = step == 0 ? 0 : step == 1 ? 1 : step == 15 ? 2 : 3;
    const unsigned changed = how | (p.of != c.last.of) * 4u | p.new_time * 16u | other * 64u;
    const LazFilePoint& last = before.last;
    const unsigned like = (last.number == 1) + (last.number >= last.of) * 2u + last.new_time * 4u;
    place_.symbol(before.changed[like], changed);
    if (other) place_.symbol(before.channel, (p.channel - now_ - 1) & 3);
    if (p.of != c.last.of) place_.symbol(c.ofs[c.last.of], p.of);
    if (how == 3 && p.new_time) place_.symbol(c.numbers[c.last.number], p.number);
    if (how == 3 && !p.new_time) place_.symbol(c.steps, step - 2);
    put_place(c, p);
    now_ = p.channel;
    c.last = p;
  }

  // The three layers; of heights and classes that never change, none.
  std::array<std::string, 3> finish() {
    return {place_.finish(), flat_ ? "" : height_.finish(), one_class_ ? "" : cls_.finish()};
  }

  void leave_out(bool flat, bool one_class) {
    flat_ = flat;
    one_class_ = one_class;
  }

 private:
  struct Channel {
    // Begins with a point of another channel or chunk, after which no time has changed.
    explicit Channel(const LazFilePoint& p) : last(p) {
      last.new_time = false;
      heights.fill(p.z);
    }
    LazFilePoint last;
    std::vector<EncoderModel> changed = std::vector<EncoderModel>(8, EncoderModel(128));
    EncoderModel channel{3};
    std::vector<EncoderModel> ofs = std::vector<EncoderModel>(16, EncoderModel(16));
    std::vector<EncoderModel> numbers = std::vector<EncoderModel>(16, EncoderModel(16));
    EncoderModel steps{13};
    std::vector<EncoderModel> classes = std::vector<EncoderModel>(64);
    IntegerEncoder dx{32, 2}, dy{32, 22}, z{32, 20};
    std::array<EncoderMedian, 12> xs, ys;
    std::array<std::int32_t, 8> heights{};
  };

  static unsigned kind(const LazFilePoint& p) {
    // Rows by the number of returns, columns by the number of the return.
    constexpr const char* kKind[] = {
        "0123453445555555", "1013333333333333", "2124444444433333", "3345444444444444",
        "4344544444444444", "5344454444444444", "3344445444444444", "4344444544444444",
        "4344444454444444", "5344444445444444", "5344444444544444", "5334444444455444",
        "5334444444455544", "5334444444445554", "5334444444444555", "5334444444444455"};
    return static_cast<unsigned>(kKind[p.of][p.number] - '0');
  }

  void put_place(Channel& c, const LazFilePoint& p) {
    const unsigned m = 2 * kind(p) + p.new_time;
    const unsigned one = p.of == 1;
    const std::int32_t dx = minus(p.x, c.last.x);
    const std::int32_t dy = minus(p.y, c.last.y);
    c.dx.put(place_, c.xs[m].v[2], dx, one);
    c.dy.put(place_, c.ys[m].v[2], dy, one + std::min(c.dx.k() / 2 * 2, 20u));
    c.xs[m].add(dx);
    c.ys[m].add(dy);
    const auto level = static_cast<std::size_t>(
        std::min(std::abs(static_cast<int>(p.of) - static_cast<int>(p.number)), 7));
    c.z.put(height_, c.heights[level], p.z, one + std::min((c.dx.k() + c.dy.k()) / 4 * 2, 18u));
    c.heights[level] = p.z;
    cls_.symbol(c.classes[(c.last.cls & 31u) * 2 + (p.number == 1 && p.of <= 1)], p.cls);
  }

  unsigned now_;
  std::array<std::optional<Channel>, 4> channels_;
  RangeEncoder place_, height_, cls_;
  bool flat_ = false;
  bool one_class_ = false;
};

struct LazFile {
  enum class Layout { one_stream, fixed, varying };
  unsigned format = 0;
  unsigned version = 2;  // of the items; 3 in formats 6 to 10
  Layout layout = Layout::fixed;
  std::uint32_t chunk = 50;         // points; of varying chunks the largest
  std::uint32_t extra = 0;          // bytes a point
  bool table_place_at_end = false;  // as a writer to a pipe leaves it
  double scale = 0.01;
  std::array<double, 3> offset{};
  std::vector<LazFilePoint> points;
  std::vector<std::size_t> sizes;  // of varying chunks, where they are to be these
  std::string leading;             // a record before that of LASzip

  // Points near each other, with a jump now and then.
  static std::vector<LazFilePoint> scan(std::size_t count, std::uint64_t seed, bool modern) {
    Random random(seed);
    std::vector<LazFilePoint> out;
    LazFilePoint p{637000, 849000, 400};
    for (std::size_t i = 0; i < count; ++i) {
      const bool jump = chance(random, 40) == 0;
      const auto step = [&] {
        return jump ? any_int(random) >> 2 : static_cast<std::int32_t>(chance(random, 200)) - 90;
      };
      p.x = step() + (jump ? 0 : p.x);
      p.y = step() + (jump ? 0 : p.y);
      p.z = step() + (jump ? 0 : p.z);
      if (chance(random, 5) == 0) {
        p.cls = static_cast<std::uint8_t>(chance(random, modern ? 256 : 32));
        p.of = chance(random, modern ? 16 : 8);
        p.number = chance(random, modern ? 16 : 8);
        p.channel = modern ? chance(random, 4) : 0;
      }
      p.new_time = modern && i > 0 && chance(random, 3) == 0;
      out.push_back(p);
    }
    return out;
  }

  std::string bytes() const {
    const std::string setup = leading + laszip_record();
    const std::size_t head = header_size();
    std::string out(head, '\0');
    std::memcpy(out.data(), "LASF", 4);
    out[24] = 1;
    out[25] = format >= 6 ? 4 : format >= 4 ? 3 : 2;
    put<std::uint16_t>(out, 94, head);
    put<std::uint32_t>(out, 96, head + setup.size());
    put<std::uint32_t>(out, 100, leading.empty() ? 1 : 2);
    out[104] = static_cast<char>(format | 0x80);
    put<std::uint16_t>(out, 105, record_size());
    put<std::uint32_t>(out, 107, points.size());
    if (format >= 6) put<std::uint64_t>(out, 247, points.size());
    for (std::size_t i = 0; i < 3; ++i) {
      put<double>(out, 131 + 8 * i, scale);
      put<double>(out, 155 + 8 * i, offset[i]);
    }
    out += setup;
    return out + compressed(out.size());
  }

  // Where each chunk is in the file, and its bytes.
  std::vector<std::array<std::size_t, 2>> chunk_places() const {
    std::vector<std::array<std::size_t, 2>> out;
    std::size_t at = header_size() + leading.size() + laszip_record().size() + 8;
    for (std::size_t i = 0, k = 0; i < points.size(); i += chunk_size(i, k++)) {
      out.push_back({at, chunk_of(i, chunk_size(i, k)).size()});
      at += out.back()[1];
    }
    return out;
  }

  std::size_t record_size() const {
    std::size_t size = 0;
    for (const Item& item : items()) size += item.size;
    return size;
  }

 private:
  struct Item {
    std::uint16_t kind, size, version;
  };

  std::size_t header_size() const { return format >= 6 ? 375 : format >= 4 ? 235 : 227; }

  // The points of chunk `number`, which begins with point `i`.
  std::size_t chunk_size(std::size_t i, std::size_t number) const {
    if (!sizes.empty()) return sizes[number];
    const std::size_t most = layout == Layout::fixed ? chunk : 1 + (i * 7 + 3) % chunk;
    return std::min(most, points.size() - i);
  }

  std::vector<Item> items() const {
    const auto v = static_cast<std::uint16_t>(version);
    std::vector<Item> out;
    if (format >= 6) {
      out.push_back({10, 30, 3});
      if (format == 7) out.push_back({11, 6, 3});
      if (format == 8 || format == 10) out.push_back({12, 8, 3});
      if (format >= 9) out.push_back({13, 29, 3});
      if (extra) out.push_back({14, static_cast<std::uint16_t>(extra), 3});
      return out;
    }
    out.push_back({6, 20, v});
    if (format == 1 || format >= 3) out.push_back({7, 8, v});
    if (format == 2 || format == 3 || format == 5) out.push_back({8, 6, v});
    if (format >= 4) out.push_back({9, 29, 1});
    if (extra) out.push_back({0, static_cast<std::uint16_t>(extra), v});
    return out;
  }

  std::string laszip_record() const {
    std::string data(34, '\0');
    put<std::uint16_t>(data, 0, format >= 6 ? 3 : layout == Layout::one_stream ? 1 : 2);
    put<std::uint32_t>(data, 12, layout == Layout::fixed ? chunk : 0xFFFFFFFFu);
    put<std::uint16_t>(data, 32, items().size());
    for (const Item& item : items()) {
      for (const std::uint16_t n : {item.kind, item.size, item.version})
        add<std::uint16_t>(data, n);
    }
    std::string head(54, '\0');
    std::memcpy(head.data() + 2, "laszip encoded", 14);
    put<std::uint16_t>(head, 18, 22204);
    put<std::uint16_t>(head, 20, data.size());
    return head + data;
  }

  std::string compressed(std::size_t at) const {
    if (layout == Layout::one_stream) return chunk_of(0, points.size());
    std::string out(8, '\0');
    std::vector<std::array<std::size_t, 2>> chunks;
    for (std::size_t i = 0; i < points.size(); i += chunks.back()[0]) {
      chunks.push_back({chunk_size(i, chunks.size()), out.size()});
      out += chunk_of(i, chunks.back()[0]);
      chunks.back()[1] = out.size() - chunks.back()[1];
    }
    const std::size_t place = at + out.size();
    put<std::uint64_t>(out, 0, table_place_at_end ? ~std::uint64_t{0} : place);
    add<std::uint32_t>(out, 0);
    add<std::uint32_t>(out, chunks.size());
    RangeEncoder code;
    IntegerEncoder number(32, 2);
    std::array<std::size_t, 2> last{};
    for (const auto& c : chunks) {
      if (layout == Layout::varying) {
        number.put(code, static_cast<std::int64_t>(last[0]), static_cast<std::int64_t>(c[0]), 0);
      }
      number.put(code, static_cast<std::int64_t>(last[1]), static_cast<std::int64_t>(c[1]), 1);
      last = c;
    }
    if (!chunks.empty()) out += code.finish();
    if (table_place_at_end) add<std::uint64_t>(out, place);
    return out;
  }

  std::string first_record(const LazFilePoint& p) const {
    std::string out(record_size(), '\x5A');
    put<std::int32_t>(out, 0, p.x);
    put<std::int32_t>(out, 4, p.y);
    put<std::int32_t>(out, 8, p.z);
    if (format >= 6) {
      out[14] = static_cast<char>(p.number | p.of << 4);
      out[15] = static_cast<char>(p.channel << 4);
      out[16] = static_cast<char>(p.cls);
    } else {
      out[14] = static_cast<char>(returns_byte(p));
      out[15] = static_cast<char>(p.cls);
      out[17] = 0;
    }
    return out;
  }

  std::string chunk_of(std::size_t begin, std::size_t count) const {
    if (format >= 6) return layers_of(begin, count);
    Random random(begin + 1);
    std::vector<std::unique_ptr<ItemEncoder>> encoders;
    for (const Item& item : items()) {
      if (item.kind == 6) {
        encoders.push_back(std::make_unique<Point10Encoder>(version, points[begin], random));
      } else if (item.kind == 7) {
        encoders.push_back(std::make_unique<GpsTimeEncoder>(version, random));
      } else {
        const char kind = item.kind == 8 ? 'c' : item.kind == 9 ? 'w' : 'b';
        encoders.push_back(std::make_unique<OtherEncoder>(kind, item.version, item.size, random));
      }
    }
    RangeEncoder code;
    for (std::size_t i = begin + 1; i < begin + count; ++i) {
      for (const auto& encoder : encoders) encoder->put(code, points[i]);
    }
    return first_record(points[begin]) + code.finish();
  }

  std::string layers_of(std::size_t begin, std::size_t count) const {
    LayerEncoder encoder(points[begin]);
    bool flat = true;
    bool one_class = true;
    for (std::size_t i = begin + 1; i < begin + count; ++i) {
      flat = flat && points[i].z == points[begin].z;
      one_class = one_class && points[i].cls == points[begin].cls;
      encoder.put(points[i]);
    }
    encoder.leave_out(flat, one_class);
    const std::array<std::string, 3> read = encoder.finish();
    std::vector<std::string> layers(read.begin(), read.end());
    std::size_t others = 6 + extra + (format == 7 || format == 9 ? 1 : format == 8 ? 2 : 0);
    if (format == 10) others += 3;
    for (std::size_t i = 0; i < others; ++i) layers.emplace_back(i % 3 * 7, '\xA5');
    std::string out = first_record(points[begin]);
    add<std::uint32_t>(out, count);
    for (const std::string& layer : layers) add<std::uint32_t>(out, layer.size());
    for (const std::string& layer : layers) out += layer;
    return out;
  }

  template <class T, class V>
  static void put(std::string& to, std::size_t at, V value) {
    const T v = static_cast<T>(value);
    std::memcpy(to.data() + at, &v, sizeof v);
  }

  template <class T, class V>
  static void add(std::string& to, V value) {
    to.resize(to.size() + sizeof(T));
    put<T>(to, to.size() - sizeof(T), value);
  }
};

}  // namespace support
