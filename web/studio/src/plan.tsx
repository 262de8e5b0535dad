// A floor plan: walls, openings, and things in their colors, seen from above. Selected and moved where it may be edited.
// The far wall (+z) is at the top. The room's frame is right-handed with y up: seen from above, +x is at the left.
import type { ComponentChildren, RefObject } from 'preact';
import { useMemo, useRef, useState } from 'preact/hooks';
import type { PlanView, Thing } from './api';
import { lineColor, luminance, mixed, Symbol } from './symbols';
import { t } from './text';

const margin = 0.55; // metres about the room: walls and dimensions
const thickness = 0.16;
const step = 0.05; // of an arrow key
const turn_deg = 15;
const least_hit = 0.2; // metres: smaller things are caught, too

interface Props {
    view: PlanView;
    label: string;
    selected?: string;
    onSelect?: (id: string) => void;
    onMove?: (thing: Thing, x: number, z: number) => void;
    onTurn?: (thing: Thing, by_deg: number) => void;
    onRemove?: (thing: Thing) => void;
    busy?: boolean;
    children?: ComponentChildren; // drawn over the things, in metres; +x at the left
}

const FloorPattern = ({ view: { floor: own, floor_name } }: { view: PlanView }) => {
    const floor = mixed(own, 255, 0.28); // as on paper: things stand out
    const tone = { stroke: lineColor(floor), 'stroke-width': 0.008, 'stroke-opacity': 0.28, fill: 'none' };
    if (/tile|stone|marble|terrazzo|slate|concrete|checker/.test(floor_name))
        return (
            <pattern id="floor" width={0.5} height={0.5} patternUnits="userSpaceOnUse">
                <rect width={0.5} height={0.5} fill={floor} />
                <path d="M0 0H0.5M0 0V0.5" {...tone} />
            </pattern>
        );
    if (/carpet|rug|lino/.test(floor_name))
        return (
            <pattern id="floor" width={1} height={1} patternUnits="userSpaceOnUse">
                <rect width={1} height={1} fill={floor} />
            </pattern>
        );
    return (
        <pattern id="floor" width={1.8} height={0.36} patternUnits="userSpaceOnUse">
            <rect width={1.8} height={0.36} fill={floor} />
            <path d="M0 0H1.8M0 0.18H1.8M0.3 0V0.18M1.2 0.18V0.36" {...tone} />
        </pattern>
    );
};

const Label = ({ thing }: { thing: Thing }) => {
    if (thing.w * thing.d < 0.3 || thing.flat || thing.mount !== 'floor') return null;
    const words = thing.name.split(' '),
        two = thing.name.length * 0.075 > thing.w && words.length > 1;
    const dark = luminance(thing.color) < 0.42;
    return (
        <text
            class="plan-name"
            x={-thing.cx}
            y={-thing.cz + 0.045}
            fill={dark ? '#fff' : '#1d1813'}
            stroke={dark ? '#0007' : '#fff9'}
        >
            {two
                ? words.map((word, i) => (
                      <tspan key={i} x={-thing.cx} dy={i ? 0.14 : -0.07 * (words.length - 1)}>
                          {word}
                      </tspan>
                  ))
                : thing.name}
        </text>
    );
};

const Openings = ({ view }: { view: PlanView }) => (
    <>
        {view.openings.map((o, i) => {
            const [ax, az] = o.a,
                [bx, bz] = o.b,
                long = Math.hypot(bx - ax, bz - az);
            const angle = (Math.atan2(az - bz, bx - ax) * 180) / Math.PI;
            // Along the wall from a to b; outside is at negative y of this frame.
            return (
                <g key={i} transform={`translate(${ax} ${-az}) rotate(${angle})`} class={`plan-${o.kind}`}>
                    <rect class="plan-gap" x={0} y={-thickness - 0.01} width={long} height={thickness + 0.02} />
                    {o.kind === 'window' && (
                        <path d={`M0 ${-thickness}H${long}M0 ${-thickness / 2}H${long}M0 0H${long}`} />
                    )}
                    {o.kind === 'door' && <path d={`M0 0V${long}A${long} ${long} 0 0 0 ${long} 0`} fill="none" />}
                </g>
            );
        })}
    </>
);

const Shell = ({ view, x0, y0 }: { view: PlanView; x0: number; y0: number }) => (
    <>
        <rect
            class="plan-wall"
            x={x0 - thickness}
            y={y0 - thickness}
            width={view.width + 2 * thickness}
            height={view.depth + 2 * thickness}
            rx={0.02}
        />
        <rect x={x0} y={y0} width={view.width} height={view.depth} fill="url(#floor)" />
        {view.blocks.map((outline, i) => (
            <polygon
                key={i}
                class="plan-wall plan-block"
                points={outline.map(([x, z]) => `${x},${-z}`).join(" ")}
            />
        ))}
        <Openings view={view} />
    </>
);

const Dimensions = ({ view, x0, y0 }: { view: PlanView; x0: number; y0: number }) => (
    <g class="plan-dimension">
        <path
            d={`M${x0} ${y0 - 0.34}H${-x0}M${x0} ${y0 - 0.39}v0.1M${-x0} ${y0 - 0.39}v0.1M${x0 - 0.34} ${y0}V${-y0}M${x0 - 0.39} ${y0}h0.1M${x0 - 0.39} ${-y0}h0.1`}
        />
        <text x={0} y={y0 - 0.4}>
            {view.width.toFixed(2)} {t.metres}
        </text>
        <text transform={`translate(${x0 - 0.4} 0) rotate(-90)`}>
            {view.depth.toFixed(2)} {t.metres}
        </text>
    </g>
);

interface Drag {
    id: string;
    dx: number;
    dz: number;
}
const least_drag = 0.03; // metres: less is a click

// Dragging with mouse, finger or pen, in metres of the room.
const useDrag = (svg: RefObject<SVGSVGElement>, { onSelect, onMove, busy }: Props) => {
    const [drag, setDrag] = useState<Drag | null>(null);
    const from = useRef<{ x: number; z: number; moved: boolean } | null>(null);
    const metres = (event: PointerEvent) => {
        const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.current!.getScreenCTM()!.inverse());
        return { x: -p.x, z: -p.y };
    };
    const down = (thing: Thing) => (event: PointerEvent) => {
        event.stopPropagation();
        onSelect?.(thing.id);
        if (!onMove || busy || event.button !== 0) return;
        from.current = { ...metres(event), moved: false };
        (event.currentTarget as Element).setPointerCapture(event.pointerId);
        setDrag({ id: thing.id, dx: 0, dz: 0 });
    };
    const move = (event: PointerEvent) => {
        if (!drag || !from.current) return;
        const p = metres(event),
            dx = p.x - from.current.x,
            dz = p.z - from.current.z;
        if (Math.hypot(dx, dz) > least_drag) from.current.moved = true;
        if (from.current.moved) setDrag({ ...drag, dx, dz });
    };
    const up = (thing: Thing) => () => {
        if (drag && from.current?.moved) onMove?.(thing, thing.x + drag.dx, thing.z + drag.dz);
        from.current = null;
        setDrag(null);
    };
    return { drag, down, move, up, isDragging: () => from.current !== null };
};

const keyOf =
    (thing: Thing, { onSelect, onMove, onTurn, onRemove, busy }: Props) =>
    (event: KeyboardEvent) => {
        const by = { ArrowLeft: [step, 0], ArrowRight: [-step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] }[
            event.key
        ];
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (by && onMove) {
            if (!busy) onMove(thing, thing.x + by[0], thing.z + by[1]);
        } else if (event.key === 'r' || event.key === 'R') onTurn?.(thing, event.shiftKey ? turn_deg : -turn_deg);
        else if (event.key === 'Delete' || event.key === 'Backspace') onRemove?.(thing);
        else if (event.key === 'Enter' || event.key === ' ') onSelect?.(thing.id);
        else return;
        event.preventDefault();
    };

export const Plan = (props: Props) => {
    const { view, label, selected, onSelect } = props,
        { width: w, depth: d, things } = view;
    const svg = useRef<SVGSVGElement>(null);
    const { drag, down, move, up, isDragging } = useDrag(svg, props);
    // What stands on a thing, and on that, goes along.
    const rides = useMemo(() => {
        const on = new Map(things.map((thing) => [thing.id, thing.on]));
        return (id: string, root: string) => {
            for (let at: string | undefined = id; at; at = on.get(at)) if (at === root) return true;
            return false;
        };
    }, [view]);
    const draw = (thing: Thing) => {
        const isCarried = drag !== null && rides(thing.id, drag.id),
            isChosen = selected === thing.id;
        const x = thing.cx + (isCarried ? drag.dx : 0),
            z = thing.cz + (isCarried ? drag.dz : 0);
        const hit = [Math.max(thing.w, least_hit), Math.max(thing.d, least_hit)];
        const controls = onSelect
            ? {
                  tabIndex: 0,
                  role: 'button' as const,
                  'aria-pressed': isChosen,
                  'aria-label': thing.id.replace(/-/g, ' '),
                  onPointerDown: down(thing),
                  onPointerMove: move,
                  onPointerUp: up(thing),
                  onKeyDown: keyOf(thing, props),
                  onFocus: () => {
                      if (!isDragging()) onSelect(thing.id);
                  },
              }
            : {};
        return (
            <g
                key={thing.id}
                class={`plan-thing ${isChosen ? 'is-selected' : ''} ${thing.mount === 'ceiling' && !isChosen ? 'is-above' : ''}`}
                transform={`translate(${x} ${-z}) rotate(${thing.yaw_deg})`}
                {...controls}
            >
                <Symbol thing={thing} />
                {onSelect && (
                    <rect class="plan-hit" x={-hit[0] / 2} y={-hit[1] / 2} width={hit[0]} height={hit[1]} rx={0.04} />
                )}
            </g>
        );
    };
    const x0 = -w / 2,
        y0 = -d / 2;
    return (
        <svg
            ref={svg}
            class="plan"
            viewBox={`${x0 - margin} ${y0 - margin} ${w + 2 * margin} ${d + 2 * margin}`}
            role={onSelect || props.children ? 'group' : 'img'}
            aria-label={label}
            onPointerDown={() => onSelect?.('')}
        >
            <defs>
                <FloorPattern view={view} />
            </defs>
            <g transform="scale(-1 1)">
                <Shell view={view} x0={x0} y0={y0} />
                {things.map(draw)}
            </g>
            {props.children && <g transform="scale(-1 1)">{props.children}</g>}
            <g aria-hidden="true">
                {things.map((thing) => !(drag && rides(thing.id, drag.id)) && <Label key={thing.id} thing={thing} />)}
                <Dimensions view={view} x0={x0} y0={y0} />
            </g>
        </svg>
    );
};
