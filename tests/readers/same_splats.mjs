// Two PLY files of Gaussians hold the same splats, in any order, within the steps of the packed formats.
//   node same_splats.mjs EXPECTED.ply FOUND.ply TEXT
import fs from 'node:fs';

const [expectedFile, foundFile, text] = process.argv.slice(2);
const read = (file) => {
    const bytes = fs.readFileSync(file);
    const end = bytes.indexOf('end_header\n') + 11;
    const header = bytes.subarray(0, end).toString('latin1');
    const count = +/element vertex (\d+)/.exec(header)[1];
    const names = [...header.matchAll(/property float (\S+)/g)].map((m) => m[1]);
    const rows = [];
    for (let i = 0; i < count; ++i) {
        const row = {};
        names.forEach((name, k) => { row[name] = bytes.readFloatLE(end + 4 * (i * names.length + k)); });
        rows.push(row);
    }
    return rows;
};
const axes = ({ rot_0: a, rot_1: b, rot_2: c, rot_3: d }) => {
    const n = Math.hypot(a, b, c, d), w = a / n, x = b / n, y = c / n, z = d / n;
    return [[1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)], [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
        [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]];
};
const distance = (p, q) => Math.hypot(...p.map((v, i) => v - q[i]));
const place = (s) => [s.x, s.y, s.z];

const expected = read(expectedFile), found = read(foundFile);
const worst = { count: Math.abs(expected.length - found.length), place: 0, axes: 0, scale: 0, opacity: 0, dc: 0, rest: 0 };
// SOG and the second version of SPZ are coarser; SOG shares its harmonics among splats.
const sog = /sog/.test(text), coarse = sog || /odd2/.test(text);
const limits = { count: 0, place: 0.01, axes: coarse ? 0.3 : 0.01, scale: sog ? 0.06 : 0.035, opacity: sog ? 0.005 : 0.003, dc: sog ? 0.06 : 0.02, rest: sog ? 1.2 : 0.07 };
for (const e of expected) {
    const f = found.reduce((best, s) => (distance(place(s), place(e)) < distance(place(best), place(e)) ? s : best));
    const more = (name, v) => { worst[name] = Math.max(worst[name], v); };
    more('place', distance(place(e), place(f)));
    const a = axes(e), b = axes(f);
    for (let k = 0; k < 3; ++k) more('axes', Math.min(distance(a[k], b[k]), distance(a[k], b[k].map((v) => -v))));
    for (let k = 0; k < 3; ++k) more('scale', Math.abs(e[`scale_${k}`] - f[`scale_${k}`])), more('dc', Math.abs(e[`f_dc_${k}`] - f[`f_dc_${k}`]));
    more('opacity', Math.abs(1 / (1 + Math.exp(-e.opacity)) - 1 / (1 + Math.exp(-f.opacity))));
    for (let k = 0; k < 45; ++k) more('rest', Math.abs(e[`f_rest_${k}`] - f[`f_rest_${k}`]));
}
const wrong = Object.keys(limits).filter((name) => !(worst[name] <= limits[name]));
const shown = Object.entries(worst).map(([k, v]) => `${k} ${v.toPrecision(2)}`).join(', ');
console.log(`${wrong.length ? `FAILED (${wrong})` : 'ok'}: ${text}: ${shown}`);
process.exit(wrong.length ? 1 : 0);
