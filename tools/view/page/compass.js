// Where north is in the view.

function showCompass(heading) {
  const compass = byId("compass");
  if (!compass.firstChild) {
    compass.innerHTML = '<svg viewBox="-24 -24 48 48" width="48" height="48"><circle r="22" fill="var(--panel)" ' +
      'stroke="var(--line)"/><g><path d="M0-10 4 4 0 1-4 4Z" fill="var(--bad)"/><path d="M0 16 4 4 0 1-4 4Z" fill="var(--soft)"/>' +
      '<text y="-12" text-anchor="middle" font-size="9" font-weight="700" fill="var(--ink)">N</text></g></svg>';
  }
  compass.querySelector("g").setAttribute("transform", `rotate(${(-heading * 180 / Math.PI).toFixed(1)})`);
  const degree = ((heading * 180 / Math.PI) % 360 + 360) % 360;
  compass.setAttribute("aria-label", `Compass: looking towards ${decimals(degree, 0)} degrees from north`);
}
