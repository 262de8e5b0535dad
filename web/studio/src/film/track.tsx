// The camera path on the plan: where one can walk, the way between the keys, and the keys, to be moved and turned.
import { useMemo, useState } from 'preact/hooks';
import type { Film, PlanView, Point } from '../api';
import { t } from '../text';

const step_m = 0.05; // of an arrow key
const turn_deg = 15;
const least_drag_m = 0.03; // less is a click
const cone_m = 0.45; // length of the drawn field of view
const rad = Math.PI / 180;

// Between the world (x right and z ahead of the first panorama) and the plan's room.
const frameOf = ({ camera: [cx, cz], looks: [lx, lz] }: PlanView) => {
    const long = Math.hypot(lx, lz) || 1,
        f: Point = [lx / long, lz / long],
        r: Point = [-f[1], f[0]];
    return {
        toRoom: (x: number, z: number): Point => [cx + x * r[0] + z * f[0], cz + x * r[1] + z * f[1]],
        toWorld: (x: number, z: number): Point => {
            const dx = x - cx,
                dz = z - cz;
            return [dx * r[0] + dz * r[1], dx * f[0] + dz * f[1]];
        },
    };
};

// Of a scene from pictures, nothing is known but where one can walk.
export const bareView = (rings: Point[][]): PlanView => {
    const reach = (c: 0 | 1) => 2 * Math.max(0.5, ...rings.flat().map((p) => Math.abs(p[c]))) + 1;
    return {
        width: reach(0),
        depth: reach(1),
        height: 0,
        floor: '#cfc9c0',
        floor_name: 'carpet',
        wall: '',
        type: '',
        style: '',
        hour: '',
        blocks: [],
        openings: [],
        camera: [0, 0],
        looks: [0, 1],
        things: [],
    };
};

interface Shown {
    film: Film;
    view: PlanView;
    selected: number;
    at: Point | null; // where the camera is now, world
    onSelect: (index: number) => void;
    onMove: (index: number, x: number, z: number) => void;
    onTurn: (index: number, by_deg: number) => void;
    onRemove: (index: number) => void;
}

export const Track = ({ film, view, selected, at, onSelect, onMove, onTurn, onRemove }: Shown) => {
    const frame = useMemo(() => frameOf(view), [view]);
    const [drag, setDrag] = useState<{ index: number; to: Point } | null>(null);
    const on = ([x, z]: Point): string => `${x.toFixed(3)} ${(-z).toFixed(3)}`;
    const metres = (event: PointerEvent): Point => {
        const svg = (event.currentTarget as SVGElement).ownerSVGElement!;
        const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()!.inverse());
        return [-p.x, -p.y];
    };
    const line = (keep: (free: boolean) => boolean) =>
        film.track
            .slice(1)
            .map(([x, z, free], i) => {
                const [ax, az] = film.track[i];
                return keep(free) ? `M${on(frame.toRoom(ax, az))}L${on(frame.toRoom(x, z))}` : '';
            })
            .join('');
    const key = (event: KeyboardEvent, index: number) => {
        const by = { ArrowLeft: [step_m, 0], ArrowRight: [-step_m, 0], ArrowUp: [0, step_m], ArrowDown: [0, -step_m] }[
            event.key
        ];
        const [x, , z] = film.path.keys[index].position_m,
            p = frame.toRoom(x, z);
        if (by) onMove(index, ...frame.toWorld(p[0] + by[0], p[1] + by[1]));
        else if (event.key === 'r' || event.key === 'R') onTurn(index, event.shiftKey ? -turn_deg : turn_deg);
        else if (event.key === 'Delete' || event.key === 'Backspace') onRemove(index);
        else if (event.key === 'Enter' || event.key === ' ') onSelect(index);
        else return;
        event.preventDefault();
    };
    return (
        <g class="film-track">
            <path
                class="film-floor"
                fill-rule="evenodd"
                d={film.rings.map((ring) => `M${ring.map(([x, z]) => on(frame.toRoom(x, z))).join('L')}Z`).join('')}
            />
            <path class="film-line" d={line((free) => free)} />
            <path class="film-line is-out" d={line((free) => !free)} />
            {film.path.keys.map((one, i) => {
                const p = drag?.index === i ? drag.to : frame.toRoom(one.position_m[0], one.position_m[2]);
                const half = ((one.fov_deg || film.path.fov_deg) / 2) * rad,
                    yaw = one.yaw_deg * rad;
                const ray = (angle: number) => {
                    const [ax, az] = frame.toRoom(0, 0),
                        [bx, bz] = frame.toRoom(cone_m * Math.sin(angle), cone_m * Math.cos(angle));
                    return on([p[0] + bx - ax, p[1] + bz - az]);
                };
                return (
                    <g key={i} class={`film-key ${i === selected ? 'is-selected' : ''}`}>
                        {i === selected && (
                            <path class="film-cone" d={`M${on(p)}L${ray(yaw - half)}L${ray(yaw + half)}Z`} />
                        )}
                        <circle
                            cx={p[0]}
                            cy={-p[1]}
                            r={i === selected ? 0.1 : 0.065}
                            tabIndex={0}
                            role="button"
                            aria-pressed={i === selected}
                            aria-label={`${t.film_key} ${i + 1}, ${one.time_s.toFixed(1)} s`}
                            onFocus={() => onSelect(i)}
                            onKeyDown={(e) => key(e, i)}
                            onPointerDown={(e) => {
                                e.stopPropagation();
                                onSelect(i);
                                (e.currentTarget as Element).setPointerCapture(e.pointerId);
                                setDrag({ index: i, to: p });
                            }}
                            onPointerMove={(e) => drag?.index === i && setDrag({ index: i, to: metres(e) })}
                            onPointerUp={() => {
                                const from = frame.toRoom(one.position_m[0], one.position_m[2]);
                                const to = drag?.index === i ? drag.to : from;
                                if (Math.hypot(to[0] - from[0], to[1] - from[1]) > least_drag_m)
                                    onMove(i, ...frame.toWorld(...to));
                                setDrag(null);
                            }}
                        />
                    </g>
                );
            })}
            {at && <circle class="film-now" cx={frame.toRoom(...at)[0]} cy={-frame.toRoom(...at)[1]} r={0.05} />}
        </g>
    );
};
