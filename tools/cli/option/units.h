#pragma once

// Units of length by the names that options give them.

#include <map>
#include <string>

namespace cli {

// Metres in each.
inline const std::map<std::string, double> kMetres = {{"m", 1},
                                                      {"km", 1000},
                                                      {"cm", 0.01},
                                                      {"mm", 0.001},
                                                      {"ft", 0.3048},
                                                      {"in", 0.0254},
                                                      {"us-ft", 1200.0 / 3937}};

}  // namespace cli
