// The film made of the path: started, watched, stopped, seen and downloaded.
import { part, post, type Film } from '../api';
import { fail, useShared } from '../store';
import { clock, size, t } from '../text';

export const ExportPanel = ({ scene, film }: { scene: string; film: Film }) => {
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
