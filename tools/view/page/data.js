// What the page was made of: numbers as JSON, arrays in one block of base64.

const meta = JSON.parse(document.getElementById("skyway-meta").textContent);

const arrayBytes = (() => {
  const text = atob(document.getElementById("skyway-arrays").textContent);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
})();

const arrayTypes = { f4: Float32Array, u4: Uint32Array, u2: Uint16Array, u1: Uint8Array };

// The array that {at, count, type} names (not copied), or null where there is none.
function arrayOf(reference) {
  if (!reference) return null;
  return new arrayTypes[reference.type](arrayBytes, reference.at, reference.count);
}

// Points of the page are relative to this, in metres east, north and up.
const origin = meta.origin;
