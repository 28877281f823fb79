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

// Metres with the digits that matter, without zeros at the end: 4.98, 8.5, 120.
function shortMetres(value) {
  return Number(value.toFixed(value < 10 ? 2 : 1)).toLocaleString("en");
}

function apartWords({ across, up }) {
  return `${shortMetres(across)}${thinSpace}m across, ${shortMetres(up)}${thinSpace}m up`;
}

// Of [across, up], or of [east–west or x, north–south or y, up] where a box was asked: either is enough.
function askedWords(asked) {
  const parts = asked.map(v => shortMetres(v) + thinSpace + "m");
  return asked.length === 2 ? `${parts[0]} across or ${parts[1]} up` : `${parts[0]} or ${parts[1]} sideways, or ${parts[2]} up`;
}

// "8.5 m across, 8 m up; 5 or 3 needed"
function pairWords(pair) {
  const asked = pair.asked || (together.check && together.check.asked);
  return apartWords(pair) + (asked ? `; ${asked.map(shortMetres).join(" or ")} needed` : "");
}

function pairRow(pair) {
  return element("tr", {}, element("td", {}, element("button", { type: "button", class: "pair", onclick: () => jumpToPair(pair) },
    pair.reason ? element("span", { class: "bad", title: "not proved apart" }, "✕ ") : null, pairName(pair)),
  element("div", { class: pair.reason ? "bad" : "soft" }, pairWords(pair))), element("td", {}, clockWords(pair.time, 1).replace(" UTC", "")));
}

function makePairsPanel() {
  const { pairs } = together, shown = pairs.slice(0, listedPairs);
  const jump = pairs.length ? element("button", { type: "button", class: "main", id: "nearest", onclick: () => jumpToPair(pairs[0]) },
    "Show the nearest pair") : null;
  const rows = shown.map(pairRow);
  selection.follow(() => rows.forEach((row, i) => row.classList.toggle("chosen", shown[i] === selection.pair)));
  return element("div", {}, sentence(pairsVerdict()), jump,
    shown.length ? element("table", { class: "pairs" }, element("thead", {}, element("tr", {}, ["pair, and how far apart at the nearest",
      together.epoch ? "at, UTC" : "at, s"].map(words => element("th", { scope: "col" }, words)))), element("tbody", {}, rows)) : null,
    element("p", { class: "soft" }, `${count(together.near, "pair")} came within ${metres(together.within)} while both flew` +
      `${pairs.length > shown.length || together.near > pairs.length ? `; the nearest ${decimals(shown.length, 0)} are listed` : ""}. ` +
      "Distances are between reference points."));
}
