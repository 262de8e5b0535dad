// TinyUSDZ, an implementation of USD that is not ours, reads room.usda with its references: each thing has the triangles
// that room.glb has, at the same place, and a material whose texture is there. It also reads splats.
//   node usd_check.mjs WEB_DIR SPLATS.usda SPLAT_COUNT ROOM.usda ROOM.glb [ROOM.usda ROOM.glb …]
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const [web, splats, count, ...rooms] = process.argv.slice(2);
// The package is built for browsers, and refuses what calls itself Node.
process.type = 'renderer';
globalThis.window ??= globalThis;
const folder = path.resolve(web, 'node_modules/tinyusdz');
const { default: open } = await import(pathToFileURL(path.join(folder, 'tinyusdz.js')).href);
const usd = await open({ wasmBinary: fs.readFileSync(path.join(folder, 'tinyusdz.wasm')) });

const fail = (text) => {
    console.error(`tinyusdz: FAILED: ${text}`);
    process.exit(1);
};
const load = (file) => {
    const layer = new usd.TinyUSDZLoaderNative();
    if (!layer.loadAsLayerFromBinary(new Uint8Array(fs.readFileSync(file)), file)) fail(`${file}: ${layer.error()}`);
    return layer;
};
const noThing = () => ({ triangles: 0, low: [1e9, 1e9, 1e9], high: [-1e9, -1e9, -1e9] });
const widen = (thing, p) => p.forEach((v, a) => {
    thing.low[a] = Math.min(thing.low[a], v);
    thing.high[a] = Math.max(thing.high[a], v);
});

// By the names of the room's children: triangles and bounds in the room.
const thingsOfUsd = (file) => {
    const layer = load(file);
    if (layer.hasReferences()) layer.composeReferences();
    if (!layer.layerToRenderScene()) fail(`${file}: ${layer.error()}`);
    const things = {};
    const visit = (node, thing) => {
        if (node.contentId >= 0 && node.nodeType === 'mesh') {
            const mesh = layer.getMesh(node.contentId), m = node.globalMatrix;  // of row vectors
            thing.triangles += mesh.faceVertexCounts.length;
            for (let i = 0; i < mesh.points.length; i += 3) {
                const [x, y, z] = mesh.points.subarray(i, i + 3);
                widen(thing, [0, 1, 2].map((a) => x * m[a] + y * m[4 + a] + z * m[8 + a] + m[12 + a]));
            }
            if (mesh.materialId < 0) fail(`${file}: ${node.absPath} has no material`);
        }
        for (const child of node.children) visit(child, thing);
    };
    const root = layer.getDefaultRootNode();
    if (root.primName !== 'Room') fail(`${file}: expected the prim Room, found ${root.primName}`);
    for (const child of root.children) visit(child, things[child.primName] = noThing());
    for (const asset of fs.readFileSync(file, 'utf8').matchAll(/@([^@]+)@/g))
        if (!fs.existsSync(path.join(path.dirname(file), asset[1]))) fail(`${file}: no file ${asset[1]}`);
    return things;
};

const thingsOfGlb = (file) => {
    const bytes = fs.readFileSync(file), size = bytes.readUInt32LE(12);
    const json = JSON.parse(bytes.subarray(20, 20 + size).toString()), binary = bytes.subarray(28 + size);
    const things = {};
    for (const node of json.nodes.filter((n) => n.extras)) {
        const thing = things[node.name.replaceAll('-', '_')] = noThing();
        const [qx, qy, qz, qw] = node.rotation ?? [0, 0, 0, 1], move = node.translation ?? [0, 0, 0];
        const turn = ([x, y, z]) => {
            const t = [2 * (qy * z - qz * y), 2 * (qz * x - qx * z), 2 * (qx * y - qy * x)];
            return [x + qw * t[0] + qy * t[2] - qz * t[1], y + qw * t[1] + qz * t[0] - qx * t[2], z + qw * t[2] + qx * t[1] - qy * t[0]];
        };
        for (const p of json.meshes[node.mesh]?.primitives ?? []) {
            thing.triangles += json.accessors[p.indices].count / 3;
            const a = json.accessors[p.attributes.POSITION], at = json.bufferViews[a.bufferView].byteOffset;
            for (let i = 0; i < a.count; ++i)
                widen(thing, turn([0, 4, 8].map((o) => binary.readFloatLE(at + 12 * i + o))).map((v, k) => v + move[k]));
        }
    }
    return things;
};

for (let i = 0; i < rooms.length; i += 2) {
    const found = thingsOfUsd(rooms[i]), wanted = thingsOfGlb(rooms[i + 1]);
    let triangles = 0;
    for (const [name, thing] of Object.entries(wanted)) {
        const other = found[name] ?? fail(`${rooms[i]}: no prim ${name}`);
        if (other.triangles !== thing.triangles) fail(`${rooms[i]}: ${name}: ${other.triangles} triangles, ${thing.triangles} in glTF`);
        const off = Math.max(0, ...['low', 'high'].flatMap((side) => thing[side].map((v, a) => Math.abs(v - other[side][a]))));
        if (off > 1e-3) fail(`${rooms[i]}: ${name} lies ${off} m from where it is in glTF`);
        triangles += thing.triangles;
    }
    console.log(`tinyusdz: ok: ${path.basename(rooms[i])}: ${Object.keys(wanted).length} things, ${triangles} triangles as in glTF`);
}
// It knows no ParticleField3DGaussianSplat, and keeps the attributes of types that it does not know.
const text = load(splats).layerToString();
const entries = (name) => (text.match(new RegExp(` ${name} = \\[([^\\]]*)\\]`)) ?? fail(`${splats}: no ${name}`))[1].match(/\(/g).length;
const degree = Number(text.match(/radiance:sphericalHarmonicsDegree = (\d)/)?.[1] ?? fail(`${splats}: no degree`));
for (const [name, per] of [['positions', 1], ['orientations', 1], ['scales', 1], ['radiance:sphericalHarmonicsCoefficients', (degree + 1) ** 2]])
    if (entries(name) !== per * Number(count)) fail(`${splats}: ${entries(name)} ${name}, expected ${per * count}`);
console.log(`tinyusdz: ok: ${path.basename(splats)}: ${count} splats of degree ${degree}`);
