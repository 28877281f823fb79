// The pairs of flights that come nearest to each other, as far as the check refused them and as they were measured.

const listedPairs = 200;

function pairName({ of }) { return of.map(i => motions[i].id).join(" – "); }

// Both are looked at, at their nearest.
function jumpToPair(pair) {
  selection.choosePair(pair);
  clock.play(false);
  clock.set(pair.time);
  stage.view.set("free");
  setCamera("pair");
}

// The nearest, or the one after that which is looked at.
function jumpToNext() {
  const { pairs } = together;
  jumpToPair(pairs[(pairs.indexOf(selection.pair) + 1) % pairs.length]);
}

function checkWords() {
  const { check } = together;
  if (!check) return element("p", { class: "soft" }, "No report of skyway-check --together is here: nothing is proved of pairs.");
  if (check.ok) return element("p", { class: "good" }, `✓ The check proved all ${count(check.pairs, "pair")} apart`);
  const left = check.left_out ? `, and ${count(check.left_out, "flight")} could not be looked at` : "";
  return element("p", { class: "bad" }, `✕ ${decimals(check.refused, 0)} of ${count(check.pairs, "pair")} failed the check${left}`);
}

function pairRow(pair) {
  return element("tr", {}, element("td", {}, element("button", { type: "button", class: "pair", onclick: () => jumpToPair(pair) },
    pair.reason ? element("span", { class: "bad", title: "refused by the check" }, "✕ ") : null, pairName(pair))),
  element("td", {}, metres(pair.distance)), element("td", {}, clockWords(pair.time, 1)));
}

function makePairsPanel() {
  const { pairs } = together, shown = pairs.slice(0, listedPairs);
  const jump = pairs.length ? element("button", { type: "button", class: "main", id: "nearest", onclick: () => jumpToPair(pairs[0]) },
    "Show the nearest pair") : null;
  const rows = shown.map(pairRow);
  selection.follow(() => rows.forEach((row, i) => row.classList.toggle("chosen", shown[i] === selection.pair)));
  return element("div", {}, checkWords(), jump,
    shown.length ? element("table", { class: "pairs" }, element("thead", {}, element("tr", {}, ["pair", "apart",
      together.epoch ? "at, UTC" : "at, s"].map(words => element("th", { scope: "col" }, words)))), element("tbody", {}, rows)) : null,
    element("p", { class: "soft" }, `${count(together.near, "pair")} came within ${metres(together.within)} while both flew` +
      `${pairs.length > shown.length || together.near > pairs.length ? `; the nearest ${decimals(shown.length, 0)} are listed` : ""}. ` +
      "Distances are between reference points, to 1 mm."));
}
