// SPDX-License-Identifier: GPL-3.0-or-later

// The one place of the page that turns numbers into decimals. A number with a radius is rounded outwards, as enclosing_text of
// lib/radcert/scalar/enclosing_text.h does it: in whole numbers, because in doubles the last step would be rounded to nearest.

/** A double as the quotient of two whole numbers. */
function exactly(value) {
  const bits = new DataView(new ArrayBuffer(8));
  bits.setFloat64(0, value);
  const all = bits.getBigUint64(0);
  const biased = Number((all >> 52n) & 0x7ffn);
  const mantissa = (all & 0xfffffffffffffn) + (biased === 0 ? 0n : 1n << 52n);
  const power = Math.max(biased, 1) - 1075;
  const signed = all >> 63n ? -mantissa : mantissa;
  return power >= 0 ? { up: signed << BigInt(power), down: 1n } : { up: signed, down: 1n << BigInt(-power) };
}

const powerOfTen = (n) => 10n ** BigInt(n);

/** A decimal text as the quotient of two whole numbers. */
function read(text) {
  const [mantissa, power = "0"] = text.split("e");
  const [whole, decimals = ""] = mantissa.split(".");
  const places = Number(power) - decimals.length;
  const digits = BigInt(whole.replace("-", "") + decimals);
  const signed = mantissa.startsWith("-") ? -digits : digits;
  return places >= 0 ? { up: signed * powerOfTen(places), down: 1n } : { up: signed, down: powerOfTen(-places) };
}

const size = (x) => ({ up: x.up < 0n ? -x.up : x.up, down: x.down });
const sum = (x, y) => ({ up: x.up * y.down + y.up * x.down, down: x.down * y.down });
const minus = (x) => ({ up: -x.up, down: x.down });

/** The least whole number that is not below x 10^places. */
function ceiling(x, places) {
  const up = places >= 0 ? x.up * powerOfTen(places) : x.up;
  const down = places >= 0 ? x.down : x.down * powerOfTen(-places);
  return (up + down - 1n) / down;
}

/** x > 0 rounded up to two digits. */
function upwards(x) {
  // Of a digits over b digits the first digit stands at 10^(a - b), or one place below.
  const most = String(x.up).length - String(x.down).length;
  const power = sum(x, minus(read(`1e${most}`))).up >= 0n ? most : most - 1;
  const digits = String(ceiling(x, 1 - power));
  return digits === "100" ? scientific("10", power + 1) : scientific(digits, power);
}

function scientific(digits, power) {
  const short = digits.replace(/0+$/, "");
  if (power === 1) return digits;
  if (power === 0) return short.length === 2 ? `${short[0]}.${short[1]}` : short;
  if (power === -1) return `0.${short}`;
  return `${short[0]}${short.length === 2 ? `.${short[1]}` : ""}e${power}`;
}

/** What must stand behind a text of a number for both to enclose it: the radius, and what the text left out. */
function radiusBehind(text, value, radius) {
  const total = sum(size(sum(exactly(value), minus(read(text)))), exactly(radius));
  return total.up === 0n ? "0" : upwards(total);
}

/** A number without a word on its error, rounded to nearest, to so many digits. */
export const about = (value, digits) => String(Number(value.toPrecision(digits)));
export const toDecimals = (value, decimals) => value.toFixed(decimals);
export const toPower = (value, digits) => value.toExponential(digits - 1);

/** A number with its radius, rounded outwards, to as many digits as the radius leaves; without one, to nearest. */
export function enclosing(value, radius) {
  if (radius === null || radius === undefined) return toPower(value, 5);
  if (radius === 0 && Number.isInteger(value) && Math.abs(value) < 1e8) return String(value);
  const power = value === 0 ? 0 : Math.floor(Math.log10(Math.abs(value)));
  const known = radius === 0 ? 8 : power - Math.floor(Math.log10(radius)) + 1;
  const digits = Math.min(8, Math.max(2, known));
  const text = value === 0 ? "0"
    : power >= -3 && power <= 4 ? toDecimals(value, Math.max(0, digits - 1 - power)) : toPower(value, digits);
  return `${text} ± ${radiusBehind(text, value, radius)}`;
}
