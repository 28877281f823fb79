#include "traj/mission/formats/flier.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geom/base/text_stream.h"
#include "geom/base/usage_error.h"
#include "traj/mission/firmware/autopilot_settings.h"

namespace traj {
namespace {

Vec3 box_of(const std::optional<Uncertainty>& value) {
  const Uncertainty u = value.value_or(Uncertainty{});
  return {u.across, u.across, u.vertical};
}

}  // namespace

std::optional<double> Flier::return_height(const std::optional<double>& asked) const {
  constexpr double kSame = 0.01;  // m: what parameters in centimetres keep
  if (asked && returns_at && std::abs(*asked - *returns_at) > kSame) {
    throw geom::UsageError(fmt::format(
        "--return-height is {:g} m, and the autopilot's parameters say {:g} m, at which "
        "it returns: leave the option out, or give the parameters that it will have",
        *asked, *returns_at));
  }
  if (returns_at) return returns_at;
  return asked || !exactly ? asked : std::optional(exactly->return_height);
}

MissionRules Flier::rules(MissionRules rules) const {
  rules.autopilots = autopilots;
  if (!exactly) return rules;
  if (!rules.acceptance) rules.acceptance = exactly->acceptance;
  if (!rules.speed) rules.speed = exactly->speed;
  rules.braking = std::min(rules.braking, exactly->acceleration);
  rules.return_height = return_height(rules.return_height);
  return rules;
}

Flier with_autopilots(Flier flier, const AutopilotChoice& choice) {
  auto autopilots = autopilots_of(choice.word);
  if (!autopilots) {
    throw geom::UsageError("--autopilot: expected " + autopilot_words() + ", found \"" +
                           choice.word + '"');
  }
  flier.autopilots = *std::move(autopilots);
  if (choice.parameters) {
    geom::TextInput in(*choice.parameters);
    const auto settings = read_autopilot_settings(in, choice.parameters_name);
    SetAutopilot set = set_autopilot(settings, flier.autopilots, choice.parameters_name);
    flier.autopilots = {set.autopilot};
    flier.exactly = set.autopilot;
    if (set.says_return_height) flier.returns_at = set.autopilot.return_height;
    flier.assumed = std::move(set.assumed);
  }
  if (!choice.drag) return flier;
  for (Autopilot& one : flier.autopilots) set_drag(one, *choice.drag);
  return flier;
}

Vec3 Flier::allowance(bool tracks) const {
  return box_of(navigation) + (tracks ? box_of(tracking) : Vec3(Vec3::Zero()));
}

}  // namespace traj
