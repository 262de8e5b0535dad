// A sentence becomes a scene: what is understood of it and the plan of the room appear while it is typed.
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { post, Refused, upload, type Reading, type Upload } from './api';
import { hasWebGL, Panorama } from './panorama';
import { Look, useLook } from './look';
import { Plan } from './plan';
import { Queue } from './queue';
import { fail, go, notify, refresh, useShared } from './store';
import { fill, language, minutes, t } from './text';
import { Card } from './gallery';

const examples = language === 'de'
    ? ['ein gemütliches Schlafzimmer mit rotem Sessel und großem Fenster', 'ein japanisches Wohnzimmer mit zwei Pflanzen', 'eine helle Küche mit Holzboden am Morgen']
    : ['a cozy bedroom with a red armchair and a large window', 'an art deco study at night with a green sofa', 'a japandi living room with two plants by the window', 'a bright kitchen with a wooden floor in the morning'];
const pause_ms = 90;   // after the last key, before the sentence is read
const moment_ms = 25;  // for a click: nothing follows it

const fates = { understood: '✓', approximated: '≈', not_understood: '✕' } as const;

// Words come back in lower case and without accents, in their order.
const folded = (text: string) => [...text].map((c) => c.normalize('NFD')[0].toLowerCase()).join('');
interface Piece { text: string; fate?: keyof typeof fates; meaning?: string }
const marked = (sentence: string, reading: Reading | null): Piece[] => {
    const chars = [...sentence], plain = folded(sentence), pieces: Piece[] = [];
    let at = 0;
    for (const word of reading?.words ?? []) {
        const found = plain.indexOf(word.words, at);
        if (found < 0) continue;
        if (found > at) pieces.push({ text: chars.slice(at, found).join('') });
        at = found + word.words.length;
        pieces.push({ text: chars.slice(found, at).join(''), fate: word.fate, meaning: word.meaning });
    }
    pieces.push({ text: chars.slice(at).join('') });
    return pieces;
};

const Sentence = ({ value, reading, onInput, onEnter, describedBy }: {
    value: string; reading: Reading | null; onInput: (text: string) => void; onEnter: () => void; describedBy: string;
}) => {
    const area = useRef<HTMLTextAreaElement>(null);
    const pieces = useMemo(() => marked(value, reading), [value, reading]);
    useEffect(() => { if (matchMedia('(hover: hover)').matches) area.current?.focus({ preventScroll: true }); }, []);
    return <div class="sentence">
        <div class="sentence-marks" aria-hidden="true">{pieces.map((p, i) => p.fate ? <mark key={i} class={p.fate}>{p.text}</mark> : p.text)}{'\u200b'}</div>
        <textarea ref={area} rows={3} maxLength={2000} spellcheck={false} aria-label={t.sentence} aria-describedby={describedBy} placeholder={t.placeholder}
            value={value} onInput={(e) => onInput(e.currentTarget.value)}
            onKeyDown={(e) => { if (e.key === 'Enter' && !e.shiftKey && !e.isComposing) { e.preventDefault(); onEnter(); } }} />
    </div>;
};

const Understanding = ({ reading }: { reading: Reading | null }) => {
    if (!reading) return null;
    const of = (fate: string) => reading.words.filter((w) => w.fate === fate);
    const rows = (['understood', 'approximated', 'not_understood'] as const).map((fate) => [fate, of(fate)] as const).filter(([, words]) => words.length);
    return <dl class="fates" aria-live="polite">
        {rows.map(([fate, words]) => <div key={fate} class={fate}><dt><span aria-hidden="true">{fates[fate]}</span> {t[fate]}</dt>
            <dd>{words.map((w, i) => <span key={i} class="word" title={w.meaning}>{w.words}{fate === 'approximated' && w.meaning ? <small> → {w.meaning}</small> : null}</span>)}</dd></div>)}
        {reading.not_placed.length > 0 && <div class="not_understood"><dt><span aria-hidden="true">!</span> {t.not_placed}</dt><dd>{reading.not_placed.map((w) => <span key={w} class="word">{w}</span>)}</dd></div>}
        {reading.assumed.length > 0 && <div class="assumed"><dt><span aria-hidden="true">○</span> {t.assumed}</dt><dd>{reading.assumed.map((w) => <span key={w} class="word">{w}</span>)}</dd></div>}
    </dl>;
};

const Own = ({ panorama, range, most, onPanorama, onRange }: {
    panorama: Upload | null; range: Upload | null; most: number; onPanorama: (u: Upload | null) => void; onRange: (u: Upload | null) => void;
}) => {
    const [over, setOver] = useState(false), [busy, setBusy] = useState('');
    const take = async (kind: 'panorama' | 'range', file?: File) => {
        if (!file) return;
        if (file.size > most) return notify(fill(t.too_large, file.name, most / 2 ** 20), { bad: true });
        setBusy(file.name);
        try {
            const got = await upload(kind, file);
            if (kind === 'panorama') onPanorama(got); else onRange(got);
        } catch (error) { fail(error); }
        setBusy('');
    };
    const input = (kind: 'panorama' | 'range', text: string) => <label class="button file-button">{text}
        <input type="file" class="visually-hidden" accept={kind === 'range' ? '.exr,.pfm,.png,.tif,.tiff' : 'image/*,.hdr,.exr,.tif,.tiff'}
            onChange={(e) => { take(kind, e.currentTarget.files?.[0]); e.currentTarget.value = ''; }} /></label>;
    return <div class={`drop ${over ? 'is-over' : ''}`} onDragOver={(e) => { e.preventDefault(); setOver(true); }} onDragLeave={() => setOver(false)}
        onDrop={(e) => { e.preventDefault(); setOver(false); take('panorama', e.dataTransfer?.files[0]); }}>
        {!panorama && <><p>{t.own_help}</p>{input('panorama', t.choose)}</>}
        {panorama && <div class="dropped"><img src={`/api/uploads/${encodeURIComponent(panorama.id)}`} alt="" />
            <div><strong>{panorama.name}</strong><br /><small>{panorama.width} × {panorama.height}</small>
                <ul class="warnings">{panorama.warnings?.map((w) => <li key={w}>{w}</li>)}</ul>
                <div class="row">{range ? <span class="chip">{range.name} · {range.width} × {range.height}</span> : input('range', t.range)}
                    <button class="quiet" onClick={() => { onPanorama(null); onRange(null); }}>{t.remove_file}</button></div></div></div>}
        {busy && <p role="status">{fill(t.checking, busy)}</p>}
    </div>;
};

const remembered = (key: string) => { try { return sessionStorage.getItem(key) ?? ''; } catch { return ''; } };
const remember = (key: string, value: string) => { try { sessionStorage.setItem(key, value); } catch { /* private window */ } };

export const Create = () => {
    const { state, jobs } = useShared();
    const [sentence, setSentence] = useState(remembered('sentence'));
    const [style, setStyle] = useState(''), [hour, setHour] = useState(''), [seed, setSeed] = useState(0);
    const [quality, setQuality] = useState(remembered('quality') || 'draft');
    const [reading, setReading] = useState<Reading | null>(null), [problem, setProblem] = useState('');
    const [panorama, setPanorama] = useState<Upload | null>(null), [range, setRange] = useState<Upload | null>(null);
    const [busy, setBusy] = useState(false);
    // What is asked for is the sentence alone: it is what the command line takes, too.
    const hours: Record<string, string> = { morning: 'in the morning', day: 'by day', evening: 'in the evening', dusk: 'at dusk', night: 'at night' };
    const prompt = [sentence.trim(), style && `${style} style`, hours[hour]].filter(Boolean).join(', ');
    const last = useRef(prompt);

    useEffect(() => {
        remember('sentence', sentence);
        remember('quality', quality);
        if (!sentence.trim()) { setReading(null); setProblem(''); return; }
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
        return () => { clearTimeout(timer); abort.abort(); };
    }, [prompt, seed, quality]);

    const seen = useLook(reading && !panorama && sentence.trim() ? `${seed} ${prompt}` : '', () => post('look', { prompt, seed }));

    const make = async () => {
        if (busy || (!sentence.trim() && !panorama)) return;
        setBusy(true);
        try {
            await post('jobs', { prompt: panorama ? sentence.trim() : prompt, seed, quality, panorama: panorama?.id ?? '', range: range?.id ?? '', name: panorama?.name ?? '' });
            await refresh();
            document.getElementById('queue')?.scrollIntoView({ behavior: 'smooth', block: 'nearest' });
        } catch (error) { fail(error); }
        setBusy(false);
    };
    const cost = state?.costs.find((c) => c.quality === quality), free = (state?.free_memory_bytes ?? 0) / 2 ** 30;
    const names: Record<string, [string, string]> = { draft: [t.draft, t.draft_for], standard: [t.standard, t.standard_for], high: [t.high_quality, t.high_for] };
    const view = reading?.view;
    return <>
        <section class="create">
            <div class="create-words">
                <h1>{t.lead}</h1>
                <Sentence value={sentence} reading={panorama ? null : reading} onInput={setSentence} onEnter={make} describedBy="enter-help reading" />
                <p id="enter-help" class="hint">{t.enter}</p>
                <div id="reading">{problem ? <p class="problem" role="alert">{problem}</p> : !panorama && <Understanding reading={reading} />}</div>
                {!sentence.trim() && !panorama && <div class="examples"><h2 class="small-title">{t.examples}</h2>
                    {examples.map((e) => <button key={e} class="example" onClick={() => setSentence(e)}>{e}</button>)}</div>}
                <div class="options">
                    <fieldset class="qualities"><legend>{t.quality}</legend>
                        {(state?.costs ?? []).map((c) => <label key={c.quality} class={`quality ${quality === c.quality ? 'is-chosen' : ''}`} title={c.measured ? t.measured : t.estimated}>
                            <input type="radio" name="quality" class="visually-hidden" checked={quality === c.quality} onChange={() => setQuality(c.quality)} />
                            <strong>{names[c.quality]?.[0]}</strong><span>{names[c.quality]?.[1]}</span>
                            <small>{t.about} {minutes(c.seconds)} · {c.gib.toFixed(1)} GB</small></label>)}</fieldset>
                    {!panorama && <div class="fields">
                        <label>{t.style}<select value={style} onChange={(e) => setStyle(e.currentTarget.value)}><option value="">{t.as_said}</option>{state?.choices.styles.map((s) => <option key={s}>{s}</option>)}</select></label>
                        <label>{t.hour}<select value={hour} onChange={(e) => setHour(e.currentTarget.value)}><option value="">{t.as_said}</option>{state?.choices.hours.map((h) => <option key={h}>{h}</option>)}</select></label>
                        <label title={t.seed_help}>{t.seed}<span class="seed"><input type="number" min="0" max="4294967295" inputMode="numeric" value={seed} onInput={(e) => setSeed(Math.max(0, Math.floor(Number(e.currentTarget.value) || 0)))} />
                            <button class="icon-button" aria-label={t.dice} title={t.dice} onClick={() => setSeed(Math.floor(Math.random() * 10000))}>⚄</button></span></label></div>}
                    <details class="own" open={Boolean(panorama)}><summary>{t.own}</summary>
                        <Own panorama={panorama} range={range} most={state?.most_upload_bytes ?? 2 ** 26} onPanorama={setPanorama} onRange={setRange} /></details>
                </div>
                <div class="make-row"><button class="primary" disabled={busy || (!sentence.trim() && !panorama)} onClick={make}>{t.make}</button>
                    {cost && <span class="hint">{t.about} {minutes(cost.seconds)}, {cost.gib.toFixed(1)} GB {t.memory}</span>}</div>
                {cost && free > 0 && cost.gib > free && <p class="problem">{fill(t.low_memory, free.toFixed(1))}</p>}
            </div>
            {panorama && /\.(png|jpe?g|webp)$/.test(panorama.id) && hasWebGL() && <figure class="create-plan own-view">
                <Panorama key={panorama.id} url={`/api/uploads/${encodeURIComponent(panorama.id)}`} label={panorama.name} />
                <figcaption>{t.panorama_help}</figcaption></figure>}
            {!panorama && <figure class="create-plan">
                {view ? <Plan view={view} label={t.plan_of} /> : <div class="plan-empty"><svg viewBox="0 0 200 140" aria-hidden="true"><path d="M10 10H190V130H120M80 130H10V10M80 130A40 40 0 0 1 120 90M120 130V90M60 10v8H110v-8" /></svg><p>{t.plan_waits}</p></div>}
                {view && <Look look={seen} />}
                {view && <figcaption><strong>{view.type}</strong> · {view.style} · {view.width.toFixed(1)} × {view.depth.toFixed(1)} {t.metres} · {view.height.toFixed(1)} {t.metres} {t.high} · {view.hour}</figcaption>}
            </figure>}
        </section>
        <Queue jobs={jobs} />
        {state && state.scenes.length > 0 && <section aria-labelledby="recent"><div class="section-head"><h2 id="recent">{t.scenes}</h2>
            <a href="/gallery" onClick={(e) => { e.preventDefault(); go('/gallery'); }}>{t.back} ({state.scenes.length})</a></div>
            <ul class="grid">{state.scenes.slice(0, 6).map((s) => <Card key={s.name} scene={s} />)}</ul></section>}
    </>;
};
