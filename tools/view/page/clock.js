// The time that everything shows.

const clock = (() => {
  const listeners = [];
  const duration = motions.reduce((most, m) => Math.max(most, m.duration), 0);
  let time = 0, playing = false, rate = 1;
  const tell = () => { for (const f of listeners) f(time); };
  return {
    duration,
    get time() { return time; },
    get playing() { return playing; },
    get rate() { return rate; },
    set(t) { time = Math.min(Math.max(t, 0), duration); tell(); },
    setRate(r) { rate = r; tell(); },
    toggle() { this.play(!playing); },
    play(on) {
      if (on && time >= duration) time = 0;
      playing = on && duration > 0;
      tell();
    },
    advance(seconds) {
      if (!playing) return;
      time = Math.min(time + seconds * rate, duration);
      if (time >= duration) playing = false;
      tell();
    },
    follow(f) { listeners.push(f); f(time); },
  };
})();
