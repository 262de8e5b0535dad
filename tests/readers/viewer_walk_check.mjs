// Opens walk.html (make_reader_samples) from disk in Chromium and tries to leave its walkable area in every way that
// the viewer offers.
//   node viewer_walk_check.mjs WEB_DIR WALK_HTML SCREENSHOT_DIR
import { pathToFileURL } from 'node:url';
import path from 'node:path';
import { openChromium } from './open_chromium.mjs';

const [web, html, shots] = process.argv.slice(2);
// The floor as make_reader_samples.cc has it, world frame: x right, y down, z forward.
const island = [[-1, 0], [1, 0], [1, 1], [-1, 1]];
const outline = [[-2, -3], [2, -3], [2, 2], [1.8, 2], [1.8, 2.2], [2, 2.2], [2, 3.5], [-2, 3.5], [-2, 2.2], [1.5, 2.2],
    [1.5, 2]];
for (let k = 0; k < 10; ++k) outline.push([-1 - k / 10, 2 - k / 5], [-1 - k / 10, 1.8 - k / 5]);
outline.push([-2, 0]);
const low = -0.4, high = 0.6;
const onFloor = ([x, y, z]) => {
    if (y < low - 1e-6 || y > high + 1e-6) return false;  // the engine's matrices are single precision
    let inside = false;
    for (const ring of [outline, island])
        ring.forEach(([ax, az], i) => {
            const [bx, bz] = ring[(i + 1) % ring.length];
            if (az > z !== bz > z && x < ax + ((z - az) / (bz - az)) * (bx - ax)) inside = !inside;
        });
    return inside;
};

const browser = await openChromium(web);
let failed = false;
const expect = (ok, text) => {
    if (!ok) failed = true;
    console.log(`walk: ${ok ? 'ok' : 'FAILED'}: ${text}`);
};
const metres = (p) => p.map((v) => v.toFixed(3)).join(', ');

// A page whose camera is written down in every frame.
const open = async (options = {}) => {
    const context = await browser.newContext({ viewport: { width: 320, height: 240 }, ...options });
    await context.addInitScript(() => {
        window.stick = null;
        navigator.getGamepads = () => (window.stick ? [{
            mapping: 'standard', axes: [...window.stick, 0, 0], buttons: Array(32).fill({ pressed: false, value: 0 }),
        }] : []);
    });
    const page = await context.newPage();
    // The engine captures a pointer that a quick click has let go of already; nothing comes of it.
    page.on('pageerror', (e) => /setPointerCapture/.test(e) || expect(false, `no error in the page: ${e}`));
    await page.goto(pathToFileURL(path.resolve(html)).href);
    await page.waitForFunction(() => window.app, null, { timeout: 60000 });
    await page.evaluate(() => {
        const camera = window.app.root.findComponent('camera').entity;
        window.way = [];
        window.app.on('update', () => {
            const p = camera.getPosition();
            window.way.push([-p.x, -p.y, p.z]);
        });
    });
    // The panel of keys would lie over half of this small page and take what is meant for the scene.
    if (await page.locator('.sse-controlsHint').isVisible()) await page.keyboard.press('h');
    const here = () => page.evaluate(() => window.way.at(-1));
    // Waits until the camera has stood still for a while of frames.
    const settle = async () => {
        await page.evaluate(() => { window.from = window.way.length; });
        await page.waitForFunction(() => {
            const last = window.way.slice(-12), p = last.at(-1);
            const still = last.every((q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) < 1e-6);
            return window.way.length - window.from > 20 && still;
        }, null, { timeout: 40000, polling: 50 }).catch(() => expect(false, 'the camera came to rest'));
        return here();
    };
    // Everything seen since the last call lies within the bounds.
    const staysInside = async (what) => {
        const way = await page.evaluate(() => window.way.splice(0, window.way.length - 1));
        const out = way.filter((p) => !onFloor(p));
        const step = (p, i) => (i ? Math.hypot(...p.map((v, c) => v - way[i - 1][c])) : 0);
        const travel = way.reduce((sum, p, i) => sum + step(p, i), 0);
        expect(travel > 0.3, `${what}: moves, ${travel.toFixed(1)} m`);
        const where = out.length ? `, ${out.length} outside, the first at ${metres(out[0])}` : '';
        expect(out.length === 0, `${what}: inside in all of ${way.length} frames${where}`);
    };
    const hold = async (...keys) => {
        for (const key of keys) await page.keyboard.down(key);
        const at = await settle();
        for (const key of keys) await page.keyboard.up(key);
        await settle();
        return at;
    };
    const home = async () => {
        await page.keyboard.press('2');
        await settle();
        await page.keyboard.press('r');
        return settle();
    };
    const shot = (name) => page.screenshot({ path: path.join(shots, name) });
    return { context, page, settle, staysInside, hold, home, shot };
};

const near = (p, q, within = 5e-3) => Math.hypot(...p.map((v, i) => v - q[i])) < within;

try {
    const { context, page, settle, staysInside, hold, home, shot } = await open();
    const start = await settle();
    expect(near(start, [0, 0, -1]), `stands at the start: ${metres(start)}`);
    await shot('walk_start.png');
    const radial = await page.evaluate(() => window.app.scene.gsplat.radialSorting);
    expect(radial === false, 'splats are sorted by depth, as they were trained');

    const ahead = await hold('w');
    expect(near(ahead, [0, 0, 0]), `W stops at the island: ${metres(ahead)}`);
    await staysInside('W');
    await shot('walk_island.png');
    const back = await hold('s');
    expect(near(back, [0, 0, -3]), `S stops at the wall behind: ${metres(back)}`);
    const left = await hold('a');
    expect(near(left, [-2, 0, -3]), `A stops in the corner: ${metres(left)}`);
    const right = await hold('d');
    expect(near(right, [2, 0, -3]), `D stops in the other corner: ${metres(right)}`);
    await staysInside('S, A, D');

    const up = await hold('e');
    expect(near(up, [2, low, -3]), `E stops below the ceiling: ${metres(up)}`);
    const down = await hold('q');
    expect(near(down, [2, high, -3]), `Q stops above the floor: ${metres(down)}`);
    await staysInside('E, Q');

    await home();
    await hold('a');
    const slanted = await hold('w');
    expect(slanted[2] > 1.9, `W slides along the slanted wall: ${metres(slanted)}`);
    await home();
    await hold('w');
    const round = await hold('w', 'd');
    expect(round[2] > 1.9, `W and D slide round the island: ${metres(round)}`);
    const door_side = await hold('w', 'a');
    const through = await hold('w');
    expect(door_side[2] > 2.2 || through[2] > 2.2, `and through the doorway: ${metres(through)}`);
    await shot('walk_second_room.png');
    await staysInside('round the island and through the doorway');

    // Looking at one's feet, one still walks level.
    await home();
    await page.keyboard.press('g');  // the mouse drags again
    await page.mouse.move(160, 60);
    await page.mouse.down();
    await page.mouse.move(160, 200, { steps: 8 });
    await page.mouse.up();
    const before = await settle();
    const level = await hold('s');
    expect(Math.abs(level[1] - before[1]) < 1e-6 && !near(level, before, 0.5), `walks level: ${metres(level)}`);
    await staysInside('looking down');

    await home();
    for (let i = 0; i < 12; ++i) await page.mouse.wheel(0, i < 6 ? -800 : 1600);
    await settle();
    await staysInside('mouse wheel');

    // Around a point, zoomed out as far as it goes.
    await page.keyboard.press('1');
    await settle();
    for (let i = 0; i < 12; ++i) await page.mouse.wheel(0, 1600);
    await settle();
    await page.mouse.move(80, 120);
    await page.mouse.down();
    for (const [x, y] of [[300, 120], [20, 60], [300, 220], [160, 20]]) await page.mouse.move(x, y, { steps: 10 });
    await page.mouse.up();
    await settle();
    await page.mouse.move(160, 120);
    await page.mouse.down({ button: 'right' });
    await page.mouse.move(20, 20, { steps: 10 });
    await page.mouse.up({ button: 'right' });
    await settle();
    await staysInside('orbit: zoomed, turned, moved');
    await shot('walk_orbit.png');
    await page.keyboard.press('f');
    await settle();
    await staysInside('the whole scene framed');
    await page.keyboard.press('r');
    const again = await settle();
    expect(near(again, [0, 0, -1]), `reset leads home: ${metres(again)}`);
    await staysInside('reset');
    await page.mouse.dblclick(250, 100);
    await settle();
    for (let i = 0; i < 12; ++i) await page.mouse.wheel(0, i < 6 ? -400 : 800);
    await settle();
    await staysInside('towards a double-clicked point and away');
    await page.keyboard.press('2');
    await page.keyboard.press('g');  // W, A, S and D had set the mouse to turning the head
    await settle();
    await page.mouse.click(60, 150);
    await page.waitForTimeout(1500);  // the place is found first
    await settle();
    await staysInside('walk to a click');
    await page.keyboard.press(' ');
    await page.waitForTimeout(3000);
    await page.keyboard.press('2');
    await settle();
    await staysInside('the viewer\'s own animation');

    await home();
    for (const stick of [[0, -1], [1, -0.5], [0.3, 1], [-1, 0]]) {
        await page.evaluate((s) => { window.stick = s; }, stick);
        await settle();
    }
    await page.evaluate(() => { window.stick = [0, 0]; });
    await staysInside('gamepad');
    await context.close();

    // A phone: two fingers, then the joystick.
    const phone = await open({ hasTouch: true, isMobile: true });
    const touch = await phone.context.newCDPSession(phone.page);
    const fingers = async (type, ...points) => {
        await touch.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
        const frames = await phone.page.evaluate(() => window.way.length);
        await phone.page.waitForFunction((n) => window.way.length > n, frames);
    };
    await phone.settle();
    for (let swipe = 0; swipe < 4; ++swipe) {
        await fingers('touchStart', [150, 120], [170, 120]);
        for (let i = 1; i <= 6; ++i) await fingers('touchMove', [150 - 20 * i, 120], [170 + 20 * i, 120]);
        await fingers('touchEnd');
    }
    await phone.settle();
    await phone.staysInside('two fingers');
    await phone.page.evaluate(() => document.querySelector('.sse-gamingControlsRow').click());
    const stick = await phone.page.locator('.sse-joystickBase').boundingBox();
    const [sx, sy] = [stick.x + stick.width / 2, stick.y + stick.height / 2];
    await fingers('touchStart', [sx, sy]);
    for (const [dx, dy] of [[0, -40], [40, -20], [0, 40], [-40, 0]]) {
        await fingers('touchMove', [sx + dx, sy + dy]);
        await phone.settle();
    }
    await fingers('touchEnd');
    await phone.settle();
    await phone.staysInside('joystick');
    await phone.context.close();
} finally {
    await browser.close();
}
process.exit(failed ? 1 : 0);
