// three.js in Chromium shows room.glb: from its own camera each thing covers the pixels that the traced room says.
//   node three_check.mjs WEB_DIR ROOM.glb INSTANCES.png INSTANCES.json SCREENSHOT.png
// INSTANCES.png: the number of the thing in each pixel, as gray; INSTANCES.json: their ids.
//   node three_check.mjs WEB_DIR ROOM.glb - - SCREENSHOT.png [WIDTHxHEIGHT]
// Only the screenshot.
import fs from 'node:fs';
import path from 'node:path';
import { openChromium } from './open_chromium.mjs';

const [web, glb, mapPng, mapJson, png, size] = process.argv.slice(2);
const kLeastIou = 0.95, kLeastPixels = 400;  // of a thing: outlines of smaller ones are most of them
const origin = 'http://room.test';
const served = {
    '/page.html': ['text/html', Buffer.from(`<script type="importmap">{"imports":{"three":"/three/build/three.module.js","three/addons/":"/three/examples/jsm/"}}</script><body style="margin:0"></body>`)],
    '/room.glb': ['model/gltf-binary', fs.readFileSync(glb)],
};
if (mapPng !== '-') served['/map.png'] = ['image/png', fs.readFileSync(mapPng)];
const instances = mapJson === '-' ? [] : JSON.parse(fs.readFileSync(mapJson));
const browser = await openChromium(web);
let failed = false;
const expect = (ok, text) => {
    if (!ok) failed = true;
    console.log(`three.js: ${ok ? 'ok' : 'FAILED'}: ${path.basename(glb)}: ${text}`);
};
try {
    const page = await browser.newPage({ viewport: { width: 960, height: 720 } });
    page.on('console', (m) => { if (m.type() === 'error' && !m.text().includes('ERR_NAME_NOT_RESOLVED')) console.error(m.text()); });
    page.on('pageerror', (e) => expect(false, e.message));
    await page.route(`${origin}/**`, (route) => {
        const name = new URL(route.request().url()).pathname;
        if (served[name]) return route.fulfill({ contentType: served[name][0], body: served[name][1] });
        const file = path.resolve(web, 'node_modules', `.${name}`);
        return fs.existsSync(file) ? route.fulfill({ contentType: 'text/javascript', path: file }) : route.abort();
    });
    await page.goto(`${origin}/page.html`);
    const result = await page.evaluate(async ({ instances, shape }) => {
        const THREE = await import('three');
        const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
        const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js');
        const room = await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).loadAsync('/room.glb');
        let truth = null, [width, height] = shape;
        if (instances.length) {
            truth = await createImageBitmap(await (await fetch('/map.png')).blob(), { colorSpaceConversion: 'none' });
            [width, height] = [truth.width, truth.height];
        }
        const scene = new THREE.Scene(), renderer = new THREE.WebGLRenderer({ antialias: !truth, preserveDrawingBuffer: true });
        renderer.setSize(width, height);
        document.body.appendChild(renderer.domElement);
        scene.add(room.scene);
        const camera = room.cameras[0] ?? new THREE.PerspectiveCamera(60, 1, 0.05);
        if (!room.cameras[0]) camera.rotation.y = Math.PI;
        camera.aspect = width / height;
        camera.updateProjectionMatrix();
        const pixels = () => {
            const data = new Uint8Array(4 * width * height), gl = renderer.getContext();
            gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
            return data;
        };
        const of = {};
        if (truth) {
            // Each thing in its number's gray, without light.
            renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
            const number = Object.fromEntries(instances.map((i) => [i.id, i.instance]));
            const kept = new Map();
            room.scene.traverse((node) => {
                if (!node.isMesh) return;
                let thing = node;
                while (thing && !(thing.userData.id in number)) thing = thing.parent;
                const gray = number[thing?.userData.id] / 255;
                kept.set(node, node.material);
                node.material = new THREE.MeshBasicMaterial({ color: new THREE.Color(gray, gray, gray), side: THREE.DoubleSide });
            });
            renderer.render(scene, camera);
            const seen = pixels(), canvas = new OffscreenCanvas(width, height), context = canvas.getContext('2d');
            context.drawImage(truth, 0, 0);
            const wanted = context.getImageData(0, 0, width, height).data;
            const count = (i, key) => { (of[i] ??= { both: 0, either: 0, wanted: 0 })[key]++; };
            for (let y = 0; y < height; ++y)
                for (let x = 0; x < width; ++x) {
                    const a = seen[4 * ((height - 1 - y) * width + x)], b = wanted[4 * (y * width + x)];
                    count(b, 'wanted');
                    count(b, 'either');
                    if (a === b) count(a, 'both');
                    else count(a, 'either');
                }
            for (const [node, material] of kept) node.material = material;
            renderer.outputColorSpace = THREE.SRGBColorSpace;
        }
        if (room.parser.json.extensionsUsed?.includes('KHR_materials_unlit') !== true)
            scene.add(new THREE.HemisphereLight(0xffffff, 0xbbaa99, 1.5));
        renderer.render(scene, camera);
        const shown = pixels();
        let mean = 0, square = 0;
        for (let i = 0; i < shown.length; i += 4) mean += shown[i + 1], square += shown[i + 1] ** 2;
        mean /= width * height;
        return { of, mean, deviation: Math.sqrt(square / (width * height) - mean * mean), picture: renderer.domElement.toDataURL('image/png') };
    }, { instances, shape: (size ?? '960x720').split('x').map(Number) });
    fs.writeFileSync(png, Buffer.from(result.picture.split(',')[1], 'base64'));
    expect(result.mean > 20 && result.deviation > 10, `the room is seen (mean ${result.mean.toFixed(0)}, deviation ${result.deviation.toFixed(0)})`);
    let compared = 0, worst = [1, ''];
    for (const { instance, id } of instances) {
        const n = result.of[instance];
        if (!n || n.wanted < kLeastPixels) continue;
        ++compared;
        if (n.both / n.either < worst[0]) worst = [n.both / n.either, id];
    }
    if (instances.length) expect(compared > 5 && worst[0] >= kLeastIou, `${compared} things where the traced room has them; the worst is ${worst[1]}: IoU ${worst[0].toFixed(3)}`);
} finally {
    await browser.close();
}
process.exit(failed ? 1 : 0);
