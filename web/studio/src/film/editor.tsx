// A film of the scene: its camera path on the plan, key by key, what the camera sees, and the film made of it.
import { useEffect, useMemo, useState } from 'preact/hooks';
import type { CameraKey, SceneDetails } from '../api';
import { Plan } from '../plan';
import { useShared } from '../store';
import { t } from '../text';
import { keyBetween, round } from './camera_path';
import { ExportPanel } from './export_panel';
import { KeyPanel } from './key_panel';
import { PathPanel } from './path_panel';
import { usePlayback } from './playback';
import { Preview } from './preview';
import { bareView, Track } from './track';
import { useFilm } from './use_film';

export const FilmEditor = ({ scene }: { scene: SceneDetails }) => {
    const { film: work } = useShared();
    const { film, lost, version, send, change, load } = useFilm(scene.name);
    const [selected, setSelected] = useState(0);
    const end_s = film ? film.path.keys[film.path.keys.length - 1].time_s : 0;
    const playback = usePlayback(scene.name, end_s, version);
    const view = useMemo(() => film && (film.view ?? bareView(film.rings)), [film?.view, film?.rings]);
    // The film that was made is there once its work has ended.
    const state = work?.scene === scene.name && work.what === 'film' ? work.state : '';
    useEffect(() => {
        if (state === 'finished') load();
    }, [state]);
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
        playback.seek(path.keys[i].time_s);
    };
    const changeKey = (i: number, key: Partial<CameraKey>) =>
        change({ keys: path.keys.map((one, k) => (k === i ? { ...one, ...key } : one)) });
    const remove = (i: number) => {
        if (path.keys.length > 1) change({ keys: path.keys.filter((_, k) => k !== i) });
        setSelected(Math.max(0, i - 1));
    };
    const share = end_s > 0 ? playback.time_s / end_s : 0;
    const [x, z] = track[Math.round(share * (track.length - 1))];
    const addHere = () => {
        const added = keyBetween(path, playback.time_s, [x, z]);
        if (!added) return;
        change({ keys: [...path.keys, added.key] });
        setSelected(added.index);
    };
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
                {track.some(([, , free]) => !free) && <p class="hint problem">{t.film_leaves}</p>}
                <Preview scene={scene} size={path.size} end_s={end_s} playback={playback} onAdd={addHere} />
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
                        playback.seek(0);
                        send('plan', { kind });
                    }}
                    onRead={(text) => send('read', { text })}
                />
                <ExportPanel scene={scene.name} film={film} />
            </aside>
        </div>
    );
};
