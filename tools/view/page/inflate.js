// Raw deflate data (RFC 1951) as they were before they were compressed.

const inflated = (() => {
  // Of lengths of codes: [how many have each length, symbols in the order of their codes].
  const codesOf = lengths => {
    const counts = new Uint16Array(16), next = new Uint16Array(16), symbols = new Uint16Array(lengths.length);
    for (const l of lengths) ++counts[l];
    counts[0] = 0;
    for (let l = 1; l < 15; ++l) next[l + 1] = next[l] + counts[l];
    lengths.forEach((l, symbol) => { if (l) symbols[next[l]++] = symbol; });
    return tableOf(counts, symbols);
  };
  // By the next 15 bits, as they come: symbol and length of the code.
  const tableOf = (counts, symbols) => {
    const table = new Uint16Array(1 << 15);
    let code = 0, index = 0;
    for (let length = 1; length <= 15; ++length, code <<= 1) {
      for (let k = 0; k < counts[length]; ++k, ++code) {
        let turned = 0;
        for (let b = 0; b < length; ++b) turned |= (code >> b & 1) << (length - 1 - b);
        for (let at = turned; at < 1 << 15; at += 1 << length) table[at] = symbols[index] << 4 | length;
        ++index;
      }
    }
    return table;
  };
  const ladder = (first, step, count) => {  // base and extra bits of lengths and distances
    const base = [], extra = [];
    for (let i = 0, at = first; i < count; ++i) {
      extra.push(Math.max(0, (i / step | 0) - 1));
      base.push(at);
      at += 1 << extra[i];
    }
    return { base, extra };
  };
  const lengths = ladder(3, 4, 28), distances = ladder(1, 2, 30);
  lengths.base.push(258);
  lengths.extra.push(0);
  const usual = [Array.from({ length: 288 }, (_, i) => (i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8)), Array(30).fill(5)];
  const order = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];

  return (data, size) => {
    const out = new Uint8Array(size);
    let at = 0, held = 0, bits = 0, end = 0;
    const fill = wanted => { while (bits < wanted) { held |= (at < data.length ? data[at] : 0) << bits; ++at; bits += 8; } };
    const take = wanted => {
      fill(wanted);
      const value = held & ((1 << wanted) - 1);
      held >>>= wanted;
      bits -= wanted;
      return value;
    };
    const symbol = table => {
      fill(15);
      const found = table[held & 32767];
      held >>>= found & 15;
      bits -= found & 15;
      return found >> 4;
    };
    const described = () => {
      const literals = take(5) + 257, far = take(5) + 1, count = take(4) + 4, first = Array(19).fill(0), all = [];
      for (let i = 0; i < count; ++i) first[order[i]] = take(3);
      const codes = codesOf(first);
      while (all.length < literals + far) {
        const s = symbol(codes);
        if (s < 16) all.push(s);
        else for (let n = s === 16 ? 3 + take(2) : s === 17 ? 3 + take(3) : 11 + take(7), v = s === 16 ? all[all.length - 1] : 0; n > 0; --n) all.push(v);
      }
      return [all.slice(0, literals), all.slice(literals)];
    };
    for (let last = false; !last;) {
      last = take(1) === 1;
      const kind = take(2);
      if (kind === 0) {  // stored: from the next whole byte on
        at -= bits >> 3;
        held = bits = 0;
        const n = data[at] | data[at + 1] << 8;
        out.set(data.subarray(at + 4, at + 4 + n), end);
        at += 4 + n;
        end += n;
        continue;
      }
      const [near, far] = (kind === 1 ? usual : described()).map(codesOf);
      for (let s = symbol(near); s !== 256; s = symbol(near)) {
        if (s < 256) { out[end++] = s; continue; }
        const n = lengths.base[s - 257] + take(lengths.extra[s - 257]), d = symbol(far);
        const from = end - distances.base[d] - take(distances.extra[d]);
        for (let k = 0; k < n; ++k) out[end++] = out[from + k];
      }
    }
    return out;
  };
})();
