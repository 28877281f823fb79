// The missions, each with its colour and pattern of line: a legend, and a way to choose one.

const listedMissions = 1000;

function verdictOf(mission) {
  if (!mission.checks.length) return null;
  const ok = mission.checks.every(c => c.ok);
  return element("span", { class: ok ? "good" : "bad", title: ok ? "checked: passed" : "checked: failed" }, ok ? "✓" : "✕");
}

function missionEntry(mission) {
  return element("li", {}, element("button", { type: "button", class: "mission", "data-mission": mission.id,
    onclick: () => selection.choose(mission) }, missionSwatch(mission), element("span", { class: "id" }, mission.id),
  element("span", { class: "note soft" }, mission.note()), verdictOf(mission)));
}

function missionSwatch({ colour, pattern }) {
  return element("span", { class: `swatch line pattern-${pattern}`, style: `--c:var(--${colour})` });
}

function makeMissionList() {
  const shown = missions.slice(0, listedMissions);
  const entries = shown.map(missionEntry);
  const list = element("ul", { class: "missions", "aria-label": "Missions" }, entries);
  selection.follow(() => {
    entries.forEach((entry, i) => entry.firstChild.setAttribute("aria-pressed", String(shown[i] === selection.mission)));
    const entry = selection.mission && entries[selection.mission.index];
    if (!entry) return;
    const top = entry.offsetTop - list.offsetTop;
    if (top < list.scrollTop || top + entry.offsetHeight > list.scrollTop + list.clientHeight) {
      list.scrollTop = top - list.clientHeight / 2;
    }
  });
  const more = missions.length - shown.length;
  return element("section", {}, element("h2", {}, count(missions.length, "mission")), list,
    more ? element("p", { class: "soft" }, `and ${decimals(more, 0)} more: click their lines`) : null);
}
