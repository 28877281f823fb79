#include "gdal_numbers.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "gdal_sql.h"
#include "gdal_whole.h"
#include "geom/import/building_height.h"
#include "geom/text/text_table.h"

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

[[noreturn]] void refuse(const std::string& name, std::string_view column, std::string_view found) {
  throw InputError(
      name,
      {.item = fmt::format("column \"{}\"", column),
       .expected = "numbers",
       .found = in_quotes(std::string(found.substr(0, 40))),
       .advice = "GDAL would read a part of it or nothing; correct it, or make the column one "
                 "of text"});
}

bool is_number_column(OGRFieldDefnH field) {
  const OGRFieldType type = gdal().field_type(field);
  return type == OFTInteger || type == OFTInteger64 || type == OFTReal;
}

std::string quoted(std::string_view name) {
  std::string out = "\"";
  for (const char c : name) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + '"';
}

// SQLite keeps whatever it is given in any column.
void require_numbers_of_layer(const DatasetHandle& dataset, OGRLayerH layer,
                              const std::string& attribute, const std::string& name) {
  const OGRFeatureDefnH definition = gdal().layer_definition(layer);
  for (int i = 0; i < gdal().layer_field_count(definition); ++i) {
    const OGRFieldDefnH field = gdal().layer_field(definition, i);
    const std::string column = gdal().field_name(field);
    if (!is_number_column(field) || !tells_height(column, attribute)) continue;
    const std::string found = first_text_of(
        dataset, fmt::format("SELECT CAST({0} AS TEXT) FROM {1} WHERE typeof({0}) IN ('text', "
                             "'blob') AND trim({0}) <> '' LIMIT 1",
                             quoted(column), quoted(gdal().layer_name(layer))));
    if (!found.empty()) refuse(name, column, found);
  }
}

// dBASE III: a head of 32 bytes, 32 for each column, then rows of text.
struct Column {
  std::string name;
  std::size_t at;  // in a row
  std::size_t size;
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
    const Column column{std::string(name.substr(0, name.find('\0'))), at,
                        static_cast<unsigned char>(entry[16])};
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
      if (!value.empty() && value[0] != '\0' && !parse_number(value)) {
        refuse(name, column.name, value);
      }
    }
  }
}

}  // namespace

void require_whole_numbers(const DatasetHandle& dataset, const std::string& attribute,
                           const std::string& name) {
  const std::string_view driver = gdal().driver_name(gdal().driver_of(dataset.get()));
  if (driver == "ESRI Shapefile") {
    const ListHandle files(gdal().files_of(dataset.get()));
    for (char** file = files.get(); file && *file; ++file) {
      if (EQUAL(gdal().extension_of(*file), "dbf")) {
        require_numbers_of_table(*file, attribute, name);
      }
    }
  }
  if (driver != "GPKG" && driver != "SQLite") return;
  for (int i = 0; i < gdal().layer_count(dataset.get()); ++i) {
    require_numbers_of_layer(dataset, gdal().layer(dataset.get(), i), attribute, name);
  }
}

}  // namespace geom::gis
