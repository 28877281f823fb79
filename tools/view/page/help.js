// What the keys, mouse and fingers do: listed in a window, by the button "?" or the key.

function keyRows() {
  return keys.filter(key => !key.needs || key.needs()).map(({ shown, words }) => element("tr", {},
    element("td", {}, shown.map((cap, i) => [i ? " " : "", element("kbd", {}, cap)]).flat()), element("td", {}, words)));
}

const gestures = [["drag", "turn the view"], ["right drag, Shift + drag", "move the view"], ["wheel", "zoom"],
  ["click a line or a name", "choose that mission"], ["click a box", "say what it is"],
  ["one finger, two fingers", "turn; move and zoom"]];

const help = (() => {
  const box = byId("help");
  const gestureRows = () => gestures.map(([shown, words]) =>
    element("tr", {}, element("td", {}, shown), element("td", {}, words)));
  const table = (title, rows) => element("section", {}, element("h2", {}, title), element("table", {}, element("tbody", {}, rows)));
  const close = element("button", { type: "button", class: "quiet", "aria-label": "Close", onclick: () => box.close() }, "×");
  const fill = () => box.replaceChildren(element("div", { class: "card-head" }, element("h1", {}, "Keys and mouse"), close),
    table("Keys", keyRows()), table("Mouse and touch", gestureRows()));
  box.addEventListener("click", e => { if (e.target === box) box.close(); });
  const toggle = () => {
    if (box.open) return box.close();
    fill();
    box.showModal();
  };
  byId("keys").addEventListener("click", toggle);
  return { toggle };
})();
