// One scene: walk in it, look around, change its room, take it along.
import { useEffect, useMemo, useState } from 'preact/hooks';
import { fileUrl, get, part, Refused, type Download, type Draft, type SceneDetails } from './api';
import { Editor } from './editor';
import { FilmEditor } from './film/editor';
import { hasWebGL, Panorama } from './panorama';
import { fail, go, notify } from './store';
import { day, minutes, size, t } from './text';

const copy = (text: string) =>
    navigator.clipboard
        .writeText(text)
        .then(() => notify(t.copied))
        .catch(fail);

const Walk = ({ scene }: { scene: SceneDetails }) => {
    const [webgl] = useState(hasWebGL);
    if (!scene.has_walk) return <p class="empty">{t.no_walk}</p>;
    if (!webgl)
        return (
            <div class="stage">
                <p class="stage-message" role="status">
                    {t.no_webgl}
                </p>
                {scene.has_panorama && <img src={fileUrl(scene.name, 'panorama/color.png')} alt={scene.title} />}
            </div>
        );
    const page = `${fileUrl(scene.name, 'viewer.html')}?${scene.made}`;
    return (
        <>
            <div class="stage">
                <iframe
                    src={page}
                    title={`${t.walk}: ${scene.title}`}
                    sandbox="allow-scripts allow-pointer-lock"
                    allow="fullscreen; xr-spatial-tracking; gamepad"
                />
            </div>
            <p class="under-stage">
                <span class="hint">{t.walk_keys}</span>{' '}
                <a href={page} target="_blank" rel="noopener">
                    {t.new_window}
                </a>
            </p>
        </>
    );
};

// Where the first thing that was changed is seen from the camera: radians to the right of the picture's middle.
const yawOfChange = async (scene: SceneDetails) => {
    const { view } = await get<Draft>(`scenes/${part(scene.name)}/draft`);
    const thing = view.things.find((one) => scene.changes.some((c) => c.id === one.id));
    if (!thing) return 0;
    const [lx, lz] = view.looks,
        dx = thing.cx - view.camera[0],
        dz = thing.cz - view.camera[1];
    return Math.atan2(dz * lx - dx * lz, dx * lx + dz * lz);
};

const Around = ({ scene }: { scene: SceneDetails }) => {
    const [webgl] = useState(hasWebGL);
    const [yaw, setYaw] = useState<number | null>(scene.has_before ? null : 0);
    useEffect(() => {
        if (yaw === null)
            yawOfChange(scene)
                .catch(() => 0)
                .then(setYaw);
    }, []);
    const url = `${fileUrl(scene.name, 'panorama/color.png')}?${scene.made}`;
    if (!scene.has_panorama) return <p class="empty">{t.no_walk}</p>;
    if (!webgl)
        return (
            <div class="stage">
                <p class="stage-message" role="status">
                    {t.no_webgl}
                </p>
                <img src={url} alt={scene.title} />
            </div>
        );
    if (yaw === null)
        return (
            <p class="loading" role="status">
                …
            </p>
        );
    return (
        <>
            <Panorama
                yaw={yaw}
                url={url}
                before={scene.has_before ? fileUrl(scene.from, 'panorama/color.png') : undefined}
                label={scene.title}
            />
            <p class="under-stage hint">{t.panorama_help}</p>
        </>
    );
};

const FileRow = ({ scene, file, onMade }: { scene: string; file: Download; onMade: () => void }) => {
    const [busy, setBusy] = useState(false);
    const url = `/api/scenes/${part(scene)}/download/${part(file.id)}`;
    // The first byte comes when the file is made; then the browser saves it.
    const save = async () => {
        setBusy(true);
        try {
            const response = await fetch(url, { headers: { Range: 'bytes=0-0' } });
            if (!response.ok) throw new Refused((await response.json()).error, response.status);
            await response.arrayBuffer();
            const link = document.createElement('a');
            link.href = url;
            link.download = '';
            link.click();
            onMade();
        } catch (error) {
            fail(error);
        }
        setBusy(false);
    };
    return (
        <li class="file">
            <span class="file-name">{file.file}</span>
            <span class="file-about">{t.abouts[file.id] ?? file.about}</span>
            <span class="file-size">{busy ? t.preparing : file.bytes === null ? t.on_demand : size(file.bytes)}</span>
            <button disabled={busy} aria-label={`${t.download}: ${file.file}`} onClick={save}>
                {t.download}
            </button>
        </li>
    );
};

const Files = ({ scene, onMade }: { scene: SceneDetails; onMade: () => void }) => (
    <div class="files">
        <div>
            {Object.entries(t.groups).map(([group, title]) => {
                const files = scene.downloads.filter((d) => d.group === group);
                return (
                    files.length > 0 && (
                        <section key={group}>
                            <h2 class="small-title">{title}</h2>
                            <ul>
                                {files.map((f) => (
                                    <FileRow key={f.id} scene={scene.name} file={f} onMade={onMade} />
                                ))}
                            </ul>
                        </section>
                    )
                );
            })}
        </div>
        <aside>
            <h2 class="small-title">{t.command}</h2>
            {[scene.command, scene.downloads.find((d) => d.id === 'room')?.command].filter(Boolean).map((c) => (
                <div key={c} class="command">
                    <code>{c}</code>
                    <button onClick={() => copy(c!)}>{t.copy}</button>
                </div>
            ))}
        </aside>
    </div>
);

const tabs = ['walk', 'panorama', 'change', 'film', 'files'] as const;
type Tab = (typeof tabs)[number];

export const ScenePage = ({ name }: { name: string }) => {
    const [scene, setScene] = useState<SceneDetails | null>(null),
        [lost, setLost] = useState('');
    const [tab, setTab] = useState<Tab>((location.hash.slice(1) || 'walk') as Tab);
    const load = useMemo(
        () => () =>
            get<SceneDetails>(`scenes/${part(name)}`)
                .then(setScene)
                .catch((e) => setLost(e instanceof Refused && e.status === 404 ? t.lost_scene : String(e.message))),
        [name],
    );
    useEffect(() => {
        setScene(null);
        setLost('');
        load();
    }, [load]);
    useEffect(() => {
        if (scene) document.title = `${scene.title} · fastscene studio`;
        return () => {
            document.title = 'fastscene studio';
        };
    }, [scene]);
    // One without a page to walk in shows what there is.
    useEffect(() => {
        if (scene && !scene.has_walk && tab === 'walk' && scene.has_panorama) setTab('panorama');
    }, [scene]);
    useEffect(() => {
        document.getElementById(`tab-${tab}`)?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
    }, [tab, scene !== null]);
    if (lost)
        return (
            <section class="lost">
                <h1>{lost}</h1>
                <a
                    class="button"
                    href="/gallery"
                    onClick={(e) => {
                        e.preventDefault();
                        go('/gallery');
                    }}
                >
                    {t.back}
                </a>
            </section>
        );
    if (!scene)
        return (
            <p class="loading" role="status">
                …
            </p>
        );
    const open = (to: Tab) => {
        setTab(to);
        history.replaceState(null, '', `#${to}`);
    };
    const key = (event: KeyboardEvent) => {
        const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (!by) return;
        const next = tabs[(tabs.indexOf(tab) + by + tabs.length) % tabs.length];
        open(next);
        document.getElementById(`tab-${next}`)?.focus();
        event.preventDefault();
    };
    const facts = [
        t[scene.quality as 'draft'] ?? scene.quality,
        `${t.seed} ${scene.seed}`,
        scene.seconds > 0 && `${t.made_in} ${minutes(scene.seconds)}`,
        scene.peak_memory_bytes > 0 && `${t.peak} ${size(scene.peak_memory_bytes)}`,
        scene.psnr !== undefined && `${scene.psnr.toFixed(1)} dB`,
        day(scene.made),
    ].filter(Boolean);
    return (
        <article class="scene">
            <header class="scene-head">
                <h1>{scene.title}</h1>
                <p class="hint">{facts.join(' · ')}</p>
                {scene.from && (
                    <p class="hint">
                        {t.from}{' '}
                        <a
                            href={`/scene/${part(scene.from)}`}
                            onClick={(e) => {
                                e.preventDefault();
                                go(`/scene/${part(scene.from)}`);
                            }}
                        >
                            {scene.from}
                        </a>
                        : {scene.changes.map((c) => `${c.id} ${c.what}`).join('; ')}
                    </p>
                )}
                <div class="tabs" role="tablist" onKeyDown={key}>
                    {tabs.map((one) => (
                        <button
                            key={one}
                            id={`tab-${one}`}
                            role="tab"
                            aria-selected={tab === one}
                            aria-controls="panel"
                            tabIndex={tab === one ? 0 : -1}
                            onClick={() => open(one)}
                        >
                            {t[one]}
                        </button>
                    ))}
                </div>
            </header>
            <div id="panel" role="tabpanel" aria-labelledby={`tab-${tab}`} key={`${name}/${tab}`}>
                {tab === 'walk' && <Walk scene={scene} />}
                {tab === 'panorama' && <Around scene={scene} />}
                {tab === 'change' && (scene.has_room ? <Editor scene={scene} /> : <p class="empty">{t.no_room}</p>)}
                {tab === 'film' && <FilmEditor scene={scene} />}
                {tab === 'files' && <Files scene={scene} onMade={load} />}
            </div>
        </article>
    );
};
