// A film of the scene: its camera path on the plan, key by key, what the camera sees, and the film made of it.
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { get, part, post, type CameraKey, type CameraPath, type Film, type PlanView, type Point, type SceneDetails } from './api';
import { Plan } from './plan';
import { fail, useShared } from './store';
import { clock, size, t } from './text';

const kinds = ['tour', 'walkthrough', 'orbit'] as const;
const formats = ['fastscene', 'blender', 'nerfstudio', 'supersplat'] as const;
const frame_px = 640;
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
const bareView = (rings: Point[][]): PlanView => {
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

const sorted = (keys: CameraKey[]) => [...keys].sort((a, b) => a.time_s - b.time_s);
const lengthOf = (path: CameraPath) => path.keys[path.keys.length - 1].time_s - path.keys[0].time_s;
const round = (value: number, digits: number) => Number(value.toFixed(digits));

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

const Track = ({ film, view, selected, at, onSelect, onMove, onTurn, onRemove }: Shown) => {
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
                        {i === selected && <path class="film-cone" d={`M${on(p)}L${ray(yaw - half)}L${ray(yaw + half)}Z`} />}
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
                                if (drag?.index === i && Math.hypot(drag.to[0] - from[0], drag.to[1] - from[1]) > least_drag_m)
                                    onMove(i, ...frame.toWorld(...drag.to));
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

// The room behind the scene, traced from where the camera is, beside the splats.
const Traced = ({ scene, time_s, picture }: { scene: string; time_s: number; picture: string }) => {
    const { film: work } = useShared();
    const [share, setShare] = useState(50);
    const mine = work?.scene === scene && work.what === 'trace';
    if (mine && work.state === 'running')
        return (
            <div class="row">
                <progress class="grow" max="1" value={work.overall || undefined} aria-label={t.film_trace} />
                <button onClick={() => post(`scenes/${part(scene)}/film/stop`).catch(fail)}>{t.stop}</button>
            </div>
        );
    const shown = mine && work.state === 'finished' && Math.abs(work.time_s! - time_s) < 1e-3;
    return (
        <>
            {mine && work.state === 'failed' && (
                <p class="problem" role="alert">
                    {work.error}
                </p>
            )}
            {shown ? (
                <figure class="film-compare">
                    <div style={{ '--share': `${share}%` }}>
                        <img src={picture} alt={t.film_frame} />
                        <img
                            class="is-over"
                            src={`/api/scenes/${part(scene)}/film/traced?${time_s}`}
                            alt={t.film_traced}
                        />
                    </div>
                    <label class="row">
                        {t.film_splats}
                        <input
                            class="grow"
                            type="range"
                            min={0}
                            max={100}
                            value={share}
                            aria-label={t.film_compare}
                            onInput={(e) => setShare(Number(e.currentTarget.value))}
                        />
                        {t.film_traced}
                    </label>
                </figure>
            ) : (
                <button onClick={() => post(`scenes/${part(scene)}/film/trace`, { time_s }).catch(fail)}>
                    {t.film_trace}
                </button>
            )}
        </>
    );
};

// What the camera sees at a time: the newest one that is wanted, one request at a time.
const useFrame = (scene: string, time_s: number, version: number) => {
    const [picture, setPicture] = useState(''),
        [shown_s, setShown] = useState(-1);
    const wanted = useRef({ time_s, version }),
        busy = useRef(false);
    wanted.current = { time_s, version };
    const fetchNext = async () => {
        if (busy.current) return;
        busy.current = true;
        const now = wanted.current;
        try {
            const { jpeg } = await post<{ jpeg: string }>(`scenes/${part(scene)}/film/frame`, {
                time_s: now.time_s,
                width: frame_px,
            });
            setPicture(`data:image/jpeg;base64,${jpeg}`);
            setShown(now.time_s);
        } catch (error) {
            fail(error);
            busy.current = false;
            return;
        }
        busy.current = false;
        if (wanted.current.time_s !== now.time_s || wanted.current.version !== now.version) fetchNext();
    };
    useEffect(() => {
        fetchNext();
    }, [scene, time_s, version]);
    return { picture, shown_s };
};

const Amount = ({
    label,
    value,
    step,
    low,
    high,
    onSet,
}: {
    label: string;
    value: number;
    step: number;
    low: number;
    high: number;
    onSet: (value: number) => void;
}) => (
    <label>
        {label}
        <input
            type="number"
            value={value}
            step={step}
            min={low}
            max={high}
            onChange={(e) => {
                const next = Number(e.currentTarget.value);
                if (e.currentTarget.value !== '' && Number.isFinite(next)) onSet(Math.min(high, Math.max(low, next)));
            }}
        />
    </label>
);

const KeyPanel = ({
    film,
    index,
    change,
    onRemove,
}: {
    film: Film;
    index: number;
    change: (key: Partial<CameraKey>) => void;
    onRemove: () => void;
}) => {
    const key = film.path.keys[index];
    const [x, y, z] = key.position_m;
    return (
        <section>
            <div class="row">
                <h2 class="small-title grow">
                    {t.film_key} {index + 1} / {film.path.keys.length}
                </h2>
                <button class="quiet" disabled={film.path.keys.length < 2} onClick={onRemove}>
                    {t.remove}
                </button>
            </div>
            <div class="fields two">
                <Amount
                    label={`${t.film_time} (s)`}
                    value={round(key.time_s, 2)}
                    step={0.1}
                    low={0}
                    high={3600}
                    onSet={(time_s) => change({ time_s })}
                />
                <Amount
                    label={`${t.film_height} (m)`}
                    value={round(film.floor_y - y, 2)}
                    step={0.05}
                    low={0.05}
                    high={20}
                    onSet={(high) => change({ position_m: [x, film.floor_y - high, z] })}
                />
                <Amount
                    label={`${t.film_yaw} (°)`}
                    value={round(key.yaw_deg, 1)}
                    step={5}
                    low={-3600}
                    high={3600}
                    onSet={(yaw_deg) => change({ yaw_deg })}
                />
                <Amount
                    label={`${t.film_pitch} (°)`}
                    value={round(key.pitch_deg, 1)}
                    step={5}
                    low={-89}
                    high={89}
                    onSet={(pitch_deg) => change({ pitch_deg })}
                />
            </div>
            <p class="hint">{t.film_keys_help}</p>
        </section>
    );
};

const sizes: [number, number][] = [
    [1280, 720],
    [1920, 1080],
    [3840, 2160],
    [1080, 1920],
    [1080, 1080],
];

const PathPanel = ({ film, plan, change, scene, onRead }: {
    film: Film;
    scene: string;
    plan: (kind: string) => void;
    change: (path: Partial<CameraPath>) => void;
    onRead: (text: string) => void;
}) => {
    const now = film.path.size.join(' × ');
    const all = sizes.map((s) => s.join(' × '));
    return (
        <section>
            <h2 class="small-title">{t.film_path}</h2>
            <div class="row">
                {kinds.map((kind) => (
                    <button key={kind} onClick={() => plan(kind)}>
                        {t.film_kinds[kind]}
                    </button>
                ))}
            </div>
            <div class="fields two">
                <label>
                    {t.size}
                    <select
                        value={now}
                        onChange={(e) => change({ size: e.currentTarget.value.split(' × ').map(Number) as Point })}
                    >
                        {[...new Set([now, ...all])].map((one) => (
                            <option key={one}>{one}</option>
                        ))}
                    </select>
                </label>
                <label>
                    {t.film_fps}
                    <select value={film.path.fps} onChange={(e) => change({ fps: Number(e.currentTarget.value) })}>
                        {[...new Set([film.path.fps, 24, 25, 30, 60])].map((one) => (
                            <option key={one} value={one}>
                                {round(one, 3)}
                            </option>
                        ))}
                    </select>
                </label>
                <Amount
                    label={`${t.film_fov} (°)`}
                    value={round(film.path.fov_deg, 1)}
                    step={5}
                    low={10}
                    high={140}
                    onSet={(fov_deg) => change({ fov_deg, keys: film.path.keys.map(({ fov_deg: _, ...key }) => key) })}
                />
                <Amount
                    label={`${t.film_length} (s)`}
                    value={round(lengthOf(film.path), 1)}
                    step={1}
                    low={0.5}
                    high={600}
                    onSet={(seconds) => {
                        const by = seconds / Math.max(lengthOf(film.path), 1e-3);
                        change({ keys: film.path.keys.map((k) => ({ ...k, time_s: round(k.time_s * by, 3) })) });
                    }}
                />
            </div>
            <p class="hint">{t.film_save}</p>
            <div class="row film-formats">
                {formats.map((format) => (
                    <a key={format} class="button" href={`/api/scenes/${part(scene)}/film/${format}`} download>
                        {t.film_formats[format]}
                    </a>
                ))}
                <label class="button">
                    {t.film_open}
                    <input
                        type="file"
                        accept=".json,.chan"
                        class="visually-hidden"
                        onChange={async (e) => {
                            const file = e.currentTarget.files?.[0];
                            if (file) onRead(await file.text());
                            e.currentTarget.value = '';
                        }}
                    />
                </label>
            </div>
        </section>
    );
};

const MakePanel = ({ scene, film }: { scene: string; film: Film }) => {
    const { film: work } = useShared();
    const mine = work?.scene === scene && work.what === 'film';
    const running = mine && work.state === 'running';
    const url = `/api/scenes/${part(scene)}/film/made`;
    const start = (ending: string) => post(`scenes/${part(scene)}/film/make`, { ending }).catch(fail);
    return (
        <section aria-labelledby="film-title">
            <h2 id="film-title" class="small-title">
                {t.film}
            </h2>
            {running ? (
                <>
                    <progress max="1" value={work.overall || undefined} aria-label={t.film} />
                    <div class="row">
                        <p class="hint grow">
                            {Math.round(100 * work.overall)} %
                            {work.seconds_left >= 0 && ` · ${t.about} ${clock(work.seconds_left)} ${t.left}`}
                        </p>
                        <button onClick={() => post(`scenes/${part(scene)}/film/stop`).catch(fail)}>{t.stop}</button>
                    </div>
                </>
            ) : (
                <>
                    {mine && work.state === 'failed' && (
                        <p class="problem" role="alert">
                            {work.error}
                        </p>
                    )}
                    {film.made && (
                        <>
                            <video controls src={`${url}?${film.made.bytes}`} class="film-made" />
                            <a class="button" href={url} download>
                                {t.download} · {size(film.made.bytes)}
                            </a>
                        </>
                    )}
                    <div class="row">
                        <button class="primary" onClick={() => start('mp4')}>
                            {t.film_make} .mp4
                        </button>
                        <button onClick={() => start('webm')}>.webm</button>
                    </div>
                </>
            )}
        </section>
    );
};

// The scene's path: each change is saved, and what the server made of it is shown.
const useFilm = (scene: string) => {
    const [film, setFilm] = useState<Film | null>(null),
        [lost, setLost] = useState(''),
        [version, setVersion] = useState(0);
    const latest = useRef<Film | null>(null);
    const take = (next: Partial<Film>) => {
        latest.current = { ...(latest.current as Film), ...next };
        setFilm(latest.current);
        setVersion((n) => n + 1);
    };
    const load = () =>
        get<Film>(`scenes/${part(scene)}/film`)
            .then(take)
            .catch((e) => setLost(e.message));
    useEffect(() => {
        load();
    }, [scene]);
    const send = (what: string, body: unknown) =>
        post<Partial<Film>>(`scenes/${part(scene)}/film/${what}`, body)
            .then(take)
            .catch((error) => {
                fail(error);
                if (latest.current) setFilm({ ...latest.current });
            });
    const change = (path: Partial<CameraPath>) => {
        const next = { ...latest.current!.path, ...path };
        return send('path', { path: { ...next, keys: sorted(next.keys) } });
    };
    return { film, lost, version, send, change, load };
};

export const FilmEditor = ({ scene }: { scene: SceneDetails }) => {
    const { film: work } = useShared();
    const { film, lost, version, send, change, load } = useFilm(scene.name);
    const [selected, setSelected] = useState(0),
        [asked_s, setTime] = useState(0),
        [playing, setPlaying] = useState(false);
    const end_s = film ? film.path.keys[film.path.keys.length - 1].time_s : 0;
    const time_s = Math.min(asked_s, end_s); // the path may have become shorter
    const { picture, shown_s } = useFrame(scene.name, time_s, version);
    const view = useMemo(() => film && (film.view ?? bareView(film.rings)), [film?.view, film?.rings]);
    // The film that was made is there once its work has ended.
    const state = work?.scene === scene.name && work.what === 'film' ? work.state : '';
    useEffect(() => {
        if (state === 'finished') load();
    }, [state]);
    // Plays in time, with as many frames as there are.
    const begun = useRef(0);
    useEffect(() => {
        if (!playing) return;
        const now = (performance.now() - begun.current) / 1000;
        if (now >= end_s) {
            setTime(end_s);
            setPlaying(false);
        } else setTime(now);
    }, [playing, shown_s]);
    if (lost) return <p class="empty">{lost}</p>;
    if (!film || !view)
        return (
            <p class="loading" role="status">
                …
            </p>
        );
    const { path, track } = film;
    const index = Math.min(selected, path.keys.length - 1);
    const select = (i: number) => {
        setSelected(i);
        setPlaying(false);
        setTime(path.keys[i].time_s);
    };
    const changeKey = (i: number, key: Partial<CameraKey>) =>
        change({ keys: path.keys.map((one, k) => (k === i ? { ...one, ...key } : one)) });
    const remove = (i: number) => {
        if (path.keys.length > 1) change({ keys: path.keys.filter((_, k) => k !== i) });
        setSelected(Math.max(0, i - 1));
    };
    const share = end_s > 0 ? time_s / end_s : 0;
    const [x, z] = track[Math.round(share * (track.length - 1))];
    const addHere = () => {
        const before = Math.max(0, path.keys.filter((k) => k.time_s <= time_s).length - 1),
            a = path.keys[before],
            b = path.keys[Math.min(before + 1, path.keys.length - 1)];
        if (Math.abs(a.time_s - time_s) < 0.05 || (b !== a && Math.abs(b.time_s - time_s) < 0.05)) return;
        const w = b.time_s > a.time_s ? (time_s - a.time_s) / (b.time_s - a.time_s) : 0;
        const mix = (p: number, q: number) => round(p + w * (q - p), 3);
        const made: CameraKey = {
            time_s: round(time_s, 2),
            position_m: [round(x, 3), mix(a.position_m[1], b.position_m[1]), round(z, 3)],
            yaw_deg: mix(a.yaw_deg, b.yaw_deg),
            pitch_deg: mix(a.pitch_deg, b.pitch_deg),
        };
        change({ keys: [...path.keys, made] });
        setSelected(before + 1);
    };
    const leaves = track.some(([, , free]) => !free);
    return (
        <div class="editor film">
            <div class="editor-plan">
                <Plan view={view} label={t.plan}>
                    <Track
                        film={film}
                        view={view}
                        selected={index}
                        at={[x, z]}
                        onSelect={select}
                        onMove={(i, px, pz) =>
                            changeKey(i, { position_m: [round(px, 3), path.keys[i].position_m[1], round(pz, 3)] })
                        }
                        onTurn={(i, by) => changeKey(i, { yaw_deg: path.keys[i].yaw_deg + by })}
                        onRemove={remove}
                    />
                </Plan>
                {leaves && <p class="hint problem">{t.film_leaves}</p>}
                <figure class="film-picture">
                    {picture && <img src={picture} alt={t.film_frame} width={path.size[0]} height={path.size[1]} />}
                    <figcaption class="row">
                        <button
                            aria-label={playing ? t.film_pause : t.film_play}
                            onClick={() => {
                                const from = time_s >= end_s - 0.05 ? 0 : time_s;
                                begun.current = performance.now() - 1000 * from;
                                if (!playing) setTime(from);
                                setPlaying(!playing);
                            }}
                        >
                            {playing ? '❚❚' : '▶'}
                        </button>
                        <input
                            class="grow"
                            type="range"
                            min={0}
                            max={end_s}
                            step={0.01}
                            value={time_s}
                            aria-label={t.film_time}
                            onInput={(e) => {
                                setPlaying(false);
                                setTime(Number(e.currentTarget.value));
                            }}
                        />
                        <span class="film-clock">
                            {time_s.toFixed(1)} / {end_s.toFixed(1)} s
                        </span>
                        <button onClick={addHere}>{t.film_add}</button>
                    </figcaption>
                    {scene.has_room && <Traced scene={scene.name} time_s={time_s} picture={picture} />}
                </figure>
            </div>
            <aside class="inspector">
                <KeyPanel
                    film={film}
                    index={index}
                    change={(key) => changeKey(index, key)}
                    onRemove={() => remove(index)}
                />
                <PathPanel
                    film={film}
                    scene={scene.name}
                    change={change}
                    plan={(kind) => {
                        setSelected(0);
                        setPlaying(false);
                        setTime(0);
                        send('plan', { kind });
                    }}
                    onRead={(text) => send('read', { text })}
                />
                <MakePanel scene={scene.name} film={film} />
            </aside>
        </div>
    );
};
