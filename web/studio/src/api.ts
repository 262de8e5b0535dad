// What the server says and is asked: src/fastscene/studio/api.h.

export interface Scene {
    name: string;
    title: string;
    kind: string;
    seed: number;
    quality: string;
    finished: boolean;
    has_room: boolean;
    has_walk: boolean;
    has_panorama: boolean;
    picture: string;
    made: number;
    seconds: number;
    peak_memory_bytes: number;
    from: string;
    changes: Change[];
    psnr?: number;
}
export interface Download {
    id: string;
    group: string;
    file: string;
    about: string;
    bytes: number | null;
    command: string;
}
export interface SceneDetails extends Scene {
    downloads: Download[];
    command: string;
    has_before: boolean;
}
export interface Change {
    id: string;
    what: string;
}
export interface Job {
    id: string;
    state: 'waiting' | 'running' | 'stopped' | 'failed' | 'finished';
    error: string;
    work: string;
    overall: number;
    seconds_left: number;
    seconds: number;
    warnings: string[];
    picture: '' | 'look' | 'panorama' | 'splats';
    picture_version: number;
    request: { title: string; seed: number; quality: string; from: string; command: string; changes?: Change[] };
}
export interface Cost {
    quality: string;
    seconds: number;
    gib: number;
    measured: number;
}
export interface State {
    version: string;
    folder: string;
    threads: number;
    free_memory_bytes: number;
    costs: Cost[];
    scenes: Scene[];
    trash: string[];
    jobs: Job[];
    most_upload_bytes: number;
    choices: { styles: string[]; hours: string[]; kinds: string[] };
}
export type Point = [number, number];
export interface Thing {
    id: string;
    kind: string;
    name: string;
    x: number;
    z: number;
    yaw_deg: number;
    cx: number;
    cz: number;
    w: number;
    d: number;
    y: number;
    h: number;
    mount: 'floor' | 'wall' | 'ceiling' | 'surface';
    on: string;
    color: string;
    color_name: string;
    material: string;
    flat: boolean;
    overhead: boolean;
    asked: boolean;
}
export interface PlanView {
    width: number;
    depth: number;
    height: number;
    floor: string;
    floor_name: string;
    wall: string;
    type: string;
    style: string;
    hour: string;
    blocks: Point[][]; // outlines of what is not room
    openings: { kind: 'window' | 'door' | 'doorway'; wall: number; a: Point; b: Point }[];
    camera: Point;
    looks: Point;
    things: Thing[];
}
export interface Word {
    words: string;
    fate: 'understood' | 'approximated' | 'not_understood';
    meaning: string;
}
export interface Reading {
    words: Word[];
    not_placed: string[];
    assumed: string[];
    view: PlanView;
    room: string;
    style: string;
    time: string;
    ms: number;
}
export interface CameraKey {
    time_s: number;
    position_m: [number, number, number]; // world: right, down and ahead of the first panorama
    yaw_deg: number;
    pitch_deg: number;
    roll_deg?: number;
    fov_deg?: number;
}
export interface CameraPath {
    fps: number;
    fov_deg: number;
    size: Point;
    keys: CameraKey[];
}
export interface Film {
    path: CameraPath;
    track: [number, number, boolean][]; // x, z, whether one can be there
    rings: Point[][];
    low_m: number;
    high_m: number;
    floor_y: number;
    view: PlanView | null;
    made: { file: string; bytes: number } | null;
}
export interface FilmWork {
    scene: string;
    what: 'film' | 'trace';
    time_s?: number;
    state: '' | 'running' | 'finished' | 'failed' | 'stopped';
    overall: number;
    seconds_left: number;
    error: string;
}
export interface Draft {
    revision: number;
    view: PlanView;
    changes: Change[];
    can_undo: boolean;
    can_redo: boolean;
}
export interface Upload {
    id: string;
    name: string;
    width: number;
    height: number;
    warnings?: string[];
}

export class Refused extends Error {
    constructor(
        text: string,
        readonly status: number,
    ) {
        super(text);
    }
}

const read = async (response: Response) => {
    const json = await response.json().catch(() => ({}));
    if (!response.ok) throw new Refused(json.error ?? `HTTP ${response.status}`, response.status);
    return json;
};
export const part = encodeURIComponent;

export const get = async <T>(path: string, signal?: AbortSignal): Promise<T> =>
    read(await fetch(`/api/${path}`, { signal }));

export const post = async <T>(path: string, body: unknown = {}, signal?: AbortSignal): Promise<T> =>
    read(
        await fetch(`/api/${path}`, {
            method: 'POST',
            headers: { 'Content-Type': 'application/json' },
            body: JSON.stringify(body),
            signal,
        }),
    );

export const upload = async (kind: 'panorama' | 'range', file: File): Promise<Upload> =>
    read(
        await fetch(`/api/upload/${kind}?name=${part(file.name)}`, {
            method: 'POST',
            headers: { 'Content-Type': 'application/octet-stream' },
            body: file,
        }),
    );

export const fileUrl = (scene: string, file: string) => `/files/${part(scene)}/${file.split('/').map(part).join('/')}`;
