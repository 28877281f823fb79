// What the page was made of: numbers as JSON, arrays in one block of base64.

const meta = JSON.parse(document.getElementById("skyway-meta").textContent);

const arrayBytes = (() => {
  const text = atob(document.getElementById("skyway-arrays").textContent);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
})();

const arrayTypes = { f4: Float32Array, u4: Uint32Array, u2: Uint16Array, u1: Uint8Array };

// The array that {at, count, type} names (not copied unless it is packed), or null where there is none.
function arrayOf(reference) {
  if (!reference) return null;
  if (reference.type === "packed") return columnsOf(reference)[0];
  return new arrayTypes[reference.type](arrayBytes, reference.at, reference.count);
}

// The columns of a packed array: differences, their lowest bytes first (bundle.h).
function columnsOf({ at, bytes, count, columns }) {
  const planes = inflated(new Uint8Array(arrayBytes, at, bytes), 4 * count * columns), out = [];
  for (let c = 0; c < columns; ++c) {
    const column = new Uint32Array(count), [a, b, d, e] = [0, 1, 2, 3].map(k => (4 * c + k) * count);
    for (let i = 0, sum = 0; i < count; ++i) {
      const folded = planes[a + i] | planes[b + i] << 8 | planes[d + i] << 16 | planes[e + i] << 24;
      sum = sum + (folded >>> 1 ^ -(folded & 1)) | 0;
      column[i] = sum;
    }
    out.push(column);
  }
  return out;
}

// Boxes of a packed array as low x, y, z, high x, y, z, after one another.
function cornersOf(reference, step) {
  const columns = columnsOf(reference).map(c => new Int32Array(c.buffer)), out = new Float32Array(6 * reference.count);
  for (let i = 0; i < reference.count; ++i) {
    for (let k = 0; k < 3; ++k) {
      const low = columns[k][i];
      out[6 * i + k] = low * step;
      out[6 * i + 3 + k] = (low + columns[k + 3][i]) * step;
    }
  }
  return out;
}

// Points of the page are relative to this, in metres east, north and up.
const origin = meta.origin;
