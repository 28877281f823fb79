#pragma once

// The scripts that follow proofs without any code of Skyway, as every program carries them.

#include <span>
#include <string_view>

namespace cli {

struct VerifyScript {
  std::string_view name;  // "verify_folder.py"
  std::string_view text;
};

std::span<const VerifyScript> verify_scripts();

}  // namespace cli
