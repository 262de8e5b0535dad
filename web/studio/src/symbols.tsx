// How things are drawn in a floor plan: by kind, in their own frame. Their front points up, their middle is the origin.
import type { JSX } from 'preact';
import type { Thing } from './api';

export const luminance = (hex: string) => {
    const [r, g, b] = [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);
    return 0.3 * r + 0.59 * g + 0.11 * b;
};
// Towards a gray level.
export const mixed = (hex: string, level: number, share: number) =>
    `#${[1, 3, 5]
        .map((i) =>
            Math.round(parseInt(hex.slice(i, i + 2), 16) * (1 - share) + level * share)
                .toString(16)
                .padStart(2, '0'),
        )
        .join('')}`;
export const lineColor = (hex: string) => (luminance(hex) > 0.28 ? mixed(hex, 0, 0.5) : mixed(hex, 255, 0.45));

type Attributes = JSX.SVGAttributes<SVGRectElement>;
const least = 0.01; // metres: nothing is thinner
const rect = (x: number, y: number, w: number, h: number, r = 0.03, more: Attributes = {}) => (
    <rect x={x} y={y} width={Math.max(w, least)} height={Math.max(h, least)} rx={Math.min(r, w / 2, h / 2)} {...more} />
);

// What a drawing knows of its thing: width, depth, its left and back edge, its color and a lighter one.
interface Pen {
    w: number;
    d: number;
    x: number;
    y: number;
    color: string;
    light: string;
}
type Drawing = (pen: Pen) => JSX.Element;

const rug: Drawing = ({ w, d, x, y }) => (
    <g fill-opacity={0.75}>
        {rect(x, y, w, d, 0.04)}
        {rect(x + 0.08, y + 0.08, w - 0.16, d - 0.16, 0.03, { fill: 'none', 'stroke-opacity': 0.5 })}
    </g>
);

const bed: Drawing = ({ w, d, x, y, color, light }) => {
    const n = w > 1.3 ? 2 : 1,
        pillow = (w - 0.12 * (n + 1)) / n,
        deep = Math.min(0.42, d * 0.22);
    const pillows = Array.from({ length: n }, (_, i) =>
        rect(x + 0.12 + i * (pillow + 0.12), d / 2 - 0.16 - deep, pillow, deep, 0.08, {
            fill: mixed(color, 255, 0.75),
        }),
    );
    return (
        <g>
            {rect(x, y, w, d, 0.06)}
            {rect(x + 0.03, y + 0.03, w - 0.06, d - 0.12, 0.06, { fill: light })}
            {rect(x, d / 2 - 0.09, w, 0.09, 0.03)}
            {pillows}
            <path d={`M${x + 0.04} ${d / 2 - 0.3 - deep}H${-x - 0.04}`} fill="none" />
        </g>
    );
};

const sofa: Drawing = ({ w, d, x, y, light }) => {
    const arm = Math.min(0.16, w * 0.14),
        back = Math.min(0.22, d * 0.26);
    const seats = w > 1.9 ? 3 : w > 1.2 ? 2 : 1,
        one = (w - 2 * arm) / seats;
    return (
        <g>
            {rect(x, y + d * 0.08, w, d * 0.92, 0.08)}
            {Array.from({ length: seats }, (_, i) => rect(x + arm + i * one, y, one, d - back, 0.07, { fill: light }))}
            {rect(x, d / 2 - back, w, back, 0.08)}
        </g>
    );
};

const chair: Drawing = ({ w, d, x, y, light }) => (
    <g>
        {rect(x, y, w, d * 0.9, 0.09, { fill: light })}
        {rect(x, d / 2 - d * 0.2, w, d * 0.2, 0.06)}
    </g>
);

const plant: Drawing = ({ w, d, color }) => {
    const r = Math.min(w, d) / 2;
    return (
        <g>
            {[0, 60, 120, 180, 240, 300].map((a) => (
                <ellipse
                    key={a}
                    rx={r * 0.28}
                    ry={r * 0.5}
                    cy={-r * 0.5}
                    transform={`rotate(${a})`}
                    fill={mixed(color, 255, a % 120 ? 0.15 : 0.3)}
                />
            ))}
            <circle r={r * 0.2} />
        </g>
    );
};

const lamp: Drawing = ({ w, d, color }) => {
    const r = Math.min(w, d) / 2;
    return (
        <g>
            <circle r={r} fill={mixed(color, 255, 0.55)} />
            <circle r={r * 0.42} fill="#fff3cf" />
        </g>
    );
};

const shelves: Drawing = ({ w, d, x, y }) => {
    const backs = Array.from(
        { length: Math.floor(w / 0.12) },
        (_, i) => `M${x + 0.06 + i * 0.12} ${y + d * 0.2}V${y + d * 0.95}`,
    );
    return (
        <g>
            {rect(x, y, w, d, 0.02)}
            <path fill="none" d={backs.join('')} stroke-opacity={0.55} />
        </g>
    );
};

const cupboard: Drawing = ({ w, d, x, y, light }) => {
    const front = Math.min(0.07, d * 0.2);
    return (
        <g>
            {rect(x, y, w, d, 0.03)}
            {rect(x, y, w, front, 0.02, { fill: light })}
            {w > 0.9 && <path d={`M0 ${y}V${y + front}`} fill="none" />}
        </g>
    );
};

const table: Drawing = ({ w, d, x, y, light }) => (
    <g>
        {rect(x, y, w, d, 0.05)}
        {rect(x + 0.05, y + 0.05, w - 0.1, d - 0.1, 0.03, { fill: light, 'fill-opacity': 0.35, 'stroke-opacity': 0.4 })}
    </g>
);

const basin: Drawing = ({ w, d, x, y, light }) => (
    <g>
        {rect(x, y, w, d, 0.05)}
        {rect(x + 0.06, y + 0.06, w - 0.12, d - 0.12, 0.2, { fill: light })}
    </g>
);

const toilet: Drawing = ({ w, d, x, light }) => (
    <g>
        {rect(x, d / 2 - 0.2, w, 0.2, 0.03)}
        <ellipse rx={w * 0.44} ry={d * 0.36} cy={-d * 0.1} fill={light} />
    </g>
);

const round: Drawing = ({ w, d, light }) => <ellipse rx={w / 2} ry={d / 2} fill={light} />;
const box: Drawing = ({ w, d, x, y }) => rect(x, y, w, d, 0.03);
const hanging: Drawing = ({ w, d, color }) => (
    <g fill="none" stroke={lineColor(color)} stroke-dasharray="0.05 0.04">
        <circle r={Math.max(0.08, Math.min(w, d) / 2)} />
        <path d="M-0.06 0H0.06M0 -0.06V0.06" stroke-dasharray="none" />
    </g>
);

// The first that fits.
const drawings: [RegExp, Drawing][] = [
    [/rug|carpet|mat$/, rug],
    [/(^|_)bed|daybed|bunk|crib/, bed],
    [/sofa|couch|loveseat|settee|armchair|easy_chair|chaise/, sofa],
    [/stool|pouf/, round],
    [/chair|throne/, chair],
    [/plant|monstera|tree|palm|fern|cactus|flowers|bouquet/, plant],
    [/lamp|lantern|candle/, lamp],
    [/bookcase|shelf|shelves/, shelves],
    [
        /wardrobe|closet|cabinet|dresser|chest|sideboard|commode|nightstand|counter|vanity|fridge|stove|oven|washing/,
        cupboard,
    ],
    [/toilet/, toilet],
    [/bathtub|tub|basin|sink|shower/, basin],
    [/round_table/, round],
    [/table|desk/, table],
];

export const Symbol = ({ thing }: { thing: Thing }) => {
    const { kind, w, d, color, mount } = thing;
    const draw = mount === 'ceiling' ? hanging : (drawings.find(([kinds]) => kinds.test(kind))?.[1] ?? box);
    return (
        <g stroke={lineColor(color)} stroke-width={0.012} fill={color}>
            {draw({ w, d, x: -w / 2, y: -d / 2, color, light: mixed(color, 255, 0.45) })}
        </g>
    );
};
