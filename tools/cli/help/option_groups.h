#pragma once

// In which group of a help text an option stands, and which word stands for its value.

#include <array>
#include <string>
#include <string_view>

namespace cli {

// The groups in the order of a help text. The last one is for options that have no place yet.
inline constexpr std::array kOptionGroups = {"Input",
                                             "Output",
                                             "Vehicle and room",
                                             "Limits",
                                             "Drone and place",
                                             "Flights together",
                                             "Boxes",
                                             "Search and solver",
                                             "Simulated flight",
                                             "Picture",
                                             "How it runs",
                                             "Other"};

struct OptionPlace {
  std::string group;  // one of kOptionGroups
  std::string word;   // such as METRES; empty: the option's type says enough
};

// `tool` is "skyway-check", `option` is "--margin".
OptionPlace place_of_option(std::string_view tool, std::string_view option);

}  // namespace cli
