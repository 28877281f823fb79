#include <fmt/format.h>
#include <fmt/ranges.h>
#include <liblzf/lzf.h>

#include <iterator>
#include <set>

#include "geom/base/loaded_library.h"
#include "geom/base/text_stream.h"
#include "geom/cloud/cloud_format.h"
#include "geom/cloud/point_cloud.h"
#include "geom/text/beginning.h"
#include "geom/text/counted.h"
#include "geom/text/text_table.h"
#include "moved_comment.h"
#include "point_chunks.h"

// The Point Cloud Library's PCD 0.7.

namespace geom {
namespace {

constexpr std::uint64_t kMostUnpacked = std::uint64_t{1} << 32;
constexpr std::uint64_t kLargestRecord = 1 << 20;  // bytes a point

struct Field {
  std::string name;
  Scalar scalar;
  std::uint64_t count = 1;
  std::uint64_t offset = 0;  // in a point's record

  std::uint64_t bytes() const { return static_cast<std::uint64_t>(scalar.size) * count; }
};

// Bytes that were unpacked; 0 if they are damaged or do not fit. LZF is loaded when it is needed.
unsigned unpacked_lzf(const std::string& from, std::vector<unsigned char>& to) {
  static const LoadedLibrary library(SKYWAY_LZF_SONAME, "liblzf1");
  const auto unpack = SKYWAY_FUNCTION(library, lzf_decompress);
  return unpack(from.data(), static_cast<unsigned>(from.size()), to.data(),
                static_cast<unsigned>(to.size()));
}

class PcdReader {
 public:
  PcdReader(std::istream& in, std::string_view source, const PointSink& sink)
      : in_(in), source_(source), chunks_(source, sink) {}

  CloudCounts read(const ReferenceSink& reference) {
    const std::string data = read_header();
    if (reference) reference(comments_.told());
    if (data == "ascii") {
      read_ascii();
    } else if (data == "binary") {
      read_binary();
    } else if (data == "binary_compressed") {
      read_compressed();
    } else {
      refuse({.expected = "DATA ascii, binary or binary_compressed",
              .found = in_quotes(data.substr(0, 40))});
    }
    return chunks_.finish();
  }

 private:
  [[noreturn]] void refuse(Fault fault) const {
    throw InputError(source_, line_, std::move(fault));
  }

  std::string read_header() {
    std::vector<std::string> names;
    std::vector<std::string> sizes;
    std::vector<std::string> types;
    std::vector<std::string> counts;
    std::string text;
    std::set<std::string> seen;
    while (line_ < 1000 && std::getline(in_, text)) {
      ++line_;
      begin_ += text.size() + 1;
      if (trimmed(text).find('\r') != std::string_view::npos) refuse(lone_return());
      TextInput words(text);
      std::string key;
      words >> key;
      if (key == "COLUMNS") key = "FIELDS";
      if (key.starts_with('#')) {
        comments_.take(trimmed(trimmed(text).substr(1)));
        continue;
      }
      if (!key.empty() && !seen.insert(key).second) {
        refuse({.expected = fmt::format("{} once", key.substr(0, 40)), .found = "it again"});
      }
      const std::vector<std::string> values{std::istream_iterator<std::string>(words), {}};
      if (key == "FIELDS") names = values;
      if (key == "SIZE") sizes = values;
      if (key == "TYPE") types = values;
      if (key == "COUNT") counts = values;
      if (key == "WIDTH") width_ = whole(values, key);
      if (key == "HEIGHT") height_ = whole(values, key);
      if (key == "POINTS") points_ = whole(values, key);
      if (key == "VIEWPOINT") require_plain_viewpoint(values);
      if (key != "DATA") continue;
      make_fields(names, sizes, types, counts);
      return values.empty() ? "" : values[0];
    }
    refuse({.says = "expected a PCD header with FIELDS, SIZE, TYPE and DATA, and it is cut short"});
  }

  // Where the sensor stood: x, y, z, and a quaternion w, x, y, z. Some programs leave the points in
  // the frame of the sensor, which the viewpoint then moves to the world; others write points of
  // the world. Nothing in the file tells which.
  void require_plain_viewpoint(const std::vector<std::string>& values) const {
    constexpr std::size_t kNumbers = 7;
    constexpr std::size_t kW = 3;  // alone, it turns nothing
    bool plain = values.size() == kNumbers;
    for (std::size_t i = 0; i < values.size() && plain; ++i) {
      const auto value = parse_number(values[i]);
      plain = value && (i == kW || *value == 0);
    }
    if (plain) return;
    refuse({.expected = "VIEWPOINT 0 0 0 1 0 0 0",
            .found = in_quotes(fmt::format("{}", fmt::join(values, " ")).substr(0, 80)),
            .advice = "some programs mean that it moves the points, others that it is where the "
                      "sensor stood; move the points if they need it, then write VIEWPOINT 0 0 0 1 "
                      "0 0 0"});
  }

  std::uint64_t whole(const std::vector<std::string>& values, const std::string& key) const {
    const auto value = values.size() == 1 ? parse_number(values[0]) : std::nullopt;
    if (!value || !(*value >= 0 && *value < 0x1p40) || *value != std::floor(*value)) {
      refuse({.key = key,
              .expected = "a whole number",
              .found = in_quotes(values.empty() ? "" : values[0].substr(0, 40))});
    }
    return static_cast<std::uint64_t>(*value);
  }

  void make_fields(const std::vector<std::string>& names, const std::vector<std::string>& sizes,
                   const std::vector<std::string>& types, const std::vector<std::string>& counts) {
    if (names.empty() || sizes.size() != names.size() || types.size() != names.size() ||
        (!counts.empty() && counts.size() != names.size())) {
      refuse(
          {.says =
               "FIELDS, SIZE, TYPE and COUNT must have the same number of entries, at least one"});
    }
    if (names.size() > 1000) refuse({.expected = "at most 1000 fields"});
    for (std::size_t i = 0; i < names.size(); ++i) {
      Field field;
      field.name = names[i];
      field.scalar = {types[i][0], static_cast<int>(whole({sizes[i]}, "SIZE"))};
      field.count = counts.empty() ? 1 : whole({counts[i]}, "COUNT");
      field.offset = record_;
      if (!field.scalar.valid() || field.count > 1000000) {
        refuse({.item = fmt::format("field {}", names[i].substr(0, 40)),
                .expected = "TYPE F, I or U of 1, 2, 4 or 8 bytes",
                .found = fmt::format("{} {}", types[i].substr(0, 4), sizes[i].substr(0, 8))});
      }
      record_ += field.bytes();
      if (record_ > kLargestRecord) {
        refuse({.expected = fmt::format("at most {} bytes a point", kLargestRecord),
                .found = fmt::format("{} up to field {}", record_, names[i].substr(0, 40))});
      }
      fields_.push_back(std::move(field));
      const std::string& name = fields_.back().name;
      const char letter = static_cast<char>(name[0] | 0x20);  // some write X, Y, Z
      if (name.size() != 1 || letter < 'x' || letter > 'z') continue;
      std::size_t& axis = axis_[letter - 'x'];
      if (axis != SIZE_MAX)
        refuse({.expected = fmt::format("one field {}", letter), .found = "another"});
      axis = i;
    }
    for (int k = 0; k < 3; ++k) {
      if (axis_[k] >= fields_.size() || fields_[axis_[k]].count != 1) {
        refuse({.expected = "the fields x, y and z", .found = "not all of them"});
      }
    }
    const std::uint64_t grid = width_ * height_;
    if (points_ == 0) points_ = grid;
    if (grid != 0 && grid != points_) {
      refuse({.key = "POINTS",
              .expected = "WIDTH times HEIGHT",
              .found = fmt::format("{} and {} x {}", points_, width_, height_)});
    }
  }

  void ended(std::uint64_t found) const {
    if (found < points_) {
      refuse({.says = fmt::format("expected {}, and the file ends after {}",
                                  counted(points_, "point"), found)});
    }
  }

  void read_ascii() {
    std::string text;
    std::uint64_t found = 0;
    while (found < points_ && std::getline(in_, text)) {
      ++line_;
      TextInput words(text);
      Vec3 p;
      std::string word;
      bool any = false;
      for (std::size_t i = 0; i < fields_.size(); ++i) {
        for (std::uint64_t k = 0; k < fields_[i].count; ++k) {
          if (!(words >> word)) {
            if (!any) break;
            refuse({.expected = numbers_of_point(), .found = "fewer"});
          }
          any = true;
          for (int axis = 0; axis < 3; ++axis) {
            if (axis_[axis] == i) p[axis] = number(word);
          }
        }
        if (!any) break;
      }
      if (!any) continue;  // an empty line
      if (words >> word) {
        refuse({.expected = numbers_of_point(),
                .found = fmt::format("\"{}\" after them", word.substr(0, 40))});
      }
      chunks_.add(p);
      ++found;
    }
    ended(found);
    if (in_ >> text) more();
  }

  std::string numbers_of_point() const {
    std::uint64_t numbers = 0;
    for (const Field& field : fields_) numbers += field.count;
    return counted(numbers, "number");
  }

  [[noreturn]] void more() const {
    refuse(
        {.says = fmt::format("expected {}, and the file holds more", counted(points_, "point"))});
  }

  double number(const std::string& word) const {
    const auto value = parse_number(word);
    if (!value) refuse({.expected = "a number", .found = in_quotes(word.substr(0, 40))});
    return *value;
  }

  void read_binary() {
    ended(for_each_record(in_, record_, points_, [&](const unsigned char* record) {
      Vec3 p;
      for (int axis = 0; axis < 3; ++axis) {
        const Field& field = fields_[axis_[axis]];
        p[axis] = field.scalar.at(record + field.offset);
      }
      chunks_.add(p);
    }));
    require_end(points_ * record_, record_);
  }

  // After so many bytes of data, less than `most` may follow. PCL writes through a mapping of whole
  // pages, and leaves zeros behind: a page less the header, or up to the end of a page.
  void require_end(std::uint64_t data, std::uint64_t most) {
    constexpr std::uint64_t kPage = 4096;
    constexpr std::uint64_t kLargestPage = 65536;
    std::uint64_t behind = 0;
    bool zeros = true;
    for (int c = in_.get(); c != std::char_traits<char>::eof(); c = in_.get()) {
      zeros &= c == 0;
      if (++behind > kLargestPage || (!zeros && behind >= most)) more();
    }
    const bool page = (begin_ + behind) % kPage == 0 || (begin_ + data + behind) % kPage == 0;
    if (behind >= most && !page) more();
  }

  // Sizes, then LZF of the fields one after the other, each with all points.
  void read_compressed() {
    unsigned char sizes[8];
    in_.read(reinterpret_cast<char*>(sizes), 8);
    if (in_.gcount() < 8) refuse({.says = "the compressed data are cut short"});
    const std::uint64_t packed = number_at<std::uint32_t>(sizes);
    const std::uint64_t unpacked = number_at<std::uint32_t>(sizes + 4);
    if (points_ > kMostUnpacked / record_ || unpacked != points_ * record_) {
      refuse({.expected = fmt::format("{} points of {} bytes", points_, record_),
              .found = fmt::format("{} bytes", unpacked)});
    }
    // LZF packs to no less than a 1/264th: what promises more lies, before memory is taken.
    if (unpacked > 264 * packed + 264)
      refuse({.says = "the compressed data are too short for their points"});
    std::string from;
    constexpr std::uint64_t kStep = 1 << 20;
    while (from.size() < packed) {
      const std::size_t at = from.size();
      from.resize(std::min(packed, at + kStep));
      in_.read(from.data() + at, static_cast<std::streamsize>(from.size() - at));
      if (static_cast<std::size_t>(in_.gcount()) < from.size() - at) {
        refuse({.says = "the compressed data are cut short"});
      }
    }
    std::vector<unsigned char> to(unpacked);
    if (unpacked_lzf(from, to) != unpacked && unpacked > 0) {
      refuse({.says = "the compressed data are damaged"});
    }
    for (std::uint64_t i = 0; i < points_; ++i) {
      Vec3 p;
      for (int axis = 0; axis < 3; ++axis) {
        const Field& field = fields_[axis_[axis]];
        p[axis] = field.scalar.at(&to[field.offset * points_ + i * field.bytes()]);
      }
      chunks_.add(p);
    }
    require_end(8 + packed, 1);
  }

  std::istream& in_;
  std::string source_;
  PointChunks chunks_;
  MovedComments comments_;
  std::size_t line_ = 0;
  std::uint64_t begin_ = 0;  // bytes of the header
  std::uint64_t width_ = 0;
  std::uint64_t height_ = 1;
  std::uint64_t points_ = 0;
  std::uint64_t record_ = 0;  // bytes a point
  std::vector<Field> fields_;
  std::size_t axis_[3] = {SIZE_MAX, SIZE_MAX, SIZE_MAX};
};

}  // namespace

CloudCounts read_pcd(std::istream& in, std::string_view source, const PointSink& sink) {
  return PcdReader(in, source, sink).read({});
}

namespace {

CloudCounts read_pcd_cloud(std::istream& in, std::string_view source, const PointSink& sink,
                           const ReferenceSink& reference, const LasReading&) {
  return PcdReader(in, source, sink).read(reference);
}

// The comment that names the format is no part of it.
bool begins_as_pcd(std::string_view head) {
  if (head.starts_with("# .PCD")) return true;
  const std::string_view text = text_of(head).substr(0, 2000);
  return text.find("\nFIELDS ") != text.npos && text.find("\nDATA ") != text.npos;
}

bool may_be_pcd(std::string_view head) {
  return head.substr(0, 2000).find("FIELDS") != head.npos && head.find("DATA") != head.npos;
}

constexpr std::string_view kReaders[] = {"skyway-cloud"};
constexpr Format kPcd{
    .word = "pcd", .what = "a PCD point cloud", .begins = begins_as_pcd, .readers = kReaders};

}  // namespace

constinit const CloudFormat kPcdCloud{
    .format = &kPcd, .may_be = may_be_pcd, .read = read_pcd_cloud};

}  // namespace geom
