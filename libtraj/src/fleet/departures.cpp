#include "traj/fleet/departures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fleet/neighbours.h"
#include "geom/base/random.h"
#include "geom/base/rounding.h"

namespace traj {
namespace {

constexpr std::size_t kMostMoved = 24;  // flights that make way for one

// The first whole millisecond after `time`.
double millisecond_after(double time) {
  double out = std::floor(time * 1000) / 1000;
  for (double i = 1; out <= time; ++i) out = (std::floor(time * 1000) + i) / 1000;
  return out;
}

class Chooser {
 public:
  Chooser(std::span<const FleetFlight> flights, const FleetConflicts& conflicts)
      : flights_(flights), neighbours_(flights.size(), conflicts), start_(flights.size()) {
    for (std::uint32_t i = 0; i < flights.size(); ++i) {
      if (flights[i].number >= ways_.size()) ways_.resize(flights[i].number + 1);
      ways_[flights[i].number].push_back(i);
    }
    way_.resize(ways_.size());
  }

  void place_all() {
    for (const std::uint32_t number : order()) place(number);
  }

  void improve(const DepartureOptions& options, const geom::Execution& run, Departures& out) {
    geom::SplitMix64 random(options.seed);
    const int all = options.improve + options.rescue;
    const auto done = [&](int rounds) {
      if (run.progress)
        run.progress(static_cast<std::size_t>(rounds), static_cast<std::size_t>(all));
    };
    int round = 0;
    while (round < options.improve && improve_once(random, out)) done(++round);
    const std::size_t before = refused();
    for (round = options.improve; round < all && may_rescue(); done(++round)) {
      if (!improve_once(random, out)) break;
    }
    out.rescued = before - refused();
    if (all > 0) done(all);
  }

  std::vector<Departure> result() const {
    std::vector<Departure> out(ways_.size());
    for (std::uint32_t number = 0; number < ways_.size(); ++number) {
      const auto& way = way_[number];
      if (way) {
        out[number] = {start_[*way], *way, {}};
      } else {
        out[number] = {std::nullopt, ways_[number].front(), blockers(number)};
      }
    }
    return out;
  }

  double delay() const {
    double sum = 0;
    for (const auto& way : way_) {
      if (way) sum += *start_[*way] - flights_[*way].earliest;
    }
    return sum;
  }

 private:
  // A round. False where it changes nothing.
  bool improve_once(geom::SplitMix64& random, Departures& out) {
    const std::size_t before = out.moved;
    for (const std::uint32_t number : shuffled(waiting(), random))
      out.moved += bring_forward(number);
    return out.moved > before;
  }

  // Whether one is refused for which others could be moved.
  bool may_rescue() const {
    for (std::uint32_t number = 0; number < ways_.size(); ++number) {
      if (!way_[number] && !to_move(number).empty()) return true;
    }
    return false;
  }

  std::size_t refused() const {
    return static_cast<std::size_t>(std::count(way_.begin(), way_.end(), std::nullopt));
  }

  const FleetFlight& first_of(std::uint32_t number) const {
    return flights_[ways_[number].front()];
  }

  // What is settled, then higher priority first, then as they come.
  std::vector<std::uint32_t> order() const {
    std::vector<std::uint32_t> out(ways_.size());
    std::iota(out.begin(), out.end(), 0u);
    std::stable_sort(out.begin(), out.end(), [&](std::uint32_t a, std::uint32_t b) {
      const FleetFlight& one = first_of(a);
      const FleetFlight& other = first_of(b);
      return one.settled != other.settled ? one.settled : one.priority > other.priority;
    });
    return out;
  }

  // When a flight must not depart, for the map and for all that have a departure.
  std::vector<DepartureSpan> closed(std::uint32_t flight) const {
    std::vector<DepartureSpan> out = flights_[flight].forbidden;
    neighbours_.each(flight, [&](std::uint32_t other, const DepartureSpan& span) {
      if (start_[other]) out.push_back(after(*start_[other], span));
      return true;
    });
    return united(std::move(out));
  }

  static DepartureSpan after(double start, const DepartureSpan& span) {
    return {geom::next_down(start + span.low), geom::next_up(start + span.high)};
  }

  std::optional<double> earliest(std::uint32_t flight) const {
    double start = flights_[flight].earliest;
    if (flights_[flight].settled) return start;
    for (const DepartureSpan& span : closed(flight)) {
      if (span.low > start) break;
      if (span.high < start) continue;
      if (span.high >= flights_[flight].latest) return std::nullopt;
      start = millisecond_after(span.high);
    }
    return start <= flights_[flight].latest ? std::optional(start) : std::nullopt;
  }

  bool place(std::uint32_t number) {
    for (const std::uint32_t flight : ways_[number]) {
      start_[flight] = earliest(flight);
      if (!start_[flight]) continue;
      way_[number] = flight;
      return true;
    }
    return false;
  }

  void take_out(std::uint32_t number) {
    if (way_[number]) start_[*way_[number]].reset();
    way_[number].reset();
  }

  // Flights with a departure that is too near one that this flight could have.
  std::vector<std::uint32_t> in_the_way(std::uint32_t flight) const {
    std::vector<std::uint32_t> out;
    const double from = flights_[flight].earliest;
    const double until = start_[flight].value_or(flights_[flight].latest);
    neighbours_.each(flight, [&](std::uint32_t other, const DepartureSpan& span) {
      if (!start_[other]) return true;
      const DepartureSpan at = after(*start_[other], span);
      if (at.low > until || at.high < from) return true;
      out.push_back(other);
      return false;  // no more of this one
    });
    return out;
  }

  std::vector<std::uint32_t> blockers(std::uint32_t number) const {
    std::vector<std::uint32_t> out;
    for (const std::uint32_t flight : ways_[number]) {
      const auto more = in_the_way(flight);
      out.insert(out.end(), more.begin(), more.end());
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  std::vector<std::uint32_t> waiting() const {
    std::vector<std::uint32_t> out;
    for (std::uint32_t number = 0; number < ways_.size(); ++number) {
      const auto& way = way_[number];
      if (!way || *start_[*way] > flights_[*way].earliest || *way != ways_[number].front()) {
        out.push_back(number);
      }
    }
    return out;
  }

  static std::vector<std::uint32_t> shuffled(std::vector<std::uint32_t> numbers,
                                             geom::SplitMix64& random) {
    for (std::size_t i = numbers.size(); i > 1; --i) {
      const auto k = static_cast<std::size_t>(random.whole(0, static_cast<int>(i) - 1));
      std::swap(numbers[i - 1], numbers[std::min(k, i - 1)]);
    }
    return numbers;
  }

  struct Kept {
    std::uint32_t number;
    std::optional<std::uint32_t> way;
    std::optional<double> start;
  };

  // What some cost together: one without a departure more than any that go another way, one of
  // these more than any delay.
  struct Cost {
    std::size_t refused = 0;
    std::size_t other_ways = 0;
    double delay = 0;

    friend auto operator<=>(const Cost&, const Cost&) = default;
  };
  void add(std::uint32_t number, Cost& cost) const {
    const auto& way = way_[number];
    if (!way) {
      ++cost.refused;
      return;
    }
    cost.other_ways += *way != ways_[number].front();
    cost.delay += *start_[*way] - flights_[*way].earliest;
  }

  // Those that wait for one of the flights, and may be moved for this priority.
  void add_followers(const std::vector<std::uint32_t>& blockers, int priority,
                     std::vector<std::uint32_t>& out) const {
    for (const std::uint32_t blocker : blockers) {
      neighbours_.each(blocker, [&](std::uint32_t other, const DepartureSpan& span) {
        if (!start_[other] || flights_[other].priority > priority) return true;
        // The other's departure less the blocker's is the span turned about.
        const DepartureSpan closed = after(*start_[blocker], {-span.high, -span.low});
        const bool waits = closed.high >= flights_[other].earliest && closed.low <= *start_[other];
        if (!waits || *start_[other] <= flights_[other].earliest) return true;
        out.push_back(flights_[other].number);
        return false;
      });
    }
  }

  // Who is taken out so that one can go first, in the order in which they come in again: it, those
  // that wait for what is in its way, and what is in its way. Empty where nothing may be moved, or
  // very many.
  std::vector<std::uint32_t> to_move(std::uint32_t number) const {
    const std::uint32_t flight = way_[number].value_or(ways_[number].front());
    std::vector<std::uint32_t> blockers = in_the_way(flight);
    std::erase_if(blockers, [&](std::uint32_t other) {
      return flights_[other].settled || flights_[other].priority > flights_[flight].priority;
    });
    if (blockers.empty() || blockers.size() > kMostMoved) return {};
    std::vector<std::uint32_t> followers;
    add_followers(blockers, flights_[flight].priority, followers);
    std::sort(followers.begin(), followers.end());
    followers.erase(std::unique(followers.begin(), followers.end()), followers.end());
    std::vector<std::uint32_t> last;
    for (const std::uint32_t other : blockers) last.push_back(flights_[other].number);
    std::erase_if(followers, [&](std::uint32_t one) {
      return one == number || std::find(last.begin(), last.end(), one) != last.end();
    });
    if (followers.size() > kMostMoved) followers.clear();
    std::vector<std::uint32_t> out{number};
    out.insert(out.end(), followers.begin(), followers.end());
    out.insert(out.end(), last.begin(), last.end());
    return out;
  }

  bool bring_forward(std::uint32_t number) {
    const std::vector<std::uint32_t> moved = to_move(number);
    if (moved.empty()) return false;
    std::vector<Kept> kept;
    Cost before;
    for (const std::uint32_t one : moved) {
      const auto& way = way_[one];
      kept.push_back({one, way, way ? start_[*way] : std::nullopt});
      add(one, before);
    }
    for (const std::uint32_t one : moved) take_out(one);
    Cost after;
    for (const std::uint32_t one : moved) {
      place(one);
      add(one, after);
    }
    const bool refuses = std::any_of(kept.begin(), kept.end(),
                                     [&](const Kept& one) { return one.way && !way_[one.number]; });
    if (after < before && !refuses) return true;
    for (const std::uint32_t one : moved) take_out(one);
    for (const Kept& one : kept) {
      way_[one.number] = one.way;
      if (one.way) start_[*one.way] = one.start;
    }
    return false;
  }

  std::span<const FleetFlight> flights_;
  Neighbours neighbours_;
  std::vector<std::optional<double>> start_;       // by flight
  std::vector<std::vector<std::uint32_t>> ways_;   // by number
  std::vector<std::optional<std::uint32_t>> way_;  // by number
};

}  // namespace

Departures choose_departures(std::span<const FleetFlight> flights, const FleetConflicts& conflicts,
                             const DepartureOptions& options, const geom::Execution& run) {
  Chooser chooser(flights, conflicts);
  chooser.place_all();
  Departures out;
  out.before = chooser.delay();
  chooser.improve(options, run, out);
  out.of = chooser.result();
  return out;
}

std::size_t conflicts_as_asked(std::span<const FleetFlight> flights,
                               const FleetConflicts& conflicts) {
  const auto is_first = [&](std::uint32_t i) {
    return i == 0 || flights[i - 1].number != flights[i].number;
  };
  std::size_t count = 0;
  for (std::size_t k = 0; k < conflicts.pairs.size(); ++k) {
    const auto [a, b] = conflicts.pairs[k];
    if (!is_first(a) || !is_first(b)) continue;
    const double difference = flights[b].earliest - flights[a].earliest;
    const auto spans = conflicts.of(k);
    count += std::any_of(spans.begin(), spans.end(),
                         [&](const DepartureSpan& span) { return span.holds(difference); });
  }
  return count;
}

}  // namespace traj
