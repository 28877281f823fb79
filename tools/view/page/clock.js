// The time that everything shows: seconds since the first departure.

const clock = (() => {
  const listeners = [];
  const duration = motions.reduce((most, m) => Math.max(most, m.begin + m.duration), 0);
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

// What a time of the clock is called: by the hour where the records say it, else in seconds after their epoch.
function clockWords(time, digits = 2) {
  const seconds = time + (together ? together.begin : 0);
  const from = together && together.epoch ? Date.parse(together.epoch) : NaN;
  const at = new Date(from + 1000 * seconds);
  return Number.isNaN(at.getTime()) ? decimals(seconds, digits) : `${at.toISOString().slice(11, 21)} UTC`;
}
