// Keeps the camera of viewer.html where the scene holds: on the walkable floor, along whose boundary it slides, and
// between two heights. save_viewer_html (src/fastscene/io/viewer.cc) puts this file into the page and ties it to the
// pinned viewer. Everything here is in the viewer's frame (x left, y up, z forward, metres); points on the floor are
// [x, z].

const SKIN_M = 1e-3;       // the camera stops this far inside the boundary, so that rounding never puts it outside
const NOTCH_M = 0.11;      // shallower notches are cut off: steps of the 0.1 m grid that the boundary comes from
const MAX_CONTACTS = 6;    // edges met in one frame; what is left of a move after that waits for the next frame
const TOUCHING_M = 1e-9;   // a shorter advance is none: the edges touched before are still touched
const CLIMB_S = 0.12;      // the eye rises to the height of a step within a few of these, as a walker's does

const turn = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

// Even-odd rule over all rings: outer rings and holes alike.
const insideRings = (rings, x, z) => {
    let inside = false;
    for (const ring of rings)
        for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) {
            const a = ring[j], b = ring[i];
            if (a[1] > z !== b[1] > z && x < a[0] + ((z - a[1]) / (b[1] - a[1])) * (b[0] - a[0])) inside = !inside;
        }
    return inside;
};

const withoutStraightVertices = (ring) => {
    const apart = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]) > 1e-6;
    const distinct = ring.filter((p, i) => apart(p, ring[(i + 1) % ring.length]));
    const n = distinct.length;
    return distinct.filter((p, i) => Math.abs(turn(distinct[(i + n - 1) % n], p, distinct[(i + 1) % n])) > 1e-7);
};

// +1 where the free floor lies to the left of the ring's edges (as x, z), -1 where it lies to the right.
const freeSide = (rings, ring) => {
    const probe_m = 1e-4;
    let left = 0;
    for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) {
        const a = ring[j], b = ring[i], dx = b[0] - a[0], dz = b[1] - a[1], s = probe_m / Math.hypot(dx, dz);
        left += insideRings(rings, (a[0] + b[0]) / 2 - dz * s, (a[1] + b[1]) / 2 + dx * s) ? 1 : -1;
        if (Math.abs(left) === 3) break;  // enough edges agree; where rings touch, one may be odd
    }
    return left < 0 ? -1 : 1;
};

// A slanted wall comes from the grid as a staircase, in whose notches a visitor would get stuck. Each notch between two
// tips is cut off by the line between the tips; a ledge at a wall's end gets a ramp twice as long as it is deep. This
// only takes floor away, at most NOTCH_M deep, and never closes a passage.
const withoutNotches = (rings) => {
    const straight = rings.map(withoutStraightVertices).filter((ring) => ring.length >= 3);
    return straight.map((ring) => {
        const n = ring.length, side = freeSide(straight, ring);
        const at = (i) => ring[(i + n) % n];
        const corner = (i) => turn(at(i - 1), at(i), at(i + 1)) * side;  // > 0: the floor's corner is convex
        const holds = (a, b, c, p) => [[a, b], [b, c], [c, a]].every(([q, r]) => turn(q, r, p) * side > 1e-9);
        const holdsAnother = (a, b, c) => straight.some((other) => other.some((p) => holds(a, b, c, p)));
        const length = (a, b) => Math.hypot(b[0] - a[0], b[1] - a[1]);
        const kept = ring.flatMap((c, i) => {
            const a = at(i - 1), b = at(i + 1);
            const tips = [corner(i - 1) < 0 ? a : null, corner(i + 1) < 0 ? b : null];
            if (corner(i) <= 0 || !(tips[0] || tips[1])) return [c];
            if (tips[0] && tips[1]) {
                const depth_m = Math.abs(turn(a, b, c)) / length(a, b);
                return depth_m > NOTCH_M || holdsAnother(a, c, b) ? [c] : [];
            }
            const tip = tips[0] ?? tips[1], wall = tips[0] ? b : a, depth_m = length(tip, c);
            const share = (2 * depth_m) / length(c, wall);
            if (depth_m > NOTCH_M || share > 0.5) return [c];
            const ramp = [c[0] + share * (wall[0] - c[0]), c[1] + share * (wall[1] - c[1])];
            return (tips[0] ? holdsAnother(a, c, ramp) : holdsAnother(ramp, c, b)) ? [c] : [ramp];
        });
        return withoutStraightVertices(kept);
    });
};

// The part of a wish (wx, wz) that none of the touched edges resists: the nearest move that leads into no wall.
const alongEdges = (wx, wz, touched) => {
    const free = (x, z, but) => touched.every((e) => e === but || x * e.nx + z * e.nz >= -1e-12);
    if (free(wx, wz)) return [wx, wz];
    let best = [0, 0], bestLength = 0;
    for (const e of touched) {
        const into = wx * e.nx + wz * e.nz;
        const x = wx - into * e.nx, z = wz - into * e.nz, length = Math.hypot(x, z);
        if (into < 0 && length > bestLength && free(x, z, e)) {
            best = [x, z];
            bestLength = length;
        }
    }
    return best;
};

class WalkableFloor {
    constructor(rings) {
        this.rings = withoutNotches(rings);
        this.edges = [];  // from a, along the unit tangent t for `length`; n is the unit normal into the floor
        for (const ring of this.rings) {
            const side = freeSide(this.rings, ring);
            for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) {
                const [ax, az] = ring[j], dx = ring[i][0] - ax, dz = ring[i][1] - az, length = Math.hypot(dx, dz);
                const tx = dx / length, tz = dz / length;
                this.edges.push({ ax, az, tx, tz, nx: -tz * side, nz: tx * side, length });
            }
        }
    }

    contains(x, z) {
        return insideRings(this.rings, x, z);
    }

    // The point itself where it is on the floor, else the nearest point that is. null: the floor is empty.
    nearestInside(x, z) {
        if (this.contains(x, z)) return [x, z];
        // Beside each edge; in a sharp corner only places further from its tip are on the floor.
        const places = [1, 8, 64].flatMap((offTip) => this.edges.map((e) => {
            const margin = Math.min(offTip * SKIN_M, e.length / 2);
            const s = Math.max(margin, Math.min(e.length - margin, (x - e.ax) * e.tx + (z - e.az) * e.tz));
            const px = e.ax + s * e.tx + SKIN_M * e.nx, pz = e.az + s * e.tz + SKIN_M * e.nz;
            return { px, pz, far: Math.hypot(px - x, pz - z) };
        }));
        places.sort((a, b) => a.far - b.far);
        const place = places.find(({ px, pz }) => this.contains(px, pz));
        return place ? [place.px, place.pz] : null;
    }

    // The first edge that a move (mx, mz) from (x, z) meets, and the share of the move until then.
    _firstMet(x, z, mx, mz) {
        let met = null, share = 1;
        for (const e of this.edges) {
            const toward = -(mx * e.nx + mz * e.nz);
            const distance = (x - e.ax) * e.nx + (z - e.az) * e.nz;
            if (toward <= 1e-12 || distance < 0 || distance - toward >= SKIN_M) continue;
            const reached = Math.max(0, (distance - SKIN_M) / toward);
            if (reached >= share) continue;
            const along = (t) => (x + mx * t - e.ax) * e.tx + (z + mz * t - e.az) * e.tz;
            const near = along(reached), crossed = distance / toward, cut = along(crossed);
            if ((near >= -SKIN_M && near <= e.length + SKIN_M) || (crossed <= 1 && cut >= 0 && cut <= e.length)) {
                met = e;
                share = reached;
            }
        }
        return { met, share };
    }

    // Walks from a point on the floor towards another, along the boundary where it is met.
    slide(fromX, fromZ, toX, toZ) {
        let x = fromX, z = fromZ, touched = [];
        for (let k = 0; k < MAX_CONTACTS; ++k) {
            const [mx, mz] = alongEdges(toX - x, toZ - z, touched);
            if (Math.hypot(mx, mz) < TOUCHING_M) break;
            const { met, share } = this._firstMet(x, z, mx, mz);
            x += mx * share;
            z += mz * share;
            if (!met) break;
            if (Math.hypot(mx, mz) * share > TOUCHING_M) touched = [];
            touched.push(met);
        }
        return this.contains(x, z) ? [x, z] : [fromX, fromZ];
    }
}

// What the viewer's CameraManager asks (its names: `camera` has position, angles, distance, look, calcFocusPoint).
class WalkBounds {
    // rings: closed polygons of [x, z]; low and high: between which y the camera stays; ground: y of the floor; levels,
    // of a floor with tiers or steps: the rings of each part and how far it is raised above the ground. There the camera
    // stays as much higher.
    constructor({ rings, low, high, ground, levels = [] }) {
        this.floor = new WalkableFloor(rings);
        this.low = low;
        this.high = high;
        this.ground = ground;
        this.levels = levels;
        this.raised = 0;     // the floor below the camera, as far as the eye has risen to it
        this.at = null;      // where the camera was held last
        this.jumps = false;  // the next pose is a new place, not a step from the last one
    }

    _height(y, raised = 0) {
        return Math.min(this.high + raised, Math.max(this.low + raised, y));
    }

    // How far the floor is raised there; between two parts, as it was.
    _raisedAt(x, z) {
        return this.levels.find(({ rings }) => insideRings(rings, x, z))?.raised ?? this.raised;
    }

    _nearest({ x, y, z }) {
        const [px, pz] = this.floor.nearestInside(x, z) ?? [x, z];
        return { x: px, y: this._height(y, this._raisedAt(px, pz)), z: pz };
    }

    // From one height of the floor to another: the eye goes along, not at once, and keeps its height above the floor.
    _climb(y, x, z, dt) {
        const before = this.raised;
        this.raised += (this._raisedAt(x, z) - before) * (dt === undefined ? 1 : 1 - Math.exp(-dt / CLIMB_S));
        return this._height(y - before) + this.raised;
    }

    listen(events) {
        const jump = () => {
            this.jumps = true;
        };
        events.on('inputEvent', (name) => {
            if (name === 'reset' || name === 'frame') jump();
        });
        events.on('cameraMode:changed', jump);
        events.on('pick', jump);
    }

    // After each step of a controller: holds the pose it wants and tells the controller, so that it goes on from there
    // and the way back is free at once.
    hold(mode, controller, camera, dt) {
        const wish = camera.position;
        let held;
        if (this.jumps || mode === 'anim' || !this.at) {
            held = this._nearest(wish);
            this.raised = this._raisedAt(held.x, held.z);
        } else {
            const [x, z] = this.floor.slide(this.at.x, this.at.z, wish.x, wish.z);
            held = { x, y: this._climb(wish.y, x, z, dt), z };
        }
        this.jumps = false;
        this.at = held;
        if (Math.hypot(held.x - wish.x, held.y - wish.y, held.z - wish.z) < 1e-9) return;
        if (mode === 'orbit') {
            // It goes on looking at what it turned around.
            const focus = wish.clone();
            camera.calcFocusPoint(focus);
            wish.set(held.x, held.y, held.z);
            if (wish.distance(focus) > 0.01) camera.look(wish.clone(), focus);
            controller.goto(camera);
            return;
        }
        wish.set(held.x, held.y, held.z);
        controller._position?.copy(wish);      // fly, walk
        controller._prevPosition?.copy(wish);  // walk, which blends between its last two steps
    }

    // A blend between two poses may lead over furniture or through a wall: the nearest place on the floor is shown.
    holdBlend(camera) {
        const held = this._nearest(camera.position);
        camera.position.set(held.x, held.y, held.z);
    }

    // Virtual reality: the headset moves the camera within its rig, which stands on the floor. Whether one goes by
    // thumbstick, by teleport or on one's own feet, the rig is moved so that the head stays over the walkable floor.
    holdRig(rig, camera) {
        const head = camera.getPosition();
        const [x, z] = this.floor.nearestInside(head.x, head.z) ?? [head.x, head.z];
        if (x !== head.x || z !== head.z) rig.translate(x - head.x, 0, z - head.z);
        if (this.levels.length === 0) return;
        this.raised = this._raisedAt(x, z);
        rig.translate(0, this.ground + this.raised - rig.getPosition().y, 0);
    }

    // Where one who was sent to a point looks while he walks there: at it, but never down to his own feet.
    walkTarget(point) {
        const target = point.clone();
        target.y = this._height(point.y, this._raisedAt(point.x, point.z));
        return target;
    }
}

export { WalkBounds, WalkableFloor };
