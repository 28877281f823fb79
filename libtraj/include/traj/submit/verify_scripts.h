#pragma once

// The scripts that follow proofs without any code of Skyway, which a folder for an authority has.
//
// Example:
//   assert(traj::verify_scripts().size() == 3);
//   assert(traj::verify_scripts()[0].name.ends_with(".py"));

#include <span>
#include <string_view>

namespace traj {

struct VerifyScript {
  std::string_view name;  // "verify_folder.py"
  std::string_view text;
};

std::span<const VerifyScript> verify_scripts();

}  // namespace traj
