// The room's plan, to be changed: things are selected, dragged, turned, recolored, removed, added; or said in words.
// The server keeps the draft; each change names the revision that it was made on.
import { useEffect, useRef, useState } from 'preact/hooks';
import {
    get,
    part,
    post,
    Refused,
    type Change,
    type Draft,
    type PlanView,
    type SceneDetails,
    type State,
    type Thing,
} from './api';
import { Look, useLook } from './look';
import { Plan } from './plan';
import { fail, go, notify, useShared } from './store';
import { minutes, t } from './text';

const swatches: [string, string][] = [
    ['white', '#f3f1ec'],
    ['beige', '#d9c7a6'],
    ['grey', '#8f8f8c'],
    ['black', '#23211f'],
    ['brown', '#6b4630'],
    ['red', '#a3231f'],
    ['terracotta', '#b8573a'],
    ['orange', '#d57a2c'],
    ['yellow', '#dcb13c'],
    ['olive', '#6f7040'],
    ['sage', '#93a384'],
    ['green', '#2f6b45'],
    ['teal', '#226f72'],
    ['blue', '#2c5a9b'],
    ['navy', '#1f2e52'],
    ['purple', '#5f3d80'],
    ['pink', '#d896a6'],
];
const materials = ['oak', 'walnut', 'velvet', 'leather', 'linen', 'rattan', 'marble', 'brass', 'glass'];

const Colors = ({ label, onPick }: { label: string; onPick: (looks: string) => void }) => (
    <fieldset class="colors">
        <legend>{label}</legend>
        {swatches.map(([name, hex]) => (
            <button
                key={name}
                class="swatch"
                style={{ background: hex }}
                title={name}
                aria-label={`${label}: ${name}`}
                onClick={() => onPick(name)}
            />
        ))}
        <label class="swatch custom" title={t.custom}>
            <input type="color" aria-label={`${label}: ${t.custom}`} onChange={(e) => onPick(e.currentTarget.value)} />
        </label>
    </fieldset>
);

const Say = ({
    label,
    hint,
    button,
    busy,
    onSay,
    list,
}: {
    label: string;
    hint: string;
    button: string;
    busy: boolean;
    onSay: (words: string) => Promise<boolean>;
    list?: string[];
}) => {
    const [words, setWords] = useState('');
    const id = button.replace(/\W/g, '');
    return (
        <form
            class="say"
            onSubmit={async (e) => {
                e.preventDefault();
                if (words.trim() && (await onSay(words.trim()))) setWords('');
            }}
        >
            <label>
                {label}
                <input
                    type="text"
                    maxLength={400}
                    placeholder={hint}
                    value={words}
                    list={list ? `list-${id}` : undefined}
                    onInput={(e) => setWords(e.currentTarget.value)}
                />
            </label>
            {list && (
                <datalist id={`list-${id}`}>
                    {list.map((k) => (
                        <option key={k} value={k.replace(/_/g, ' ')} />
                    ))}
                </datalist>
            )}
            <button disabled={busy || !words.trim()}>{button}</button>
        </form>
    );
};

type Step = Record<string, unknown>;

// The scene's draft, and changes to it: one after the other, each on what those before it gave.
const useDraft = (scene: string) => {
    const [draft, setDraft] = useState<Draft | null>(null),
        [busy, setBusy] = useState(false);
    const latest = useRef<Draft | null>(null),
        queue = useRef(Promise.resolve());
    const take = (next: Draft) => {
        latest.current = next;
        setDraft(next);
    };
    const load = () =>
        get<Draft>(`scenes/${part(scene)}/draft`)
            .then(take)
            .catch(fail);
    useEffect(() => {
        load();
    }, [scene]);
    const attempt = async (work: () => Promise<void>) => {
        setBusy(true);
        try {
            await work();
            return true;
        } catch (error) {
            fail(error);
            if (error instanceof Refused && error.status === 409) await load();
            return false;
        } finally {
            setBusy(false);
        }
    };
    const change = (step: Step): Promise<boolean> => {
        const work = queue.current.then(() =>
            attempt(async () =>
                take(await post<Draft>(`scenes/${part(scene)}/edit`, { revision: latest.current?.revision, step })),
            ),
        );
        queue.current = work.then(() => undefined);
        return work;
    };
    const remake = () =>
        attempt(async () => {
            await post(`scenes/${part(scene)}/remake`, { revision: latest.current?.revision });
            notify(t.remade);
            go('/');
        });
    return { draft, busy, change, remake };
};

interface PartProps {
    busy: boolean;
    change: (step: Step) => Promise<boolean>;
}

const ThingPanel = ({
    thing,
    busy,
    change,
    onTurn,
    onRemove,
}: PartProps & { thing: Thing; onTurn: (by_deg: number) => void; onRemove: () => void }) => {
    const looks = [thing.color_name, thing.material].filter(Boolean).join(', ');
    const recolor = (words: string) => change({ op: 'recolor', id: thing.id, looks: words });
    // Seen from above, a growing angle turns to the left.
    return (
        <>
            <p class="hint">
                {looks ? `${looks} · ` : ''}
                {thing.w.toFixed(2)} × {thing.d.toFixed(2)} × {thing.h.toFixed(2)} {t.metres}. {t.move_help}
            </p>
            <div class="row" role="group" aria-label={t.turn}>
                <button aria-label={t.turn_left} disabled={busy} onClick={() => onTurn(15)}>
                    ↺ 15°
                </button>
                <button aria-label={t.turn_right} disabled={busy} onClick={() => onTurn(-15)}>
                    ↻ 15°
                </button>
                <button disabled={busy} onClick={() => onTurn(-90)}>
                    ↻ 90°
                </button>
                <button class="danger" disabled={busy} onClick={onRemove}>
                    {t.remove}
                </button>
            </div>
            <Colors label={t.color} onPick={recolor} />
            <label>
                {t.material}
                <select
                    value=""
                    disabled={busy}
                    onChange={(e) => {
                        recolor(e.currentTarget.value);
                        e.currentTarget.value = '';
                    }}
                >
                    <option value="">{thing.material || t.as_is}</option>
                    {materials.map((m) => (
                        <option key={m}>{m}</option>
                    ))}
                </select>
            </label>
        </>
    );
};

const RoomPanel = ({ view, choices, busy, change }: PartProps & { view: PlanView; choices?: State['choices'] }) => {
    const select = (label: string, op: string, value: string, all: string[] = []) => (
        <label>
            {label}
            <select value={value} disabled={busy} onChange={(e) => change({ op, value: e.currentTarget.value })}>
                {all.map((one) => (
                    <option key={one}>{one}</option>
                ))}
            </select>
        </label>
    );
    return (
        <section>
            <h2 class="small-title">{t.room}</h2>
            <div class="fields two">
                {select(t.style, 'style', view.style, choices?.styles)}
                {select(t.hour, 'time', view.hour, choices?.hours)}
            </div>
            <Colors label={t.walls} onPick={(looks) => change({ op: 'recolor', surface: 'wall', looks })} />
        </section>
    );
};

const withArticle = (words: string) => (/^(an?|the|two|three|four|some|\d)\b/.test(words) ? words : `a ${words}`);
const WordsPanel = ({ kinds, busy, change }: PartProps & { kinds?: string[] }) => (
    <section>
        <Say
            label={t.add}
            hint={t.add_hint}
            button={t.add_do}
            busy={busy}
            list={kinds}
            onSay={(words) => change({ op: 'add', words: withArticle(words) })}
        />
        <Say
            label={t.say}
            hint={t.say_hint}
            button={t.say_do}
            busy={busy}
            onSay={(words) => change({ op: 'say', words })}
        />
    </section>
);

const ChangesPanel = ({
    draft,
    busy,
    change,
    cost_s,
    onMake,
}: PartProps & { draft: Draft; cost_s?: number; onMake: () => void }) => {
    const none = draft.changes.length === 0;
    return (
        <section aria-labelledby="changes-title">
            <div class="row">
                <h2 id="changes-title" class="small-title grow">
                    {t.changes}
                </h2>
                <button class="quiet" disabled={busy || !draft.can_undo} onClick={() => change({ op: 'undo' })}>
                    {t.undo}
                </button>
                <button class="quiet" disabled={busy || !draft.can_redo} onClick={() => change({ op: 'redo' })}>
                    {t.redo}
                </button>
                <button class="quiet" disabled={busy || none} onClick={() => change({ op: 'reset' })}>
                    {t.reset}
                </button>
            </div>
            <ol class="change-list" aria-live="polite">
                {draft.changes.map((c: Change, i) => (
                    <li key={i}>
                        <strong>{c.id}</strong> {c.what}
                    </li>
                ))}
            </ol>
            <p class="hint">{none ? t.no_changes : t.saved_later}</p>
            <button class="primary" disabled={busy || none} onClick={onMake}>
                {t.remake}
                {cost_s ? ` · ${t.about} ${minutes(cost_s)}` : ''}
            </button>
        </section>
    );
};

const ThingChoice = ({
    things,
    selected,
    onSelect,
}: {
    things: Thing[];
    selected: string;
    onSelect: (id: string) => void;
}) => (
    <label class="thing-choice">
        {t.select}
        <select value={selected} onChange={(e) => onSelect(e.currentTarget.value)}>
            <option value="">–</option>
            {[...things]
                .sort((a, b) => a.id.localeCompare(b.id))
                .map((one) => (
                    <option key={one.id} value={one.id}>
                        {one.id.replace(/[_-]/g, ' ')}
                    </option>
                ))}
        </select>
    </label>
);

export const Editor = ({ scene }: { scene: SceneDetails }) => {
    const { state } = useShared();
    const { draft, busy, change, remake } = useDraft(scene.name);
    const [selected, setSelected] = useState('');
    const look = useLook(draft && draft.changes.length > 0 ? String(draft.revision) : '', () =>
        post(`scenes/${part(scene.name)}/look`),
    );
    if (!draft)
        return (
            <p class="loading" role="status">
                …
            </p>
        );
    const thing = draft.view.things.find((one) => one.id === selected);
    const turn = (one: Thing, by_deg: number) => change({ op: 'turn', id: one.id, by_deg });
    const remove = (one: Thing) => {
        setSelected('');
        change({ op: 'remove', id: one.id });
    };
    const changes = (
        <ChangesPanel
            draft={draft}
            busy={busy}
            change={change}
            cost_s={state?.costs.find((c) => c.quality === scene.quality)?.seconds}
            onMake={remake}
        />
    );
    const isChanged = draft.changes.length > 0;
    return (
        <div class="editor">
            <div class={`editor-plan ${busy ? 'is-busy' : ''} ${look.key ? 'has-look' : ''}`}>
                <Plan
                    view={draft.view}
                    label={t.plan}
                    selected={selected}
                    onSelect={setSelected}
                    busy={busy}
                    onTurn={turn}
                    onRemove={remove}
                    onMove={(one, x, z) => change({ op: 'move', id: one.id, x, z, yaw_deg: one.yaw_deg })}
                />
                <Look look={look} />
            </div>
            <aside class="inspector">
                <section>
                    <ThingChoice things={draft.view.things} selected={thing?.id ?? ''} onSelect={setSelected} />
                    {thing ? (
                        <ThingPanel
                            thing={thing}
                            busy={busy}
                            change={change}
                            onTurn={(by) => turn(thing, by)}
                            onRemove={() => remove(thing)}
                        />
                    ) : (
                        <p class="hint">{t.nothing_selected}</p>
                    )}
                </section>
                {isChanged && changes}
                {!thing && <RoomPanel view={draft.view} choices={state?.choices} busy={busy} change={change} />}
                <WordsPanel kinds={state?.choices.kinds} busy={busy} change={change} />
                {!isChanged && changes}
            </aside>
        </div>
    );
};
