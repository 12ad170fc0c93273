// LZMA, as of `xz --format=lzma`: what is in the page is a quarter smaller than by the gzip that browsers know.
//
// Range coder, literals by the byte before, matches of length and distance, the last four distances again. After the
// specification in I. Pavlov's LZMA SDK.

const TOP = 1 << 24;
const HALF = 1024;

class RangeCoder {
  constructor(bytes, at) {
    Object.assign(this, { bytes, at, range: 0xffffffff, code: 0 });
    for (let i = 0; i < 5; i++) this.code = ((this.code << 8) | bytes[this.at++]) >>> 0;
  }

  bit(chances, i) {
    const bound = (this.range >>> 11) * chances[i];
    let bit = 0;
    if (this.code < bound) {
      this.range = bound;
      chances[i] += (2048 - chances[i]) >>> 5;
    } else {
      this.range = (this.range - bound) >>> 0;
      this.code = (this.code - bound) >>> 0;
      chances[i] -= chances[i] >>> 5;
      bit = 1;
    }
    this.fill();
    return bit;
  }

  fill() {
    if (this.range < TOP) {
      this.range = (this.range << 8) >>> 0;
      this.code = ((this.code << 8) | this.bytes[this.at++]) >>> 0;
    }
  }

  direct(count) {
    let value = 0;
    for (; count > 0; count--) {
      this.range >>>= 1;
      const bit = this.code >= this.range ? 1 : 0;
      if (bit) this.code = (this.code - this.range) >>> 0;
      value = ((value << 1) | bit) >>> 0;
      this.fill();
    }
    return value;
  }

  tree(chances, offset, bits) {
    let node = 1;
    for (let i = 0; i < bits; i++) node = (node << 1) | this.bit(chances, offset + node);
    return node - (1 << bits);
  }

  reversed(chances, offset, bits) {
    let [node, value] = [1, 0];
    for (let i = 0; i < bits; i++) {
      const bit = this.bit(chances, offset + node);
      node = (node << 1) | bit;
      value |= bit << i;
    }
    return value;
  }
}

const chances = (count) => new Uint16Array(count).fill(HALF);

/** Lengths from 2: eight short ones, eight longer, 256 long. */
class Lengths {
  constructor() {
    Object.assign(this, { choice: chances(2), short: chances(16 << 3), middle: chances(16 << 3), long: chances(256) });
  }

  read(coder, place) {
    if (!coder.bit(this.choice, 0)) return 2 + coder.tree(this.short, place << 3, 3);
    if (!coder.bit(this.choice, 1)) return 10 + coder.tree(this.middle, place << 3, 3);
    return 18 + coder.tree(this.long, 0, 8);
  }
}

/** The bytes that were packed. */
export function unpackedLzma(bytes) {
  const header = new DataView(bytes.buffer, bytes.byteOffset);
  let properties = bytes[0];
  const lc = properties % 9;
  properties = Math.floor(properties / 9);
  const [lp, pb] = [properties % 5, Math.floor(properties / 5)];
  const size = header.getUint32(5, true);
  const out = new Uint8Array(size);
  const coder = new RangeCoder(bytes, 13);
  const literals = chances(0x300 << (lc + lp));
  const [isMatch, isLongAgain] = [chances(12 << 4), chances(12 << 4)];
  const [isAgain, isFirst, isSecond, isThird] = [chances(12), chances(12), chances(12), chances(12)];
  const [lengths, lengthsAgain] = [new Lengths(), new Lengths()];
  const [slots, near, aligned] = [chances(4 << 6), chances(128), chances(16)];
  let [last, second, third, fourth, state, at] = [0, 0, 0, 0, 0, 0];

  const literal = () => {
    const before = at > 0 ? out[at - 1] : 0;
    const base = 0x300 * (((at & ((1 << lp) - 1)) << lc) + (before >>> (8 - lc)));
    let symbol = 1;
    if (state >= 7) {
      let match = out[at - last - 1];
      while (symbol < 0x100) {
        const wanted = (match >>> 7) & 1;
        match <<= 1;
        const bit = coder.bit(literals, base + ((1 + wanted) << 8) + symbol);
        symbol = (symbol << 1) | bit;
        if (wanted !== bit) break;
      }
    }
    while (symbol < 0x100) symbol = (symbol << 1) | coder.bit(literals, base + symbol);
    out[at++] = symbol & 0xff;
    state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
  };

  const distance = (length) => {
    const slot = coder.tree(slots, Math.min(length - 2, 3) << 6, 6);
    if (slot < 4) return slot;
    const bits = (slot >>> 1) - 1;
    const base = ((2 | (slot & 1)) << bits) >>> 0;
    if (slot < 14) return base + coder.reversed(near, base - slot, bits);
    return (base + ((coder.direct(bits - 4) << 4) >>> 0) + coder.reversed(aligned, 0, 4)) >>> 0;
  };

  while (at < size) {
    const place = at & ((1 << pb) - 1);
    if (!coder.bit(isMatch, (state << 4) + place)) {
      literal();
      continue;
    }
    let length;
    if (!coder.bit(isAgain, state)) {
      [fourth, third, second] = [third, second, last];
      length = lengths.read(coder, place);
      state = state < 7 ? 7 : 10;
      last = distance(length);
      if (last === 0xffffffff) break;
    } else {
      if (!coder.bit(isFirst, state)) {
        if (!coder.bit(isLongAgain, (state << 4) + place)) {
          state = state < 7 ? 9 : 11;
          out[at] = out[at - last - 1];
          at++;
          continue;
        }
      } else if (!coder.bit(isSecond, state)) {
        [last, second] = [second, last];
      } else if (!coder.bit(isThird, state)) {
        [last, second, third] = [third, last, second];
      } else {
        [last, second, third, fourth] = [fourth, last, second, third];
      }
      length = lengthsAgain.read(coder, place);
      state = state < 7 ? 8 : 11;
    }
    for (; length > 0; length--, at++) out[at] = out[at - last - 1];
  }
  return out;
}
