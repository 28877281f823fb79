#include <cstdlib>
#include <iostream>

#include "fuzz/readers.h"
#include "support/json_disagreement.h"

// Of what the fast reader takes, the other must make the same.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (const std::string differs = support::json_disagreement(text); !differs.empty()) {
    std::cerr << differs << '\n';
    std::abort();
  }
  return 0;
}
