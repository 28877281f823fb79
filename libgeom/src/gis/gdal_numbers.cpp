#include "gdal_numbers.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "gdal_content.h"
#include "gdal_sql.h"
#include "gdal_whole.h"
#include "geom/import/building_height.h"
#include "geom/text/text_table.h"
#include "text/json_outline.h"
#include "text/xml_events.h"

namespace geom::gis {
namespace {

bool tells_height(std::string_view column, const std::string& attribute) {
  constexpr std::array kKeys = {"height",      "building:height",   "est_height",
                                "roof:height", "building:levels",   "roof:levels",
                                "min_height",  "building:min_level"};
  return (!attribute.empty() && is_attribute(column, attribute)) ||
         std::any_of(kKeys.begin(), kKeys.end(),
                     [&](const char* key) { return is_attribute(column, key); });
}

enum class Numbers { none, whole, real };

Numbers numbers_of(OGRFieldDefnH field) {
  const OGRFieldType type = gdal().field_type(field);
  if (type == OFTInteger || type == OFTInteger64) return Numbers::whole;
  return type == OFTReal ? Numbers::real : Numbers::none;
}

[[noreturn]] void refuse(const std::string& name, std::string_view column, Numbers numbers,
                         std::string_view found) {
  throw InputError(
      name,
      {.item = fmt::format("column \"{}\"", column),
       .expected = numbers == Numbers::whole ? "whole numbers" : "numbers",
       .found = in_quotes(std::string(found.substr(0, 40))),
       .advice = "GDAL would read a part of it or nothing; correct it, or make the column one "
                 "of text"});
}

// Digits, and perhaps a point with zeros: of all else GDAL would read a part as a whole number.
bool is_whole(std::string_view text) {
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string_view rest = text.substr(end);
  return end > 0 &&
         (rest.empty() || (rest[0] == '.' && rest.find_first_not_of('0', 1) == rest.npos));
}

// Refuses a value in a column of such numbers that would not be read as it stands.
void require_number(Numbers numbers, std::string_view value, const std::string& name,
                    std::string_view column) {
  const std::string_view text = trimmed(value);
  if (text.empty()) return;
  if (numbers == Numbers::whole ? !is_whole(text) : !parse_number(text))
    refuse(name, column, numbers, text);
}

// Calls f(column, its numbers) for each column of numbers that tells heights.
template <class F>
void for_each_column(OGRLayerH layer, const std::string& attribute, const F& f) {
  const OGRFeatureDefnH definition = gdal().layer_definition(layer);
  for (int i = 0; i < gdal().layer_field_count(definition); ++i) {
    const OGRFieldDefnH field = gdal().layer_field(definition, i);
    const std::string column = gdal().field_name(field);
    const Numbers numbers = numbers_of(field);
    if (numbers != Numbers::none && tells_height(column, attribute)) f(column, numbers);
  }
}

std::string sql_name(std::string_view name) {
  std::string out = "\"";
  for (const char c : name) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + '"';
}

// SQLite keeps whatever it is given in any column.
void require_numbers_of_layer(const DatasetHandle& dataset, OGRLayerH layer,
                              const std::string& attribute, const std::string& name) {
  for_each_column(layer, attribute, [&](const std::string& column, Numbers numbers) {
    const std::string found = first_text_of(
        dataset, fmt::format("SELECT CAST({0} AS TEXT) FROM {1} WHERE typeof({0}) IN ('text', "
                             "'blob') AND trim({0}) <> '' OR {2} AND typeof({0}) = 'real' AND "
                             "{0} <> CAST({0} AS INTEGER) LIMIT 1",
                             sql_name(column), sql_name(gdal().layer_name(layer)),
                             numbers == Numbers::whole ? 1 : 0));
    if (!found.empty()) refuse(name, column, numbers, found);
  });
}

// Without a .csvt all columns are text, which is read with its units.
void require_no_types(OGRLayerH layer, const std::string& attribute, const std::string& name) {
  for_each_column(layer, attribute, [&](const std::string& column, Numbers) {
    throw InputError(name, {.item = fmt::format("column \"{}\"", column),
                            .expected = "text",
                            .found = "numbers, as the .csvt beside it says",
                            .advice = "GDAL would cut what is written there; take the .csvt away"});
  });
}

using Json = nlohmann::json;

void require_numbers_of_esri(const std::string& text, OGRLayerH layer, const std::string& attribute,
                             const std::string& name) {
  constexpr std::size_t kDepth = 4;  // up to the attributes of features
  const std::size_t mark = text.starts_with("\xef\xbb\xbf") ? 3 : 0;
  const Json root = json_outline(std::string_view(text).substr(mark), name, kDepth);
  const Json features = root.value("features", Json::array());
  for_each_column(layer, attribute, [&](const std::string& column, Numbers numbers) {
    for (const Json& feature : features) {
      if (!feature.is_object()) continue;
      const Json attributes = feature.value("attributes", Json());
      if (!attributes.is_object() || !attributes.contains(column)) continue;
      const Json& value = attributes[column];
      if (value.is_null()) continue;
      require_number(numbers, value.is_string() ? value.get<std::string>() : value.dump(), name,
                     column);
    }
  });
}

// What its SimpleData holds, whose types a Schema says.
class KmlNumbers : public XmlHandler {
 public:
  KmlNumbers(const std::map<std::string, Numbers>& columns, const std::string& name)
      : columns_(columns), name_(name) {}

  void begin(const XmlTag& tag) override {
    column_ = tag.name == "SimpleData" ? tag.attribute("name") : "";
    value_.clear();
  }
  void text(std::string_view part) override { value_ += part; }
  void end(std::size_t) override {
    if (const auto known = columns_.find(column_); known != columns_.end()) {
      require_number(known->second, value_, name_, column_);
    }
    column_.clear();
    value_.clear();
  }

 private:
  const std::map<std::string, Numbers>& columns_;
  const std::string& name_;
  std::string column_;
  std::string value_;
};

// dBASE III: a head of 32 bytes, 32 for each column, then rows of text.
struct Column {
  std::string name;
  std::size_t at;  // in a row
  std::size_t size;
  Numbers numbers;
};

std::size_t little(std::string_view bytes, std::size_t at, std::size_t size) {
  std::size_t value = 0;
  for (std::size_t i = size; i-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  }
  return value;
}

std::vector<Column> number_columns(std::string_view head, const std::string& attribute) {
  constexpr std::size_t kEntry = 32;
  std::vector<Column> out;
  std::size_t at = 1;  // behind the mark of what is deleted
  for (std::size_t i = kEntry; i + kEntry <= head.size() && head[i] != '\r'; i += kEntry) {
    const std::string_view entry = head.substr(i, kEntry);
    const std::string_view name = entry.substr(0, 11);
    const bool whole = entry[17] == 0;  // digits behind the point
    const Column column{std::string(name.substr(0, name.find('\0'))), at,
                        static_cast<unsigned char>(entry[16]),
                        whole ? Numbers::whole : Numbers::real};
    at += column.size;
    const bool number = entry[11] == 'N' || entry[11] == 'F';
    if (number && tells_height(column.name, attribute)) out.push_back(column);
  }
  return out;
}

void require_numbers_of_table(const std::string& dbf, const std::string& attribute,
                              const std::string& name) {
  const std::string table = content_of(dbf, name);
  constexpr std::size_t kHead = 32;
  if (table.size() < kHead) return;  // refused already
  const std::size_t rows = little(table, 4, 4);
  const std::size_t first = little(table, 8, 2);
  const std::size_t size = little(table, 10, 2);
  const std::string_view head = std::string_view(table).substr(0, first);
  for (const Column& column : number_columns(head, attribute)) {
    for (std::size_t i = 0; i < rows; ++i) {
      const std::string_view value =
          trimmed(std::string_view(table).substr(first + i * size + column.at, column.size));
      if (!value.starts_with('\0')) require_number(column.numbers, value, name, column.name);
    }
  }
}

}  // namespace

void require_whole_numbers(const DatasetHandle& dataset, const std::string& path,
                           const std::string& attribute, const std::string& name) {
  const std::string_view driver = gdal().driver_name(gdal().driver_of(dataset.get()));
  if (driver == "ESRI Shapefile") {
    const ListHandle files(gdal().files_of(dataset.get()));
    for (char** file = files.get(); file && *file; ++file) {
      if (EQUAL(gdal().extension_of(*file), "dbf")) {
        require_numbers_of_table(*file, attribute, name);
      }
    }
  }
  std::map<std::string, Numbers> columns;
  for (int i = 0; i < gdal().layer_count(dataset.get()); ++i) {
    const OGRLayerH layer = gdal().layer(dataset.get(), i);
    if (driver == "GPKG" || driver == "SQLite") {
      require_numbers_of_layer(dataset, layer, attribute, name);
    }
    if (driver == "CSV") require_no_types(layer, attribute, name);
    if (driver == "ESRIJSON") {
      require_numbers_of_esri(content_of(path, name), layer, attribute, name);
    }
    for_each_column(layer, attribute, [&](const std::string& column, Numbers numbers) {
      columns.emplace(column, numbers);
    });
  }
  if (columns.empty() || (driver != "KML" && driver != "LIBKML")) return;
  for (const std::string& text : kml_texts(path, name)) {
    KmlNumbers handler(columns, name);
    read_xml(text, name, handler);
  }
}

}  // namespace geom::gis
