// Colour scales. All grow steadily in lightness, so they read without colour vision and in print.

const valueStops = ["#3b2f80", "#2f6690", "#2a9d8f", "#8ac45c", "#f6d94c"];

// Distinct colours for labels (after Okabe and Ito), the last for all that have no place here.
const labelColours = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442",
  "#8c8c8c"];

function mixed(stops, share) {
  const at = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
  const i = Math.min(Math.floor(at), stops.length - 2);
  return new THREE.Color(stops[i]).lerp(new THREE.Color(stops[i + 1]), at - i);
}

function fillRamp(texture, stops) {
  const steps = texture.image.width;
  for (let i = 0; i < steps; ++i) {
    const c = mixed(stops, i / (steps - 1));
    texture.image.data.set([c.r * 255, c.g * 255, c.b * 255, 255], i * 4);
  }
  texture.needsUpdate = true;
}

function rampTexture(stops) {
  const texture = new THREE.DataTexture(new Uint8Array(256 * 4), 256, 1, THREE.RGBAFormat);
  texture.minFilter = texture.magFilter = THREE.LinearFilter;
  fillRamp(texture, stops);
  return texture;
}

function heightStops() { return [theme.css("low"), theme.css("middle"), theme.css("high")]; }

function rampLegend(stops, low, high) {
  return [element("div", { class: "ramp", style: `background:linear-gradient(90deg,${stops.join(",")})` }),
    element("div", { class: "ramp-ends" }, element("span", {}, low), element("span", {}, high))];
}

function swatch(colour, kind = "") {
  return element("span", { class: `swatch ${kind}`, style: `background:${colour};--c:${colour}` });
}
