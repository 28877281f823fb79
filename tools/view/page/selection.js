// Which mission is looked at, and which of its motions is followed and plotted.

const selection = (() => {
  const listeners = [];
  let mission = missions[0] || null;
  let motion = mission ? mission.motion(false) : null;
  const tell = () => { for (const listener of listeners) listener(); };
  return {
    get mission() { return mission; },
    get motion() { return motion; },
    choose(next) {
      mission = next;
      motion = next ? next.motion(Boolean(motion && motion.isFlight)) : null;
      tell();
    },
    chooseMotion(next) {
      motion = next;
      mission = next.mission;
      tell();
    },
    // The mission `step` places further in the list.
    step(step) {
      if (mission) this.choose(missions[(mission.index + step + missions.length) % missions.length]);
    },
    // Calls f now and whenever another is chosen.
    follow(f) { listeners.push(f); f(); },
  };
})();
