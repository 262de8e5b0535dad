// Two glTF binaries hold the same attributes of Gaussians.
//   node same_glb.mjs OURS.glb THEIRS.glb
import fs from 'node:fs';

const read = (file) => {
    const bytes = fs.readFileSync(file), size = bytes.readUInt32LE(12);
    const json = JSON.parse(bytes.subarray(20, 20 + size).toString()), binary = bytes.subarray(28 + size);
    const primitive = json.meshes[0].primitives[0], values = {};
    for (const [name, index] of Object.entries(primitive.attributes)) {
        const a = json.accessors[index], v = json.bufferViews[a.bufferView], width = { SCALAR: 1, VEC3: 3, VEC4: 4 }[a.type];
        const at = (v.byteOffset ?? 0) + (a.byteOffset ?? 0);
        values[name] = Array.from({ length: a.count * width }, (_, i) => (a.componentType === 5126 ? binary.readFloatLE(at + 4 * i) : binary[at + i]));
    }
    return { values, extension: primitive.extensions.KHR_gaussian_splatting, mode: primitive.mode };
};
const [ours, theirs] = process.argv.slice(2).map(read);
let failed = JSON.stringify(ours.extension) !== JSON.stringify(theirs.extension) || ours.mode !== theirs.mode;
if (failed) console.log('FAILED:', ours.extension, theirs.extension);
for (const name of Object.keys(theirs.values)) {
    // A quaternion may need its length made 1; a byte may be rounded the other way.
    const a = ours.values[name] ?? [], b = theirs.values[name];
    const unit = (v, i) => (name.endsWith('ROTATION') ? v[i] / Math.hypot(...v.slice(i - (i % 4), i - (i % 4) + 4)) : v[i]);
    const worst = b.reduce((m, _, i) => Math.max(m, Math.abs(unit(a, i) - unit(b, i))), a.length === b.length ? 0 : Infinity);
    const ok = worst <= (name === 'COLOR_0' ? 1 : 2e-6);
    if (!ok) failed = true;
    if (!ok) console.log(`FAILED: ${name}: ${worst}`);
}
console.log(`${failed ? 'FAILED' : 'ok'}: odd.glb holds what splat-transform's does, ${Object.keys(theirs.values).length} attributes`);
process.exit(failed ? 1 : 0);
