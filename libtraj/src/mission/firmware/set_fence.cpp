#include "set_fence.h"

#include <algorithm>
#include <optional>

#include "geom/base/error.h"

namespace traj {
namespace {

struct Values {
  const AutopilotSettings& settings;

  double operator()(const char* name, double usual) const {
    const auto found = settings.values.find(name);
    return found == settings.values.end() ? usual : found->second;
  }
};

}  // namespace

void set_ardupilot_fence(const AutopilotSettings& settings, Autopilot& out) {
  const Values value{settings};
  constexpr unsigned kHighest = 1;  // bits of FENCE_TYPE
  constexpr unsigned kCircle = 2;
  constexpr unsigned kLowest = 8;
  const auto type = static_cast<unsigned>(std::clamp(value("FENCE_TYPE", 7), 0.0, 255.0));
  const bool enabled = value("FENCE_ENABLE", 0) != 0;
  const bool may_be = value("FENCE_AUTOENABLE", 0) != 0;  // by the firmware, in flight
  const bool acts = value("FENCE_ACTION", 1) != 0;
  const auto set = [&](std::optional<double>& limit, unsigned bit, const char* name, double usual) {
    limit = acts && (type & bit) != 0 ? std::optional(value(name, usual)) : std::nullopt;
  };
  ParameterFence& fence = out.switched_fence;
  set(fence.top, kHighest, "FENCE_ALT_MAX", 100);
  set(fence.bottom, kLowest, "FENCE_ALT_MIN", -10);
  set(fence.across, kCircle, "FENCE_RADIUS", 300);
  fence.return_ceiling.reset();
  if ((type & kHighest) != 0) {
    fence.return_ceiling = std::max(0.0, value("FENCE_ALT_MAX", 100) - value("FENCE_MARGIN", 2));
  }
  out.rally_in_fence = enabled || may_be;
  if (!out.rally_in_fence) return;
  out.fence = fence;
  if (enabled || !fence.return_ceiling) return;
  out.returns_home = false;
  out.fence.return_ceiling.reset();
}

void set_px4_fence(const AutopilotSettings& settings, std::string_view source, Autopilot& out) {
  const Values value{settings};
  // Until 1.14 an item that is higher is flown no higher (MissionBlock::mission_apply_limitation).
  if (const double most = value("LNDMC_ALT_MAX", -1); most > 0) {
    out.highest_item = most;
    out.fence.return_ceiling = most;
  }
  if (value("GF_ACTION", 2) < 2) return;
  if (value("GF_PREDICT", 0) != 0) {
    const double across = std::max(value("MPC_ACC_HOR_MAX", 5), out.acceleration);
    const double up = std::max(value("MPC_ACC_UP_MAX", 4), value("MPC_ACC_DOWN_MAX", 3));
    const double slows = value("MPC_ACC_DOWN_MAX", 3);
    if (!(across > 0 && up > 0 && slows > 0)) {
      throw geom::InputError(
          source, {.expected = "MPC_ACC_HOR_MAX, MPC_ACC_UP_MAX and MPC_ACC_DOWN_MAX above 0",
                   .found = "0 or less"});
    }
    out.foresight = Foresight{across, up, slows};
  }
  if (const double most = value("GF_MAX_VER_DIST", 0); most > 0) out.fence.top = most;
  if (const double most = value("GF_MAX_HOR_DIST", 0); most > 0) out.fence.across = most;
}

}  // namespace traj
