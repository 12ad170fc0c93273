// The solver's module as streams, one of each kind of number in its code: what is alike stands together, and LZMA packs that a
// tenth smaller.
//
// One walk through the module goes both ways: the `Splitter` of `split.mjs` takes each byte from the module and puts it on its
// stream, a `Joiner` takes it from the stream and puts it into the module. Encodings after the WebAssembly Core Specification, chapter 5.

export const STREAMS = 10;
export const [OUTSIDE, DECLARED, OPERATIONS, BRANCHES, CALLS, LOCALS, OFFSETS, SHORTS, LONGS, NUMBERS] = Array(STREAMS).keys();
const CODE = 10;
const [END, BRANCH_TABLE, CALL_INDIRECT, SELECT] = [0x0b, 0x0e, 0x11, 0x1c];
const [SATURATING, VECTOR] = [0xfc, 0xfd];

/** A number of seven bits a byte, without its sign. */
export function number(coder, stream) {
  let byte = coder.byte(stream);
  let value = byte & 0x7f;
  for (let unit = 0x80; byte >= 0x80; unit *= 0x80) {
    byte = coder.byte(stream);
    value += (byte & 0x7f) * unit;
  }
  return value;
}

function copy(coder, stream, count) {
  for (; count > 0; count--) coder.byte(stream);
}

/** Alignment, which follows from the operation, and offset. */
function place(coder) {
  number(coder, OPERATIONS);
  number(coder, OFFSETS);
}

/** What stands behind operations of one byte, each with its first and last. */
const OPERANDS = [
  [0x02, 0x04, (coder) => number(coder, OPERATIONS)],
  [0x0c, 0x0d, (coder) => number(coder, BRANCHES)],
  [BRANCH_TABLE, BRANCH_TABLE, (coder) => {
    for (let count = number(coder, BRANCHES); count >= 0; count--) number(coder, BRANCHES);
  }],
  [0x10, 0x10, (coder) => number(coder, CALLS)],
  [CALL_INDIRECT, CALL_INDIRECT, (coder) => {
    number(coder, CALLS);
    number(coder, OPERATIONS);
  }],
  [SELECT, SELECT, (coder) => copy(coder, OPERATIONS, number(coder, OPERATIONS))],
  [0x20, 0x22, (coder, recent) => coder.local(recent)],
  [0x23, 0x26, (coder) => number(coder, OPERATIONS)],
  [0x28, 0x3e, place],
  [0x3f, 0x40, (coder) => number(coder, OPERATIONS)],
  [0x41, 0x41, (coder) => number(coder, SHORTS)],
  [0x42, 0x42, (coder) => number(coder, LONGS)],
  [0x43, 0x43, (coder) => copy(coder, NUMBERS, 4)],
  [0x44, 0x44, (coder) => copy(coder, NUMBERS, 8)],
  [0xd0, 0xd2, (coder) => number(coder, OPERATIONS)],
  [SATURATING, SATURATING, (coder) => {
    const kind = number(coder, OPERATIONS);
    const operands = kind < 8 ? 0 : [8, 10, 12, 14].includes(kind) ? 2 : 1;
    for (let i = 0; i < operands; i++) number(coder, OPERATIONS);
  }],
  [VECTOR, VECTOR, (coder) => {
    const kind = number(coder, OPERATIONS);
    const isLane = kind >= 84 && kind <= 91;
    if (kind <= 11 || kind === 92 || kind === 93 || isLane) place(coder);
    if (kind === 12 || kind === 13) copy(coder, NUMBERS, 16);
    if (isLane || (kind >= 21 && kind <= 34)) coder.byte(OPERATIONS);
  }],
];

const behind = Array(256);
for (const [first, last, operands] of OPERANDS) behind.fill(operands, first, last + 1);

/** Its locals, then operations until as many blocks have ended as began, and one more. */
function functionOf(coder) {
  for (let groups = number(coder, DECLARED); groups > 0; groups--) {
    number(coder, DECLARED);
    coder.byte(DECLARED);
  }
  const recent = [];
  for (let depth = 1; depth > 0; ) {
    const operation = coder.byte(OPERATIONS);
    if (operation >= 0x02 && operation <= 0x04) depth++;
    if (operation === END) depth--;
    behind[operation]?.(coder, recent);
  }
}

export function walk(coder) {
  copy(coder, OUTSIDE, 8);
  while (!coder.atEnd()) {
    if (coder.byte(OUTSIDE) === CODE) {
      coder.sized(() => {
        for (let count = number(coder, OUTSIDE); count > 0; count--) coder.sized(() => functionOf(coder));
      });
    } else {
      copy(coder, OUTSIDE, number(coder, OUTSIDE));
    }
  }
}

/** A number as its bytes, each handed on. */
export function put(value, byte) {
  for (; value >= 0x80; value = Math.floor(value / 0x80)) byte((value & 0x7f) | 0x80);
  byte(value);
}

/** Locals that were used last are used again: each is told by its place among them, and comes to the front. */
export function toFront(recent, at) {
  const index = recent[at];
  for (; at > 0; at--) recent[at] = recent[at - 1];
  recent[0] = index;
  return index;
}

/** Those never used stand behind, in their order. */
export function grow(recent, least) {
  while (recent.length <= least) recent.push(recent.length);
}

/** From the streams to their module. */
class Joiner {
  constructor(streams, size) {
    Object.assign(this, { streams, module: new Uint8Array(size), at: 0, places: new Uint32Array(STREAMS) });
    this.taken = { byte: (stream) => this.take(stream) };
    this.write = (byte) => (this.module[this.at++] = byte);
  }

  atEnd() {
    return this.places[OUTSIDE] === this.streams[OUTSIDE].length;
  }

  take(stream) {
    return this.streams[stream][this.places[stream]++];
  }

  byte(stream) {
    return (this.module[this.at++] = this.take(stream));
  }

  sized(part) {
    const start = this.at;
    part();
    const size = [];
    put(this.at - start, (byte) => size.push(byte));
    this.module.copyWithin(start + size.length, start, this.at);
    this.module.set(size, start);
    this.at += size.length;
  }

  local(recent) {
    const at = number(this.taken, LOCALS);
    grow(recent, at);
    put(toFront(recent, at), this.write);
  }
}

/** The module that was split. */
export function joined(all) {
  const [size, ...lengths] = new Uint32Array(all.slice(0, 4 * (1 + STREAMS)).buffer);
  let at = 4 * (1 + STREAMS);
  const streams = lengths.map((length) => all.subarray(at, (at += length)));
  const joiner = new Joiner(streams, size);
  walk(joiner);
  return joiner.module;
}
