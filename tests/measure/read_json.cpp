// read_json FILE: parses a JSON file as the readers do, looks at every value, and says how many
// there were: the peer of skyway-footprints for CityJSON in source_growth.py.

#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "geom/text/parse_json.h"

namespace {

struct Seen {
  std::size_t values = 0;
  double sum = 0;

  void look_at(const nlohmann::json& value) {
    ++values;
    if (value.is_number()) sum += value.get<double>();
    if (value.is_string()) sum += static_cast<double>(value.get_ref<const std::string&>().size());
    if (!value.is_structured()) return;
    for (const nlohmann::json& part : value) look_at(part);
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::ifstream file(argv[1], std::ios::binary);
  if (!file) return 3;
  Seen seen;
  seen.look_at(geom::parse_json(file, argv[1]));
  std::cout << seen.values << " values, their sum " << seen.sum << '\n';
  return 0;
}
