#include <cstdlib>
#include <iostream>

#include "fuzz/reader.h"
#include "geom/text/xml_element.h"
#include "support/json_disagreement.h"

namespace {

// Of what the fast reader takes, the other must make the same.
void parse_json(std::istream& in) {
  if (const std::string differs = support::json_disagreement(fuzz::rest_of(in)); !differs.empty()) {
    std::cerr << differs << '\n';
    std::abort();
  }
}

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() {
  return {{"parse_json", parse_json},
          {"xml", [](std::istream& in) { geom::parse_xml(fuzz::rest_of(in), "fuzz"); }}};
}
