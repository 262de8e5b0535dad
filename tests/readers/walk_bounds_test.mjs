// web/walk_bounds.mjs, which keeps the visitor of viewer.html on the floor.   node --test walk_bounds_test.mjs
import assert from 'node:assert/strict';
import test from 'node:test';
import { WalkBounds, WalkableFloor } from '../../web/walk_bounds.mjs';

const box = (x0, z0, x1, z1) => [[x0, z0], [x1, z0], [x1, z1], [x0, z1]];
// Two rooms, 4 x 4 m with an island of 2 x 1 m and 4 x 3 m, and a doorway 0.3 m wide and 0.2 m deep between them.
const outline = [[-2, -2], [2, -2], [2, 2], [1.3, 2], [1.3, 2.2], [2, 2.2], [2, 5], [-2, 5], [-2, 2.2], [1, 2.2],
    [1, 2], [-2, 2]];
const island = box(-1, 0, 1, 1);
const house = () => new WalkableFloor([outline, island]);

// The outline of all free cells of a grid, as rings of axis-aligned edges.
const gridRings = (n, step, free) => {
    const at = (i, j) => i >= 0 && j >= 0 && i < n && j < n && free((i + 0.5) * step, (j + 0.5) * step);
    const next = new Map();
    const add = (i0, j0, i1, j1) => next.set(`${i0},${j0}`, [...(next.get(`${i0},${j0}`) ?? []), [i1, j1]]);
    for (let j = 0; j < n; ++j)
        for (let i = 0; i < n; ++i)
            if (at(i, j)) {
                if (!at(i, j - 1)) add(i, j, i + 1, j);
                if (!at(i + 1, j)) add(i + 1, j, i + 1, j + 1);
                if (!at(i, j + 1)) add(i + 1, j + 1, i, j + 1);
                if (!at(i - 1, j)) add(i, j + 1, i, j);
            }
    const rings = [];
    for (;;) {
        const begin = [...next.keys()].find((k) => next.get(k).length);
        if (!begin) return rings;
        const ring = [];
        for (let at = begin; ;) {
            ring.push(at.split(',').map((c) => Number(c) * step));
            const to = next.get(at).pop().join(',');
            if (to === begin) break;
            at = to;
        }
        rings.push(ring);
    }
};

const gridFloor = (free) => new WalkableFloor(gridRings(60, 0.1, free));

const numbers = (seed) => () => ((seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648);

// Pushes in one direction for many frames; every place on the way.
const push = (floor, from, direction, frames, step_m = 4 / 60) => {
    const length = Math.hypot(...direction), way = [from];
    for (let k = 0; k < frames; ++k) {
        const [x, z] = way.at(-1);
        way.push(floor.slide(x, z, x + (direction[0] / length) * step_m, z + (direction[1] / length) * step_m));
    }
    return way;
};

test('a free move is the move itself', () => {
    assert.deepEqual(house().slide(-1.5, -1.5, -1.4, -1.3), [-1.4, -1.3]);
});

test('whatever one does, one stays on the floor', () => {
    const random = numbers(7);
    const floors = [
        house(),
        gridFloor((x, z) => Math.hypot(x - 3, z - 3) < 2.7 && Math.hypot(x - 3, z - 2) > 0.6),
        gridFloor((x, z) => z < 3 + 0.5 * x && z > x - 2 && !(Math.abs(x - z) < 0.5 && x > 2 && x < 4)),
    ];
    for (const floor of floors)
        for (let walk = 0; walk < 60; ++walk) {
            let p = floor.nearestInside(random() * 6 - 1, random() * 6 - 1);
            for (let k = 0; k < 60; ++k) {
                const far = random() < 0.2 ? 6 : 0.2;
                const to = [p[0] + (random() - 0.5) * far, p[1] + (random() - 0.5) * far];
                const q = floor.slide(...p, ...to);
                assert.ok(floor.contains(...q), `${p} to ${to} ended outside at ${q}`);
                // Sliding never leads further than the wish, nor away from it.
                assert.ok(Math.hypot(q[0] - p[0], q[1] - p[1]) <= Math.hypot(to[0] - p[0], to[1] - p[1]) + 1e-9);
                assert.ok(Math.hypot(to[0] - q[0], to[1] - q[1]) <= Math.hypot(to[0] - p[0], to[1] - p[1]) + 1e-9);
                p = q;
            }
        }
});

test('one stands still at a wall and in every corner, and the way back is free at once', () => {
    const floor = house();
    for (const direction of [[0, 1], [0, -1], [1, 0], [-1, 0], [1, 0.9], [-1, -0.3], [0.5, -1]]) {
        const way = push(floor, [-1.5, -1.5], direction, 400), [x, z] = way.at(-1);
        assert.ok(Math.hypot(x - way.at(-2)[0], z - way.at(-2)[1]) < 1e-9, `trembles when pushed along ${direction}`);
        const back = floor.slide(x, z, x - direction[0] * 0.01, z - direction[1] * 0.01);
        assert.ok(Math.hypot(back[0] - x, back[1] - z) > 0.009);
    }
});

test('a corner of any width holds without trembling', () => {
    for (let degrees = 20; degrees < 180; degrees += 10) {
        const a = (degrees / 2) * (Math.PI / 180);
        const side = 4 * Math.sin(a), back = -4 * Math.cos(a);
        const floor = new WalkableFloor([[[0, 0], [side, back], [0, -8], [-side, back]]]);
        for (const x of [0, 0.05, -0.1, 0.3]) {
            const way = push(floor, [0, -1], [x, 1], 300);
            for (let k = 2; k < way.length; ++k) {
                const [a, b, c] = [way[k - 2], way[k - 1], way[k]];
                const turned = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) < -1e-15;
                assert.ok(!turned, `${degrees} degrees, pushed along ${x}, 1: turns back in frame ${k}`);
            }
        }
    }
});

test('pushed slantwise against a wall one slides with the part of the speed that leads along it', () => {
    const way = push(house(), [-1.9, 2 - 2e-3], [1, 1], 10);
    assert.ok(Math.abs(way.at(-1)[0] - (-1.9 + (10 * 4) / 60 / Math.SQRT2)) < 0.01);
    assert.ok(Math.abs(way.at(-1)[1] - (2 - 1e-3)) < 1e-9);
});

test('one gets round the island and through the doorway by keys alone', () => {
    const floor = house();
    let at = push(floor, [0, -1], [0, 1], 100).at(-1);
    assert.ok(Math.abs(at[1] - (0 - 1e-3)) < 1e-9, `stops at the island, not at ${at}`);
    at = push(floor, at, [1, 1], 100).at(-1);          // slides along it and past its end
    at = push(floor, at, [0, 1], 100).at(-1);
    assert.ok(at[1] > 1.9, `is past the island: ${at}`);
    at = push(floor, at, [-1, 1], 200).at(-1);         // slides along the wall until the doorway lets one in
    at = push(floor, at, [0, 1], 200).at(-1);
    assert.ok(at[1] > 2.2, `is in the other room: ${at}`);
});

test('a slanted wall of steps is walked along as one', () => {
    const slope = 0.7;
    const rings = gridRings(80, 0.1, (x, z) => x > 0.5 && x < 7.5 && z > 0.5 && z < 1 + slope * x);
    const floor = new WalkableFloor(rings);
    const way = push(floor, [1.5, 1.2], [1, 1], 60), run = way.slice(-40);
    const share = (1 + slope) / Math.hypot(1, slope) / Math.SQRT2;  // of the speed, along a smooth wall
    const steps = run.slice(1).map((p, i) => Math.hypot(p[0] - run[i][0], p[1] - run[i][1]) / (4 / 60) / share);
    const least = Math.min(...steps), most = Math.max(...steps);
    assert.ok(least > 0.8 && most < 1.1, `steps of ${least} to ${most} of a smooth wall's`);
});

test('a ledge at the end of a wall is passed like a ramp', () => {
    const floor = new WalkableFloor([[[0, 0], [3, 0], [3, 5], [0.1, 5], [0.1, 2], [0, 2]]]);
    const at = push(floor, [0.01, 0.5], [0, 1], 100).at(-1);
    assert.ok(at[1] > 4.9, `came to ${at}`);
});

test('cutting off notches takes floor away only near the boundary, adds none and keeps every passage', () => {
    const inWall = (x, z) => Math.abs(x - 3) < 0.35 && Math.abs(z - 3 + 0.4 * (x - 3)) > 0.2;
    const free = (x, z) => Math.hypot(x - 3, z - 3) < 2.8 && !inWall(x, z);
    const rings = gridRings(60, 0.1, free), floor = new WalkableFloor(rings), whole = new WalkableFloor([]);
    whole.rings = rings;
    const angles = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => (k * Math.PI) / 4);
    const aside = angles.map((a) => [0.12 * Math.cos(a), 0.12 * Math.sin(a)]);
    const near = (x, z) => aside.some(([dx, dz]) => !whole.contains(x + dx, z + dz));
    for (let z = 0.013; z < 6; z += 0.037)
        for (let x = 0.011; x < 6; x += 0.037) {
            if (floor.contains(x, z)) assert.ok(whole.contains(x, z), `${x}, ${z} was never floor`);
            else if (whole.contains(x, z)) assert.ok(near(x, z), `${x}, ${z} is far from the boundary`);
        }
    // From one half to the other through the slanted gap 0.4 m wide.
    let at = push(floor, [1.5, 3.6], [1, -0.4], 100).at(-1);
    assert.ok(at[0] > 3.5, `got through the gap, to ${at}`);
});

test('steps deeper than the grid\'s stay as they are', () => {
    const floor = new WalkableFloor([[[0, 0], [3, 0], [3, 3], [0.6, 3], [0.6, 2.7], [0.3, 2.7], [0.3, 2.4], [0, 2.4]]]);
    assert.ok(floor.contains(0.33, 2.68) && floor.contains(0.63, 2.98));
});

test('a place off the floor is brought to the nearest place on it', () => {
    const floor = house();
    assert.deepEqual(floor.nearestInside(0.3, -1.2), [0.3, -1.2]);
    const near = (p, q) => assert.ok(Math.hypot(p[0] - q[0], p[1] - q[1]) < 8e-3, `${p} is not ${q}`);
    near(floor.nearestInside(0.2, 0.1), [0.2, 0]);    // in the island
    near(floor.nearestInside(-5, -7), [-2, -2]);      // beyond a corner
    near(floor.nearestInside(0, 2.09), [0, 2]);       // in the wall between the rooms
    near(new WalkableFloor([[[0, 0], [1, 0.3], [1, -0.3]]]).nearestInside(-1, 0), [0.01, 0]);  // beyond a sharp corner
    assert.equal(new WalkableFloor([]).nearestInside(0, 0), null);
});

test('2000 vertices cost far less than a frame', () => {
    const steps = 1000, ring = [];
    for (let k = 0; k < steps; ++k) {  // a gear, whose teeth are too deep to be cut off
        const a = (2 * Math.PI * k) / steps, r = k % 2 ? 3.2 : 3;
        ring.push([r * Math.cos(a), r * Math.sin(a)], [r * Math.cos(a + 0.003), r * Math.sin(a + 0.003)]);
    }
    const floor = new WalkableFloor([ring]);
    assert.ok(floor.edges.length >= 1900, `${floor.edges.length} edges`);
    const begin = performance.now();
    push(floor, [2, 0.3], [1, 0.2], 1000);
    const ms = (performance.now() - begin) / 1000;
    console.log(`# ${ms.toFixed(3)} ms a frame with ${floor.edges.length} edges`);
    assert.ok(ms < 4, `${ms} ms a frame`);
});

// The viewer's own vectors and camera, as far as WalkBounds uses them.
class Point {
    constructor(x, y, z) { this.set(x, y, z); }
    set(x, y, z) { Object.assign(this, { x, y, z }); return this; }
    copy(p) { return this.set(p.x, p.y, p.z); }
    clone() { return new Point(this.x, this.y, this.z); }
    distance(p) { return Math.hypot(this.x - p.x, this.y - p.y, this.z - p.z); }
}
const bounds = () => {
    const listeners = {};
    const walk = new WalkBounds({ rings: [outline, island], low: -0.6, high: 0.3 });
    walk.listen({ on: (name, f) => { listeners[name] = f; } });
    return { walk, fire: (name, ...args) => listeners[name]?.(...args) };
};

test('heights are held, and the controller goes on from the held place', () => {
    const { walk } = bounds();
    const camera = { position: new Point(0, 0, -1) }, controller = { _position: new Point(0, 0, -1) };
    walk.hold('fly', controller, camera);
    assert.deepEqual({ ...camera.position }, { x: 0, y: 0, z: -1 });
    camera.position.set(0, 1.2, -1);
    walk.hold('fly', controller, camera);
    assert.deepEqual({ ...controller._position }, { x: 0, y: 0.3, z: -1 });
    camera.position.set(0, -2, 3);
    walk.hold('fly', controller, camera);
    assert.equal(camera.position.y, -0.6);
    assert.ok(Math.abs(camera.position.z - -1e-3) < 1e-9, 'stopped at the island');
    assert.deepEqual({ ...controller._position }, { ...camera.position });
});

test('a jump lands where it leads to, a step does not cross furniture', () => {
    const { walk, fire } = bounds();
    const camera = { position: new Point(0, 0, -1) }, controller = { _position: new Point(0, 0, -1) };
    walk.hold('fly', controller, camera);
    camera.position.set(0, 0, 4);
    walk.hold('fly', controller, camera);
    assert.ok(camera.position.z < 0);
    fire('inputEvent', 'reset');
    camera.position.set(0, 0, 4);
    walk.hold('fly', controller, camera);
    assert.deepEqual({ ...camera.position }, { x: 0, y: 0, z: 4 });
    fire('inputEvent', 'interact');
    camera.position.set(0, 0, -1);
    walk.hold('fly', controller, camera);
    assert.ok(camera.position.z > 2.2, 'the wall between the rooms stops a step');
});

test('an orbit that is held goes on looking at its center', () => {
    const { walk } = bounds();
    let looked = null, told = null;
    const camera = {
        position: new Point(0, 0, -1),
        calcFocusPoint: (out) => out.set(0, 0, 0.5),
        look: (from, to) => { camera.position.copy(from); looked = { ...to }; },
    };
    const controller = { goto: (c) => { told = { ...c.position }; } };
    walk.hold('orbit', controller, camera);
    assert.equal(looked, null);
    camera.position.set(0, 0, -9);
    walk.hold('orbit', controller, camera);
    assert.deepEqual(looked, { x: 0, y: 0, z: 0.5 });
    assert.ok(Math.abs(told.z - (-2 + 1e-3)) < 1e-9, `held at ${told.z}`);
});

test('in virtual reality the rig follows so that the head stays over the floor', () => {
    const { walk } = bounds();
    const rig = { x: 0, z: 0, translate(x, y, z) { this.x += x; this.z += z; assert.equal(y, 0); } };
    const camera = { at: new Point(0, 1.6, -1), getPosition() { return new Point(this.at.x + rig.x, this.at.y, this.at.z + rig.z); } };
    walk.holdRig(rig, camera);
    assert.deepEqual([rig.x, rig.z], [0, 0], 'free floor moves nothing');
    camera.at = new Point(0, 1.6, -9);  // through the wall on one's own feet
    walk.holdRig(rig, camera);
    const head = camera.getPosition();
    assert.ok(walk.floor.contains(head.x, head.z), `held at ${head.x}, ${head.z}`);
    assert.ok(Math.abs(head.z - -2) < 0.01);
});

// A floor of 4 x 6 m whose half beyond z = 2 is raised by 0.4 m, by a step of 0.2 m at z = 1.5.
const tiers = () => new WalkBounds({
    rings: [box(-2, -2, 2, 4)], low: -0.5, high: 0.5, ground: -1.5,
    levels: [{ rings: [box(-2, -2, 2, 1.5)], raised: 0 }, { rings: [box(-2, 1.5, 2, 2)], raised: 0.2 },
        { rings: [box(-2, 2, 2, 4)], raised: 0.4 }],
});
const camera = (x, y, z) => ({
    position: { x, y, z, set(...p) { [this.x, this.y, this.z] = p; } },
});

test('up steps the eye keeps its height above the floor, and rises little by little', () => {
    const bounds = tiers(), walker = camera(0, 0.1, 0);
    bounds.hold('walk', {}, walker, 1 / 60);
    let last = walker.position.y;
    for (let k = 0; k < 240; ++k) {
        walker.position.z = Math.min(3.5, walker.position.z + 1.4 / 60);
        bounds.hold('walk', {}, walker, 1 / 60);
        assert.ok(walker.position.y - last < 0.04 && walker.position.y >= last - 1e-9);
        last = walker.position.y;
    }
    assert.ok(Math.abs(walker.position.y - 0.5) < 1e-3);
    for (let k = 0; k < 240; ++k) {
        walker.position.z = Math.max(0, walker.position.z - 1.4 / 60);
        bounds.hold('walk', {}, walker, 1 / 60);
    }
    assert.ok(Math.abs(walker.position.y - 0.1) < 1e-3);
});

test('on a tier the camera stays between heights that are as much higher', () => {
    const bounds = tiers();
    const held = (z, y) => {
        const one = camera(0, y, z);
        bounds.jumps = true;
        bounds.hold('fly', {}, one, 1 / 60);
        return one.position.y;
    };
    const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a}, not ${b}`);
    near(held(0, 3), 0.5);
    near(held(3, 3), 0.9);
    near(held(3, -3), -0.1);
    near(bounds.walkTarget({ x: 0, y: -1.1, z: 3, clone() { return { ...this }; } }).y, -0.1);
});

test('a rig stands on the tier', () => {
    const bounds = tiers();
    let y = -1.5;
    const rig = { translate: (dx, dy) => (y += dy), getPosition: () => ({ x: 0, y, z: 3 }) };
    bounds.holdRig(rig, { getPosition: () => ({ x: 0, y: 0.2, z: 3 }) });
    assert.ok(Math.abs(y + 1.1) < 1e-9);
});
