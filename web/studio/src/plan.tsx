// A floor plan: walls, openings, and things in their colors, seen from above. Selected and moved where it may be edited.
// The far wall (+z) is at the top. The room's frame is right-handed with y up: seen from above, +x is at the left.
import type { JSX } from 'preact';
import { useMemo, useRef, useState } from 'preact/hooks';
import type { PlanView, Thing } from './api';
import { t } from './text';

const margin = 0.55;  // metres about the room: walls and dimensions
const thickness = 0.16;
const step = 0.05;  // of an arrow key

interface Props {
    view: PlanView; label: string; selected?: string; onSelect?: (id: string) => void;
    onMove?: (thing: Thing, x: number, z: number) => void; onTurn?: (thing: Thing, by: number) => void;
    onRemove?: (thing: Thing) => void; busy?: boolean;
}

const luminance = (hex: string) => {
    const [r, g, b] = [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);
    return 0.3 * r + 0.59 * g + 0.11 * b;
};
const mixed = (hex: string, other: number, share: number) =>
    `#${[1, 3, 5].map((i) => Math.round(parseInt(hex.slice(i, i + 2), 16) * (1 - share) + other * share).toString(16).padStart(2, '0')).join('')}`;
const line = (hex: string) => mixed(hex, luminance(hex) > 0.28 ? 0 : 255, luminance(hex) > 0.28 ? 0.5 : 0.45);

const rect = (x: number, y: number, w: number, h: number, r = 0.03, more: JSX.SVGAttributes<SVGRectElement> = {}) =>
    <rect x={x} y={y} width={Math.max(w, 0.01)} height={Math.max(h, 0.01)} rx={Math.min(r, w / 2, h / 2)} {...more} />;

const is = (kind: string, words: RegExp) => words.test(kind);

// In the thing's own frame: its front points up the page, its middle is the origin.
const symbol = ({ kind, w, d, color, mount }: Thing): JSX.Element => {
    const x = -w / 2, y = -d / 2;
    const light = mixed(color, 255, 0.45), s = { stroke: line(color), 'stroke-width': 0.012, fill: color };
    if (mount === 'ceiling') return <g fill="none" stroke={line(color)} stroke-width={0.012} stroke-dasharray="0.05 0.04">
        <circle r={Math.max(0.08, Math.min(w, d) / 2)} /><path d={`M${-0.06} 0H0.06M0 -0.06V0.06`} stroke-dasharray="none" /></g>;
    if (is(kind, /rug|carpet|mat$/)) return <g {...s} fill-opacity={0.75}>{rect(x, y, w, d, 0.04)}
        {rect(x + 0.08, y + 0.08, w - 0.16, d - 0.16, 0.03, { fill: 'none', 'stroke-opacity': 0.5 })}</g>;
    if (is(kind, /(^|_)bed|daybed|bunk|crib/)) {
        const n = w > 1.3 ? 2 : 1, pillow = (w - 0.12 * (n + 1)) / n, deep = Math.min(0.42, d * 0.22);
        return <g {...s}>{rect(x, y, w, d, 0.06)}
            {rect(x + 0.03, y + 0.03, w - 0.06, d - 0.12, 0.06, { fill: light })}
            {rect(x, d / 2 - 0.09, w, 0.09, 0.03)}
            {Array.from({ length: n }, (_, i) => rect(x + 0.12 + i * (pillow + 0.12), d / 2 - 0.16 - deep, pillow, deep, 0.08, { fill: mixed(color, 255, 0.75) }))}
            <path d={`M${x + 0.04} ${d / 2 - 0.3 - deep}H${-x - 0.04}`} fill="none" /></g>;
    }
    if (is(kind, /sofa|couch|loveseat|settee|armchair|easy_chair|chaise|bench_seat/)) {
        const arm = Math.min(0.16, w * 0.14), back = Math.min(0.22, d * 0.26);
        const seats = w > 1.9 ? 3 : w > 1.2 ? 2 : 1, one = (w - 2 * arm) / seats;
        return <g {...s}>{rect(x, y + d * 0.08, w, d * 0.92, 0.08)}
            {Array.from({ length: seats }, (_, i) => rect(x + arm + i * one, y, one, d - back, 0.07, { fill: light }))}
            {rect(x, d / 2 - back, w, back, 0.08)}</g>;
    }
    if (is(kind, /chair|stool|pouf|throne/)) return is(kind, /stool|pouf/)
        ? <g {...s}><ellipse rx={w / 2} ry={d / 2} fill={light} /></g>
        : <g {...s}>{rect(x, y, w, d * 0.9, 0.09, { fill: light })}{rect(x, d / 2 - d * 0.2, w, d * 0.2, 0.06)}</g>;
    if (is(kind, /plant|monstera|tree|palm|fern|cactus|flowers|bouquet/)) {
        const r = Math.min(w, d) / 2;
        return <g {...s}>{[0, 60, 120, 180, 240, 300].map((a) => <ellipse key={a} rx={r * 0.28} ry={r * 0.5} cy={-r * 0.5} transform={`rotate(${a})`} fill={mixed(color, 255, a % 120 ? 0.15 : 0.3)} />)}
            <circle r={r * 0.2} /></g>;
    }
    if (is(kind, /lamp|lantern|candle/)) {
        const r = Math.min(w, d) / 2;
        return <g {...s}><circle r={r} fill={mixed(color, 255, 0.55)} /><circle r={r * 0.42} fill="#fff3cf" /></g>;
    }
    if (is(kind, /bookcase|shelf|shelves/)) return <g {...s}>{rect(x, y, w, d, 0.02)}
        <path fill="none" d={Array.from({ length: Math.floor(w / 0.12) }, (_, i) => `M${x + 0.06 + i * 0.12} ${y + d * 0.2}V${y + d * 0.95}`).join('')} stroke-opacity={0.55} /></g>;
    if (is(kind, /wardrobe|closet|cabinet|dresser|chest|sideboard|commode|nightstand|counter|vanity|fridge|stove|oven|washing/))
        return <g {...s}>{rect(x, y, w, d, 0.03)}{rect(x, y, w, Math.min(0.07, d * 0.2), 0.02, { fill: light })}
            {w > 0.9 && <path d={`M0 ${y}V${y + Math.min(0.07, d * 0.2)}`} fill="none" />}</g>;
    if (is(kind, /toilet/)) return <g {...s}>{rect(x, d / 2 - 0.2, w, 0.2, 0.03)}<ellipse rx={w * 0.44} ry={d * 0.36} cy={-d * 0.1} fill={light} /></g>;
    if (is(kind, /bathtub|tub|basin|sink|shower/)) return <g {...s}>{rect(x, y, w, d, 0.05)}{rect(x + 0.06, y + 0.06, w - 0.12, d - 0.12, 0.2, { fill: light })}</g>;
    if (is(kind, /round_table/)) return <g {...s}><ellipse rx={w / 2} ry={d / 2} /></g>;
    if (is(kind, /table|desk/)) return <g {...s}>{rect(x, y, w, d, 0.05)}{rect(x + 0.05, y + 0.05, w - 0.1, d - 0.1, 0.03, { fill: light, 'fill-opacity': 0.35, 'stroke-opacity': 0.4 })}</g>;
    return <g {...s}>{rect(x, y, w, d, 0.03)}</g>;
};

const floorLines = ({ floor: own, floor_name }: PlanView) => {
    const floor = mixed(own, 255, 0.28);  // as on paper: things stand out
    const tone = { stroke: line(floor), 'stroke-width': 0.008, 'stroke-opacity': 0.28, fill: 'none' };
    if (/tile|stone|marble|terrazzo|slate|concrete|checker/.test(floor_name))
        return <pattern id="floor" width={0.5} height={0.5} patternUnits="userSpaceOnUse"><rect width={0.5} height={0.5} fill={floor} /><path d="M0 0H0.5M0 0V0.5" {...tone} /></pattern>;
    if (/carpet|rug|lino/.test(floor_name)) return <pattern id="floor" width={1} height={1} patternUnits="userSpaceOnUse"><rect width={1} height={1} fill={floor} /></pattern>;
    return <pattern id="floor" width={1.8} height={0.36} patternUnits="userSpaceOnUse"><rect width={1.8} height={0.36} fill={floor} />
        <path d="M0 0H1.8M0 0.18H1.8M0.3 0V0.18M1.2 0.18V0.36" {...tone} /></pattern>;
};

const label = (thing: Thing) => {
    if (thing.w * thing.d < 0.3 || thing.flat || thing.mount !== 'floor') return null;
    const words = thing.name.split(' '), two = thing.name.length * 0.075 > thing.w && words.length > 1;
    const dark = luminance(thing.color) < 0.42;
    return <text class="plan-name" x={-thing.cx} y={-thing.cz + 0.045} fill={dark ? '#fff' : '#1d1813'} stroke={dark ? '#0007' : '#fff9'}>
        {two ? words.map((word, i) => <tspan key={i} x={-thing.cx} dy={i ? 0.14 : -0.07 * (words.length - 1)}>{word}</tspan>) : thing.name}</text>;
};

export const Plan = ({ view, label: name, selected, onSelect, onMove, onTurn, onRemove, busy }: Props) => {
    const { width: w, depth: d } = view, svg = useRef<SVGSVGElement>(null);
    const [drag, setDrag] = useState<{ id: string; dx: number; dz: number } | null>(null);
    const from = useRef<{ x: number; y: number; moved: boolean } | null>(null);
    const things = view.things;
    const riders = useMemo(() => {
        const on = new Map<string, string>(things.map((thing) => [thing.id, thing.on]));
        return (id: string, root: string) => { for (let at: string | undefined = id; at; at = on.get(at)) if (at === root) return true; return false; };
    }, [view]);
    const metres = (event: PointerEvent) => {
        const m = svg.current!.getScreenCTM()!.inverse();
        const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(m);
        return { x: -p.x, y: p.y };
    };
    const down = (thing: Thing) => (event: PointerEvent) => {
        if (!onSelect) return;
        event.stopPropagation();
        onSelect(thing.id);
        if (!onMove || busy || event.button !== 0) return;
        const p = metres(event);
        from.current = { x: p.x, y: p.y, moved: false };
        (event.currentTarget as Element).setPointerCapture(event.pointerId);
        setDrag({ id: thing.id, dx: 0, dz: 0 });
    };
    const move = (event: PointerEvent) => {
        if (!drag || !from.current) return;
        const p = metres(event), dx = p.x - from.current.x, dz = from.current.y - p.y;
        if (Math.hypot(dx, dz) > 0.03) from.current.moved = true;
        if (from.current.moved) setDrag({ ...drag, dx, dz });
    };
    const up = (thing: Thing) => () => {
        if (drag && from.current?.moved) onMove?.(thing, thing.x + drag.dx, thing.z + drag.dz);
        from.current = null;
        setDrag(null);
    };
    const key = (thing: Thing) => (event: KeyboardEvent) => {
        const by = { ArrowLeft: [step, 0], ArrowRight: [-step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] }[event.key];
        if (by && onMove && !busy) onMove(thing, thing.x + by[0], thing.z + by[1]);
        else if ((event.key === 'r' || event.key === 'R') && !event.ctrlKey && !event.metaKey) onTurn?.(thing, event.shiftKey ? 15 : -15);
        else if (event.key === 'Delete' || event.key === 'Backspace') onRemove?.(thing);
        else if (event.key === 'Enter' || event.key === ' ') onSelect?.(thing.id);
        else return;
        event.preventDefault();
    };
    const x0 = -w / 2, y0 = -d / 2;
    return <svg ref={svg} class="plan" viewBox={`${x0 - margin} ${y0 - margin} ${w + 2 * margin} ${d + 2 * margin}`} role={onSelect ? 'group' : 'img'} aria-label={name}
        onPointerDown={() => onSelect?.('')}>
        <defs>{floorLines(view)}
        </defs>
        <g transform="scale(-1 1)">
        <rect class="plan-wall" x={x0 - thickness} y={y0 - thickness} width={w + 2 * thickness} height={d + 2 * thickness} rx={0.02} />
        <rect x={x0} y={y0} width={w} height={d} fill="url(#floor)" />
        {view.blocks.map((b, i) => <rect key={i} class="plan-wall" x={b.low[0] - 0.01} y={-b.high[1] - 0.01} width={b.high[0] - b.low[0] + 0.02} height={b.high[1] - b.low[1] + 0.02} />)}
        {view.openings.map((o, i) => {
            const [ax, az] = o.a, [bx, bz] = o.b, long = Math.hypot(bx - ax, bz - az);
            const angle = Math.atan2(-(bz - az), bx - ax) * 180 / Math.PI;
            // Along the wall from a to b; outside is at negative y of this frame.
            return <g key={i} transform={`translate(${ax} ${-az}) rotate(${angle})`} class={`plan-${o.kind}`}>
                <rect class="plan-gap" x={0} y={-thickness - 0.01} width={long} height={thickness + 0.02} />
                {o.kind === 'window' && <path d={`M0 ${-thickness}H${long}M0 ${-thickness / 2}H${long}M0 0H${long}`} />}
                {o.kind === 'door' && <path d={`M0 0V${long}A${long} ${long} 0 0 0 ${long} 0`} fill="none" />}</g>;
        })}
        {things.map((thing) => {
            const carried = drag && riders(thing.id, drag.id);
            const [dx, dz] = carried ? [drag.dx, drag.dz] : [0, 0];
            const chosen = selected === thing.id;
            return <g key={thing.id} class={`plan-thing ${chosen ? 'is-selected' : ''} ${thing.mount === 'ceiling' && !chosen ? 'is-above' : ''}`}
                transform={`translate(${thing.cx + dx} ${-thing.cz - dz}) rotate(${thing.yaw_deg})`}
                {...(onSelect ? { tabIndex: 0, role: 'button', 'aria-pressed': chosen, 'aria-label': thing.id.replace(/-/g, ' '), onPointerDown: down(thing), onPointerMove: move, onPointerUp: up(thing), onKeyDown: key(thing), onFocus: () => !from.current && onSelect(thing.id) } : {})}>
                {symbol(thing)}
                {onSelect && <rect class="plan-hit" x={-Math.max(thing.w, 0.2) / 2} y={-Math.max(thing.d, 0.2) / 2} width={Math.max(thing.w, 0.2)} height={Math.max(thing.d, 0.2)} rx={0.04} />}
            </g>;
        })}
        </g>
        <g aria-hidden="true">{things.map((thing) => (!drag || !riders(thing.id, drag.id)) && <g key={thing.id}>{label(thing)}</g>)}
            <g class="plan-dimension">
                <path d={`M${x0} ${y0 - 0.34}H${-x0}M${x0} ${y0 - 0.39}v0.1M${-x0} ${y0 - 0.39}v0.1M${x0 - 0.34} ${y0}V${-y0}M${x0 - 0.39} ${y0}h0.1M${x0 - 0.39} ${-y0}h0.1`} />
                <text x={0} y={y0 - 0.4}>{w.toFixed(2)} {t.metres}</text>
                <text transform={`translate(${x0 - 0.4} 0) rotate(-90)`}>{d.toFixed(2)} {t.metres}</text></g></g>
    </svg>;
};
