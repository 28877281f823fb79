// Which mission is looked at, and which of its motions is followed and plotted; and which pair of flights, if any.

const selection = (() => {
  const listeners = [];
  let mission = missions[0] || null;
  let motion = mission ? mission.motion(false) : null;
  let pair = null;
  const tell = () => { for (const listener of listeners) listener(); };
  return {
    get mission() { return mission; },
    get motion() { return motion; },
    get pair() { return pair; },
    choose(next) {
      pair = null;
      mission = next;
      motion = next ? next.motion(Boolean(motion && motion.isFlight)) : null;
      tell();
    },
    chooseMotion(next) {
      pair = null;
      motion = next;
      mission = next.mission;
      tell();
    },
    // Of the fleet's pairs: the first of the two is followed and plotted.
    choosePair(next) {
      motion = motions[next.of[0]];
      mission = motion.mission;
      pair = next;
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

function hasPairs() { return Boolean(together) && together.pairs.length > 0; }
