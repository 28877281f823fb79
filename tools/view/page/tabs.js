// The panels of the side, one at a time.

// `panels`: [[name, element], …]
function makeTabs(panels) {
  const side = byId("side");
  const bodies = panels.map(([name, inside], i) => {
    inside.classList.add("panel");
    inside.id = `panel-${i}`;
    inside.setAttribute("role", "tabpanel");
    inside.setAttribute("aria-label", name);
    return inside;
  });
  const show = chosen => {
    bodies.forEach((body, i) => { body.hidden = i !== chosen; });
    buttons.forEach((b, i) => {
      b.setAttribute("aria-selected", String(i === chosen));
      b.tabIndex = i === chosen ? 0 : -1;
    });
  };
  const buttons = panels.map(([name], i) => element("button", { type: "button", role: "tab", "aria-controls": `panel-${i}`,
    onclick: () => show(i), onkeydown: e => {
      const step = { ArrowLeft: -1, ArrowRight: 1 }[e.key];
      if (!step) return;
      e.stopPropagation();
      const next = (i + step + panels.length) % panels.length;
      show(next);
      buttons[next].focus();
    } }, name));
  side.append(element("div", { class: panels.length > 5 ? "tabs many" : "tabs", role: "tablist" }, buttons), ...bodies);
  show(0);
  return { show: name => show(panels.findIndex(([n]) => n === name)) };
}
