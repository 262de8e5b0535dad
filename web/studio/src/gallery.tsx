// All scenes: search, open, delete and bring back.
import { useState } from 'preact/hooks';
import { fileUrl, part, post, type Scene } from './api';
import { fail, go, notify, refresh, useShared } from './store';
import { day, fill, minutes, t } from './text';

const remove = async (scene: Scene) => {
    try {
        const { trashed } = await post<{ trashed: string }>(`scenes/${part(scene.name)}/delete`);
        notify(fill(t.deleted, scene.title), {
            action: {
                label: t.undo,
                run: () =>
                    post(`trash/${part(trashed)}/restore`)
                        .then(refresh)
                        .catch(fail),
            },
        });
        await refresh();
    } catch (error) {
        fail(error);
    }
};
const complete = (scene: Scene) =>
    post(`scenes/${part(scene.name)}/complete`)
        .then(refresh)
        .then(() => go('/'))
        .catch(fail);

export const Card = ({ scene }: { scene: Scene }) => {
    const href = `/scene/${part(scene.name)}`,
        quality = t[scene.quality as 'draft'] ?? scene.quality;
    return (
        <li class="card">
            <a
                href={href}
                onClick={(e) => {
                    if (e.metaKey || e.ctrlKey || e.shiftKey) return;
                    e.preventDefault();
                    go(href);
                }}
            >
                {scene.picture ? (
                    <img loading="lazy" src={`${fileUrl(scene.name, scene.picture)}?${scene.made}`} alt="" />
                ) : (
                    <div class="no-picture" />
                )}
                <span class="card-title">{scene.title}</span>
            </a>
            {scene.changes.length > 0 && (
                <p class="card-change">
                    {scene.changes
                        .slice(-2)
                        .map((c) => `${c.id} ${c.what}`)
                        .join('; ')}
                </p>
            )}
            <p class="card-facts">
                <span>{scene.finished ? quality : `${t.unfinished}${quality ? `, ${quality}` : ''}`}</span>
                {scene.seconds > 0 && <span>{minutes(scene.seconds)}</span>}
                {scene.psnr !== undefined && (
                    <span title={fill(t.truth, scene.psnr.toFixed(1))}>{scene.psnr.toFixed(1)} dB</span>
                )}
                <span class="grow" title={day(scene.made)}>
                    {day(scene.made).split(',')[0]}
                </span>
                {!scene.finished && scene.kind !== 'capture' && (
                    <button class="quiet" onClick={() => complete(scene)}>
                        {t.complete}
                    </button>
                )}
                <button class="quiet" aria-label={`${t.delete}: ${scene.title}`} onClick={() => remove(scene)}>
                    {t.delete}
                </button>
            </p>
        </li>
    );
};

const page = 60; // scenes, before more are asked for
export const Gallery = () => {
    const { state } = useShared();
    const [words, setWords] = useState(''),
        [shown, setShown] = useState(page);
    if (!state) return null;
    const all = words.toLowerCase().split(/\s+/).filter(Boolean);
    const found = state.scenes.filter((s) =>
        all.every((w) =>
            `${s.title} ${s.name} ${s.quality} ${s.changes.map((c) => `${c.id} ${c.what}`).join(' ')}`
                .toLowerCase()
                .includes(w),
        ),
    );
    return (
        <section aria-labelledby="gallery-title">
            <div class="section-head">
                <h1 id="gallery-title">{t.scenes}</h1>
                <input
                    type="search"
                    class="search"
                    aria-label={t.search}
                    placeholder={t.search}
                    value={words}
                    onInput={(e) => {
                        setWords(e.currentTarget.value);
                        setShown(page);
                    }}
                />
                <span class="hint" role="status">
                    {fill(t.found, found.length, state.scenes.length)}
                </span>
            </div>
            {found.length === 0 && <p class="empty">{state.scenes.length ? t.nothing_found : t.empty}</p>}
            <ul class="grid">
                {found.slice(0, shown).map((s) => (
                    <Card key={s.name} scene={s} />
                ))}
            </ul>
            {found.length > shown && (
                <button class="center" onClick={() => setShown(shown + page)}>
                    + {Math.min(page, found.length - shown)}
                </button>
            )}
        </section>
    );
};
