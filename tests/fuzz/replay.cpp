// replay FILE…: feeds each file to the target whole, cut short at 64 places, and with 2,000 seeded
// changes of up to 4 bytes. The stand-in for libFuzzer's main where clang is not at hand.

#include <fstream>
#include <iostream>
#include <iterator>
#include <random>

#include "fuzz/readers.h"

namespace {

void feed(const std::string& bytes) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t inputs = 0;
  for (int i = 1; i < argc; ++i) {
    std::ifstream in(argv[i], std::ios::binary);
    const std::string whole(std::istreambuf_iterator<char>(in), {});
    if (!in.is_open()) return 2;
    feed(whole);
    for (std::size_t k = 0; k < 64; ++k) feed(whole.substr(0, whole.size() * k / 64));
    std::mt19937_64 random(1);
    for (int k = 0; k < 2000 && !whole.empty(); ++k) {
      std::string changed = whole;
      for (std::uint64_t n = random() % 4; n < 4; ++n)
        changed[random() % changed.size()] = static_cast<char>(random());
      feed(changed);
    }
    ++inputs;
  }
  std::cout << inputs << " inputs replayed\n";
  return inputs > 0 ? 0 : 2;
}
