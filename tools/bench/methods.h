#pragma once

// The methods that --method may name: those of libplan, and those of OMPL where it is linked.

#include <vector>

#include "plan/bench/method.h"

namespace bench {

std::vector<plan::bench::KnownMethod> methods();

}  // namespace bench
