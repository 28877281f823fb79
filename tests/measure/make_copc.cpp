// make_copc COUNT MOST FILE: so many made-up points as COPC, of which a cube holds up to MOST.

#include <cstdlib>
#include <fstream>

#include "support/copc_file.h"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const auto number = [&](int i) { return static_cast<std::size_t>(std::atoll(argv[i])); };
  std::ofstream out(argv[3], std::ios::binary);
  out << support::CopcFile::scan(number(1), 1, number(2)).bytes();
  return out ? 0 : 4;
}
