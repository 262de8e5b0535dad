// The whole path: planned anew, its size, rate, field of view and length, saved for other programs and read from them.
import { part, type CameraPath, type Film, type Point } from '../api';
import { t } from '../text';
import { Amount } from './amount';
import { lengthOf, round } from './camera_path';

const kinds = ['tour', 'walkthrough', 'orbit'] as const;
const formats = ['fastscene', 'blender', 'nerfstudio', 'supersplat'] as const;
const sizes: [number, number][] = [
    [1280, 720],
    [1920, 1080],
    [3840, 2160],
    [1080, 1920],
    [1080, 1080],
];

export const PathPanel = ({
    film,
    scene,
    plan,
    change,
    onRead,
}: {
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
