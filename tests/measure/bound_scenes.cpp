// bound_scenes COUNT [FIRST]: lower bounds on length in so many small random scenes, against a fine
// visibility graph: how many have a detour, how many bounds lie above its length (none may), and
// how near they are. Ends with 1 where one is above.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "plan/bound/bound.h"
#include "plan/detours.h"

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) return 2;
  const auto first = static_cast<std::uint64_t>(argc == 3 ? std::atoll(argv[2]) : 0);
  const std::uint64_t end = first + static_cast<std::uint64_t>(std::atoll(argv[1]));
  std::size_t above = 0;
  std::vector<double> gaps;
  for (std::uint64_t seed = first; seed < end; ++seed) {
    const auto detour = plan::detour_for(seed);
    if (!detour) continue;
    plan::Bounder bounder(detour->scene);
    double bound = 0;
    for (const auto& [length, gap] :
         {std::pair{1.05 * detour->length, 1e-6}, std::pair{detour->length, 1e-3}}) {
      plan::BoundOptions options;
      options.gap = gap;
      options.most = 300'000;
      bound = std::max(bound, bounder.ask(detour->from, detour->to, length, options).bound);
    }
    gaps.push_back(detour->length / bound - 1);
    if (bound <= detour->length) continue;
    ++above;
    fmt::print("seed {}: bound {} above the path of {} m\n", seed, bound, detour->length);
  }
  std::sort(gaps.begin(), gaps.end());
  const auto within = [&](double gap) {
    return std::upper_bound(gaps.begin(), gaps.end(), gap) - gaps.begin();
  };
  fmt::print(
      "{} detours, {} bounds above; within 1e-3 of the path {}, 1e-2 {}, largest gap {:.2e}\n",
      gaps.size(), above, within(1e-3), within(1e-2), gaps.empty() ? 0 : gaps.back());
  return above > 0;
}
