#pragma once

// The CPU time of the calling thread, in seconds: what a planner took, whoever else is running.

namespace bench {

double cpu_seconds();

}  // namespace bench
