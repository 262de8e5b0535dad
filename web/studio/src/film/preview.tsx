// What the camera sees, played or moved through in time; beside it the room behind the scene, traced.
import { useState } from 'preact/hooks';
import { part, post, type Point, type SceneDetails } from '../api';
import { fail, useShared } from '../store';
import { t } from '../text';
import type { usePlayback } from './playback';

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

export const Preview = ({
    scene,
    size,
    end_s,
    playback: { time_s, picture, playing, seek, toggle },
    onAdd,
}: {
    scene: SceneDetails;
    size: Point;
    end_s: number;
    playback: ReturnType<typeof usePlayback>;
    onAdd: () => void;
}) => (
    <figure class="film-picture">
        {picture && <img src={picture} alt={t.film_frame} width={size[0]} height={size[1]} />}
        <figcaption class="row">
            <button aria-label={playing ? t.film_pause : t.film_play} onClick={toggle}>
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
                onInput={(e) => seek(Number(e.currentTarget.value))}
            />
            <span class="film-clock">
                {time_s.toFixed(1)} / {end_s.toFixed(1)} s
            </span>
            <button onClick={onAdd}>{t.film_add}</button>
        </figcaption>
        {scene.has_room && <Traced scene={scene.name} time_s={time_s} picture={picture} />}
    </figure>
);
