// A sentence becomes a scene: what is understood of it and the plan of the room appear while it is typed.
import { useEffect, useRef, useState } from 'preact/hooks';
import { part, post, Refused, type Cost, type PlanView, type Reading, type State, type Upload } from './api';
import { Card } from './gallery';
import { Look, useLook } from './look';
import { OwnPanorama } from './own_panorama';
import { hasWebGL, Panorama } from './panorama';
import { Plan } from './plan';
import { Queue } from './queue';
import { Sentence, Understanding } from './sentence';
import { fail, go, refresh, useShared } from './store';
import { fill, language, minutes, t } from './text';

const examples =
    language === 'de'
        ? [
              'ein gemütliches Schlafzimmer mit rotem Sessel und großem Fenster',
              'ein japanisches Wohnzimmer mit zwei Pflanzen',
              'eine helle Küche mit Holzboden am Morgen',
          ]
        : [
              'a cozy bedroom with a red armchair and a large window',
              'an art deco study at night with a green sofa',
              'a japandi living room with two plants by the window',
              'a bright kitchen with a wooden floor in the morning',
          ];
const pause_ms = 90; // after the last key, before the sentence is read
const moment_ms = 25; // for a click: nothing follows it

const remembered = (key: string) => {
    try {
        return sessionStorage.getItem(key) ?? '';
    } catch {
        return '';
    }
};
const remember = (key: string, value: string) => {
    try {
        sessionStorage.setItem(key, value);
    } catch {
        /* private window */
    }
};

// What is asked for is the sentence alone: it is what the command line takes, too.
const hours: Record<string, string> = {
    morning: 'in the morning',
    day: 'by day',
    evening: 'in the evening',
    dusk: 'at dusk',
    night: 'at night',
};
const promptOf = (sentence: string, style: string, hour: string) =>
    [sentence.trim(), style && `${style} style`, hours[hour]].filter(Boolean).join(', ');

// What the server makes of a prompt. The last answer stays until the next one comes.
const useReading = (prompt: string, seed: number, isEmpty: boolean) => {
    const [reading, setReading] = useState<Reading | null>(null),
        [problem, setProblem] = useState('');
    const last = useRef(prompt);
    useEffect(() => {
        if (isEmpty) {
            setReading(null);
            setProblem('');
            return;
        }
        const abort = new AbortController();
        const wait = last.current === prompt ? moment_ms : pause_ms;
        last.current = prompt;
        const timer = setTimeout(async () => {
            try {
                setReading(await post<Reading>('plan', { prompt, seed }, abort.signal));
                setProblem('');
            } catch (error) {
                if (error instanceof Refused) setProblem(error.message);
            }
        }, wait);
        return () => {
            clearTimeout(timer);
            abort.abort();
        };
    }, [prompt, seed, isEmpty]);
    return { reading, problem };
};

const Examples = ({ onPick }: { onPick: (sentence: string) => void }) => (
    <div class="examples">
        <h2 class="small-title">{t.examples}</h2>
        {examples.map((e) => (
            <button key={e} class="example" onClick={() => onPick(e)}>
                {e}
            </button>
        ))}
    </div>
);

const qualityNames: Record<string, [string, string]> = {
    draft: [t.draft, t.draft_for],
    standard: [t.standard, t.standard_for],
    high: [t.high_quality, t.high_for],
};
const Qualities = ({
    costs,
    chosen,
    onChoose,
}: {
    costs: Cost[];
    chosen: string;
    onChoose: (quality: string) => void;
}) => (
    <fieldset class="qualities">
        <legend>{t.quality}</legend>
        {costs.map((c) => (
            <label
                key={c.quality}
                class={`quality ${chosen === c.quality ? 'is-chosen' : ''}`}
                title={c.measured ? t.measured : t.estimated}
            >
                <input
                    type="radio"
                    name="quality"
                    class="visually-hidden"
                    checked={chosen === c.quality}
                    onChange={() => onChoose(c.quality)}
                />
                <strong>{qualityNames[c.quality]?.[0]}</strong>
                <span>{qualityNames[c.quality]?.[1]}</span>
                <small>
                    {t.about} {minutes(c.seconds)} · {c.gib.toFixed(1)} GB
                </small>
            </label>
        ))}
    </fieldset>
);

export interface Wishes {
    style: string;
    hour: string;
    seed: number;
}
const most_seed = 4294967295;
const WishFields = ({
    wishes,
    choices,
    onChange,
}: {
    wishes: Wishes;
    choices?: State['choices'];
    onChange: (wishes: Wishes) => void;
}) => {
    const select = (label: string, key: 'style' | 'hour', all: string[] = []) => (
        <label>
            {label}
            <select value={wishes[key]} onChange={(e) => onChange({ ...wishes, [key]: e.currentTarget.value })}>
                <option value="">{t.as_said}</option>
                {all.map((one) => (
                    <option key={one}>{one}</option>
                ))}
            </select>
        </label>
    );
    const setSeed = (seed: number) =>
        onChange({ ...wishes, seed: Math.min(most_seed, Math.max(0, Math.floor(seed || 0))) });
    return (
        <div class="fields">
            {select(t.style, 'style', choices?.styles)}
            {select(t.hour, 'hour', choices?.hours)}
            <label title={t.seed_help}>
                {t.seed}
                <span class="seed">
                    <input
                        type="number"
                        min="0"
                        max={most_seed}
                        inputMode="numeric"
                        value={wishes.seed}
                        onInput={(e) => setSeed(Number(e.currentTarget.value))}
                    />
                    <button
                        class="icon-button"
                        aria-label={t.dice}
                        title={t.dice}
                        onClick={() => setSeed(Math.random() * 10000)}
                    >
                        ⚄
                    </button>
                </span>
            </label>
        </div>
    );
};

const RoomFigure = ({ view, look }: { view?: PlanView; look: ReturnType<typeof useLook> }) => (
    <figure class="create-plan">
        {view ? (
            <Plan view={view} label={t.plan_of} />
        ) : (
            <div class="plan-empty">
                <svg viewBox="0 0 200 140" aria-hidden="true">
                    <path d="M10 10H190V130H120M80 130H10V10M80 130A40 40 0 0 1 120 90M120 130V90M60 10v8H110v-8" />
                </svg>
                <p>{t.plan_waits}</p>
            </div>
        )}
        {view && <Look look={look} />}
        {view && (
            <figcaption>
                <strong>{view.type}</strong> · {view.style} · {view.width.toFixed(1)} × {view.depth.toFixed(1)}{' '}
                {t.metres} · {view.height.toFixed(1)} {t.metres} {t.high} · {view.hour}
            </figcaption>
        )}
    </figure>
);

const OwnFigure = ({ panorama }: { panorama: Upload }) =>
    /\.(png|jpe?g|webp)$/.test(panorama.id) && hasWebGL() ? (
        <figure class="create-plan own-view">
            <Panorama key={panorama.id} url={`/api/uploads/${part(panorama.id)}`} label={panorama.name} />
            <figcaption>{t.panorama_help}</figcaption>
        </figure>
    ) : null;

const Recent = ({ state }: { state: State }) => (
    <section aria-labelledby="recent">
        <div class="section-head">
            <h2 id="recent">{t.scenes}</h2>
            <a
                href="/gallery"
                onClick={(e) => {
                    e.preventDefault();
                    go('/gallery');
                }}
            >
                {t.back} ({state.scenes.length})
            </a>
        </div>
        <ul class="grid">
            {state.scenes.slice(0, most_recent).map((s) => (
                <Card key={s.name} scene={s} />
            ))}
        </ul>
    </section>
);
const most_recent = 6;

const MakeButton = ({
    cost,
    free_bytes,
    disabled,
    onMake,
}: {
    cost?: Cost;
    free_bytes: number;
    disabled: boolean;
    onMake: () => void;
}) => {
    const free = free_bytes / 2 ** 30;
    return (
        <>
            <div class="make-row">
                <button class="primary" disabled={disabled} onClick={onMake}>
                    {t.make}
                </button>
                {cost && (
                    <span class="hint">
                        {t.about} {minutes(cost.seconds)}, {cost.gib.toFixed(1)} GB {t.memory}
                    </span>
                )}
            </div>
            {cost && free > 0 && cost.gib > free && <p class="problem">{fill(t.low_memory, free.toFixed(1))}</p>}
        </>
    );
};

export const Create = () => {
    const { state, jobs } = useShared();
    const [sentence, setSentence] = useState(remembered('sentence'));
    const [wishes, setWishes] = useState<Wishes>({ style: '', hour: '', seed: 0 });
    const [quality, setQuality] = useState(remembered('quality') || 'draft');
    const [panorama, setPanorama] = useState<Upload | null>(null),
        [range, setRange] = useState<Upload | null>(null);
    const [busy, setBusy] = useState(false);
    const isEmpty = !sentence.trim(),
        { seed } = wishes;
    const prompt = panorama ? sentence.trim() : promptOf(sentence, wishes.style, wishes.hour);
    const { reading, problem } = useReading(prompt, seed, isEmpty || panorama !== null);
    const look = useLook(reading && !isEmpty && !panorama ? `${seed} ${prompt}` : '', () =>
        post('look', { prompt, seed }),
    );
    useEffect(() => remember('sentence', sentence), [sentence]);
    useEffect(() => remember('quality', quality), [quality]);

    const make = async () => {
        if (busy || (isEmpty && !panorama)) return;
        setBusy(true);
        try {
            await post('jobs', {
                prompt,
                seed,
                quality,
                panorama: panorama?.id ?? '',
                range: range?.id ?? '',
                name: panorama?.name ?? '',
            });
            await refresh();
            document.getElementById('queue')?.scrollIntoView({ behavior: 'smooth', block: 'nearest' });
        } catch (error) {
            fail(error);
        }
        setBusy(false);
    };
    return (
        <>
            <section class="create">
                <div class="create-words">
                    <h1>{t.lead}</h1>
                    <Sentence
                        value={sentence}
                        reading={reading}
                        onInput={setSentence}
                        onEnter={make}
                        describedBy="enter-help reading"
                    />
                    <p id="enter-help" class="hint">
                        {t.enter}
                    </p>
                    <div id="reading">
                        {problem ? (
                            <p class="problem" role="alert">
                                {problem}
                            </p>
                        ) : (
                            <Understanding reading={reading} />
                        )}
                    </div>
                    {isEmpty && !panorama && <Examples onPick={setSentence} />}
                    <div class="options">
                        <Qualities costs={state?.costs ?? []} chosen={quality} onChoose={setQuality} />
                        {!panorama && <WishFields wishes={wishes} choices={state?.choices} onChange={setWishes} />}
                        <details class="own" open={panorama !== null}>
                            <summary>{t.own}</summary>
                            <OwnPanorama
                                panorama={panorama}
                                range={range}
                                most={state?.most_upload_bytes ?? 0}
                                onPanorama={setPanorama}
                                onRange={setRange}
                            />
                        </details>
                    </div>
                    <MakeButton
                        cost={state?.costs.find((c) => c.quality === quality)}
                        free_bytes={state?.free_memory_bytes ?? 0}
                        disabled={busy || (isEmpty && !panorama)}
                        onMake={make}
                    />
                </div>
                {panorama ? <OwnFigure panorama={panorama} /> : <RoomFigure view={reading?.view} look={look} />}
            </section>
            <Queue jobs={jobs} />
            {state && state.scenes.length > 0 && <Recent state={state} />}
        </>
    );
};
