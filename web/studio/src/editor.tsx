// The room's plan, to be changed: things are selected, dragged, turned, recolored, removed, added; or said in words.
// The server keeps the draft; each change names the revision that it was made on.
import { useEffect, useRef, useState } from 'preact/hooks';
import { get, part, post, Refused, type Draft, type SceneDetails, type Thing } from './api';
import { Look, useLook } from './look';
import { Plan } from './plan';
import { fail, go, notify, useShared } from './store';
import { minutes, t } from './text';

const swatches: [string, string][] = [['white', '#f3f1ec'], ['beige', '#d9c7a6'], ['grey', '#8f8f8c'], ['black', '#23211f'], ['brown', '#6b4630'], ['red', '#a3231f'],
    ['terracotta', '#b8573a'], ['orange', '#d57a2c'], ['yellow', '#dcb13c'], ['olive', '#6f7040'], ['sage', '#93a384'], ['green', '#2f6b45'], ['teal', '#226f72'], ['blue', '#2c5a9b'],
    ['navy', '#1f2e52'], ['purple', '#5f3d80'], ['pink', '#d896a6']];
const materials = ['oak', 'walnut', 'velvet', 'leather', 'linen', 'rattan', 'marble', 'brass', 'glass'];

const Colors = ({ label, onPick }: { label: string; onPick: (looks: string) => void }) => <fieldset class="colors"><legend>{label}</legend>
    {swatches.map(([name, hex]) => <button key={name} class="swatch" style={{ background: hex }} title={name} aria-label={`${label}: ${name}`} onClick={() => onPick(name)} />)}
    <label class="swatch custom" title={t.custom}><input type="color" aria-label={`${label}: ${t.custom}`} onChange={(e) => onPick(e.currentTarget.value)} /></label></fieldset>;

const Say = ({ label, hint, button, busy, onSay, list }: { label: string; hint: string; button: string; busy: boolean; onSay: (words: string) => Promise<boolean>; list?: string[] }) => {
    const [words, setWords] = useState('');
    const id = button.replace(/\W/g, '');
    return <form class="say" onSubmit={async (e) => { e.preventDefault(); if (words.trim() && await onSay(words.trim())) setWords(''); }}>
        <label>{label}<input type="text" maxLength={400} placeholder={hint} value={words} list={list ? `list-${id}` : undefined} onInput={(e) => setWords(e.currentTarget.value)} /></label>
        {list && <datalist id={`list-${id}`}>{list.map((k) => <option key={k} value={k.replace(/_/g, ' ')} />)}</datalist>}
        <button disabled={busy || !words.trim()}>{button}</button></form>;
};

export const Editor = ({ scene }: { scene: SceneDetails }) => {
    const { state } = useShared();
    const [draft, setDraft] = useState<Draft | null>(null), [selected, setSelected] = useState(''), [busy, setBusy] = useState(false);
    const latest = useRef<Draft | null>(null), queue = useRef(Promise.resolve());
    const take = (next: Draft) => { latest.current = next; setDraft(next); };
    const load = () => get<Draft>(`scenes/${part(scene.name)}/draft`).then(take).catch(fail);
    useEffect(() => { load(); }, [scene.name]);

    // One after the other: each is made on what those before it gave.
    const change = (step: Record<string, unknown>): Promise<boolean> => {
        const work = queue.current.then(async () => {
            setBusy(true);
            try {
                take(await post<Draft>(`scenes/${part(scene.name)}/edit`, { revision: latest.current?.revision, step }));
                return true;
            } catch (error) {
                fail(error);
                if (error instanceof Refused && error.status === 409) await load();
                return false;
            } finally { setBusy(false); }
        });
        queue.current = work.then(() => undefined);
        return work;
    };
    const make = async () => {
        setBusy(true);
        try {
            await post(`scenes/${part(scene.name)}/remake`, { revision: draft!.revision });
            notify(t.remade);
            go('/');
        } catch (error) {
            fail(error);
            if (error instanceof Refused && error.status === 409) await load();
        }
        setBusy(false);
    };
    const look = useLook(draft && draft.changes.length > 0 ? String(draft.revision) : '', () => post(`scenes/${part(scene.name)}/look`));
    if (!draft) return <p class="loading" role="status">…</p>;
    const thing = draft.view.things.find((one) => one.id === selected);
    const move = (one: Thing, x: number, z: number) => change({ op: 'move', id: one.id, x, z, yaw_deg: one.yaw_deg });
    const turn = (one: Thing, by_deg: number) => change({ op: 'turn', id: one.id, by_deg });
    const remove = (one: Thing) => { setSelected(''); return change({ op: 'remove', id: one.id }); };
    const cost = state?.costs.find((c) => c.quality === scene.quality);
    // Near the top once there are some: what to do next.
    const changes = <section aria-labelledby="changes-title"><div class="row"><h2 id="changes-title" class="small-title grow">{t.changes}</h2>
                <button class="quiet" disabled={busy || !draft.can_undo} onClick={() => change({ op: 'undo' })}>{t.undo}</button>
                <button class="quiet" disabled={busy || !draft.can_redo} onClick={() => change({ op: 'redo' })}>{t.redo}</button>
                <button class="quiet" disabled={busy || draft.changes.length === 0} onClick={() => change({ op: 'reset' })}>{t.reset}</button></div>
                <ol class="change-list" aria-live="polite">{draft.changes.map((c, i) => <li key={i}><strong>{c.id}</strong> {c.what}</li>)}</ol>
                {draft.changes.length === 0 ? <p class="hint">{t.no_changes}</p> : <p class="hint">{t.saved_later}</p>}
                <button class="primary" disabled={busy || draft.changes.length === 0} onClick={make}>{t.remake}{cost ? ` · ${t.about} ${minutes(cost.seconds)}` : ''}</button></section>;
    return <div class="editor">
        <div class={`editor-plan ${busy ? 'is-busy' : ''} ${look.key ? 'has-look' : ''}`}>
            <Plan view={draft.view} label={t.plan} selected={selected} onSelect={setSelected} onMove={move} onTurn={turn} onRemove={remove} busy={busy} />
            <Look look={look} />
        </div>
        <aside class="inspector">
            <section>
                <label class="thing-choice">{t.select}<select value={thing?.id ?? ''} onChange={(e) => setSelected(e.currentTarget.value)}><option value="">–</option>
                    {[...draft.view.things].sort((a, b) => a.id.localeCompare(b.id)).map((one) => <option key={one.id} value={one.id}>{one.id.replace(/[_-]/g, ' ')}</option>)}</select></label>
                {!thing && <p class="hint">{t.nothing_selected}</p>}
                {thing && <><p class="hint">{thing.color_name || thing.material ? `${[thing.color_name, thing.material].filter(Boolean).join(', ')} · ` : ''}{thing.w.toFixed(2)} × {thing.d.toFixed(2)} × {thing.h.toFixed(2)} {t.metres}. {t.move_help}</p>
                    <div class="row" role="group" aria-label={t.turn}>
                        <button aria-label={t.turn_left} disabled={busy} onClick={() => turn(thing, 15)}>↺ 15°</button>
                        <button aria-label={t.turn_right} disabled={busy} onClick={() => turn(thing, -15)}>↻ 15°</button>
                        <button disabled={busy} onClick={() => turn(thing, -90)}>↻ 90°</button>
                        <button class="danger" disabled={busy} onClick={() => remove(thing)}>{t.remove}</button></div>
                    <Colors label={t.color} onPick={(looks) => change({ op: 'recolor', id: thing.id, looks })} />
                    <label>{t.material}<select value="" disabled={busy} onChange={(e) => { change({ op: 'recolor', id: thing.id, looks: e.currentTarget.value }); e.currentTarget.value = ''; }}><option value="">{thing.material || t.as_is}</option>{materials.map((m) => <option key={m}>{m}</option>)}</select></label></>}
            </section>
            {!thing && <section><h2 class="small-title">{t.room}</h2>
                <div class="fields two">
                    <label>{t.style}<select value={draft.view.style} disabled={busy} onChange={(e) => change({ op: 'style', value: e.currentTarget.value })}>{state?.choices.styles.map((s) => <option key={s}>{s}</option>)}</select></label>
                    <label>{t.hour}<select value={draft.view.hour} disabled={busy} onChange={(e) => change({ op: 'time', value: e.currentTarget.value })}>{state?.choices.hours.map((h) => <option key={h}>{h}</option>)}</select></label></div>
                <Colors label={t.walls} onPick={(looks) => change({ op: 'recolor', surface: 'wall', looks })} /></section>}
            {draft.changes.length > 0 && changes}
            <section><Say label={t.add} hint={t.add_hint} button={t.add_do} busy={busy} list={state?.choices.kinds} onSay={(words) => change({ op: 'add', words: /^(an?|the|two|three|some|\d)\b/.test(words) ? words : `a ${words}` })} />
                <Say label={t.say} hint={t.say_hint} button={t.say_do} busy={busy} onSay={(words) => change({ op: 'say', words })} /></section>
            {draft.changes.length === 0 && changes}
        </aside>
    </div>;
};
