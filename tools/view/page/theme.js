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
