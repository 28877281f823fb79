// Light or dark: what the system prefers, until the switch says otherwise.

const theme = (() => {
  const system = matchMedia("(prefers-color-scheme: dark)");
  const listeners = [];
  let chosen = null;  // "light", "dark", or null for the system's
  const current = () => chosen || (system.matches ? "dark" : "light");
  const apply = () => {
    document.documentElement.dataset.theme = current();
    byId("theme").textContent = current() === "dark" ? "◐ Light" : "◐ Dark";
    byId("theme").setAttribute("aria-label", `Switch to ${current() === "dark" ? "light" : "dark"} colours`);
    for (const listener of listeners) listener();
  };
  system.addEventListener("change", apply);
  byId("theme").addEventListener("click", () => {
    chosen = current() === "dark" ? "light" : "dark";
    apply();
  });
  apply();
  return {
    current,
    // Calls f now and whenever the colours change.
    follow(f) { listeners.push(f); f(); },
    css(name) { return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim(); },
    colour(name) { return new THREE.Color(this.css(name)); },
  };
})();

const leastContrast = 3;  // of what must be seen against what is behind it (WCAG 2.1, 1.4.11)

function luminanceOf({ r, g, b }) {
  const linear = v => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
  return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
}

// Of two colours, 1 to 21.
function contrastOf(one, other) {
  const [low, high] = [luminanceOf(one), luminanceOf(other)].sort((a, b) => a - b);
  return (high + 0.05) / (low + 0.05);
}
