// The sentence with its words marked, and what is understood of them.
import { useEffect, useMemo, useRef } from 'preact/hooks';
import type { Reading } from './api';
import { t } from './text';

const fates = { understood: '✓', approximated: '≈', not_understood: '✕' } as const;

// Words come back in lower case and without accents, in their order.
const folded = (text: string) => [...text].map((c) => c.normalize('NFD')[0].toLowerCase()).join('');
interface Piece {
    text: string;
    fate?: keyof typeof fates;
    meaning?: string;
}
const marked = (sentence: string, reading: Reading | null): Piece[] => {
    const chars = [...sentence],
        plain = folded(sentence),
        pieces: Piece[] = [];
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

export const Sentence = ({
    value,
    reading,
    onInput,
    onEnter,
    describedBy,
}: {
    value: string;
    reading: Reading | null;
    onInput: (text: string) => void;
    onEnter: () => void;
    describedBy: string;
}) => {
    const area = useRef<HTMLTextAreaElement>(null);
    const pieces = useMemo(() => marked(value, reading), [value, reading]);
    useEffect(() => {
        if (matchMedia('(hover: hover)').matches) area.current?.focus({ preventScroll: true });
    }, []);
    return (
        <div class="sentence">
            <div class="sentence-marks" aria-hidden="true">
                {pieces.map((p, i) =>
                    p.fate ? (
                        <mark key={i} class={p.fate}>
                            {p.text}
                        </mark>
                    ) : (
                        p.text
                    ),
                )}
                {'\u200b'}
            </div>
            <textarea
                ref={area}
                rows={3}
                maxLength={2000}
                spellcheck={false}
                aria-label={t.sentence}
                aria-describedby={describedBy}
                placeholder={t.placeholder}
                value={value}
                onInput={(e) => onInput(e.currentTarget.value)}
                onKeyDown={(e) => {
                    if (e.key === 'Enter' && !e.shiftKey && !e.isComposing) {
                        e.preventDefault();
                        onEnter();
                    }
                }}
            />
        </div>
    );
};

export const Understanding = ({ reading }: { reading: Reading | null }) => {
    if (!reading) return null;
    const of = (fate: string) => reading.words.filter((w) => w.fate === fate);
    const rows = (['understood', 'approximated', 'not_understood'] as const)
        .map((fate) => [fate, of(fate)] as const)
        .filter(([, words]) => words.length);
    return (
        <dl class="fates" aria-live="polite">
            {rows.map(([fate, words]) => (
                <div key={fate} class={fate}>
                    <dt>
                        <span aria-hidden="true">{fates[fate]}</span> {t[fate]}
                    </dt>
                    <dd>
                        {words.map((w, i) => (
                            <span key={i} class="word" title={w.meaning}>
                                {w.words}
                                {fate === 'approximated' && w.meaning ? <small> → {w.meaning}</small> : null}
                            </span>
                        ))}
                    </dd>
                </div>
            ))}
            {reading.not_placed.length > 0 && (
                <div class="not_understood">
                    <dt>
                        <span aria-hidden="true">!</span> {t.not_placed}
                    </dt>
                    <dd>
                        {reading.not_placed.map((w) => (
                            <span key={w} class="word">
                                {w}
                            </span>
                        ))}
                    </dd>
                </div>
            )}
            {reading.assumed.length > 0 && (
                <div class="assumed">
                    <dt>
                        <span aria-hidden="true">○</span> {t.assumed}
                    </dt>
                    <dd>
                        {reading.assumed.map((w) => (
                            <span key={w} class="word">
                                {w}
                            </span>
                        ))}
                    </dd>
                </div>
            )}
        </dl>
    );
};
