// How long a metre is at the middle of the view.

function showScale(perPixel) {
  const round = roundDown(perPixel * 120);
  const bar = byId("scale");
  const text = withUnit(round, round < 1 ? 2 : 0, "m");
  bar.style.width = `${round / perPixel}px`;
  if (!bar.firstChild) bar.append(element("span"));
  bar.firstChild.textContent = text;
  bar.setAttribute("aria-label", `Scale at the middle of the view: ${text}`);
}
