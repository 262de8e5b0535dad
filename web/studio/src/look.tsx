// A coarse picture of a room that is not made yet, once what it is made from rests.
import { useEffect, useState } from 'preact/hooks';
import { useShared } from './store';
import { t } from './text';

const rest_ms = 1200;

// `of`: what the room is made from, or '' for nothing. The picture of an earlier room stays until the next one comes.
export const useLook = (of: string, wish: () => Promise<unknown>) => {
    const { look } = useShared();
    const [wished, setWished] = useState(''),
        [key, setKey] = useState('');
    useEffect(() => {
        setWished('');
        if (!of) {
            setKey('');
            return;
        }
        const timer = setTimeout(
            () =>
                wish()
                    .then((answer) => setWished((answer as { key: string }).key))
                    .catch(() => {}),
            rest_ms,
        );
        return () => clearTimeout(timer);
    }, [of]);
    useEffect(() => {
        if (look && look === wished) setKey(look);
    }, [look, wished]);
    return { key, isCurrent: key !== '' && key === wished };
};

export const Look = ({ look }: { look: ReturnType<typeof useLook> }) =>
    look.key ? (
        <img
            class={`look ${look.isCurrent ? '' : 'is-old'}`}
            key={look.key}
            src={`/api/looks/${look.key}`}
            alt={t.look_alt}
        />
    ) : null;
