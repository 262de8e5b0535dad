// The keys of a camera path.
import type { CameraKey, CameraPath, Point } from '../api';

const least_gap_s = 0.05; // between keys that are added

export const sorted = (keys: CameraKey[]) => [...keys].sort((a, b) => a.time_s - b.time_s);
export const lengthOf = (path: CameraPath) => path.keys[path.keys.length - 1].time_s - path.keys[0].time_s;
export const round = (value: number, digits: number) => Number(value.toFixed(digits));

// A key between its neighbours at `time_s`, where the camera passes (x, z) then, and its index among the keys. Null if
// a key is there already.
export const keyBetween = ({ keys }: CameraPath, time_s: number, [x, z]: Point) => {
    const before = Math.max(0, keys.filter((k) => k.time_s <= time_s).length - 1),
        a = keys[before],
        b = keys[Math.min(before + 1, keys.length - 1)];
    if ([a, b].some((k) => Math.abs(k.time_s - time_s) < least_gap_s)) return null;
    const w = b.time_s > a.time_s ? (time_s - a.time_s) / (b.time_s - a.time_s) : 0;
    const mix = (p: number, q: number) => round(p + w * (q - p), 3);
    const key: CameraKey = {
        time_s: round(time_s, 2),
        position_m: [round(x, 3), mix(a.position_m[1], b.position_m[1]), round(z, 3)],
        yaw_deg: mix(a.yaw_deg, b.yaw_deg),
        pitch_deg: mix(a.pitch_deg, b.pitch_deg),
    };
    return { key, index: before + 1 };
};
