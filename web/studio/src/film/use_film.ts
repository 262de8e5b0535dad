// The scene's path: each change is saved, and what the server made of it is shown.
import { useEffect, useRef, useState } from 'preact/hooks';
import { get, part, post, type CameraPath, type Film } from '../api';
import { fail } from '../store';
import { sorted } from './camera_path';

export const useFilm = (scene: string) => {
    const [film, setFilm] = useState<Film | null>(null),
        [lost, setLost] = useState(''),
        [version, setVersion] = useState(0);
    const latest = useRef<Film | null>(null);
    const take = (next: Partial<Film>) => {
        latest.current = { ...(latest.current as Film), ...next };
        setFilm(latest.current);
        setVersion((n) => n + 1);
    };
    const load = () =>
        get<Film>(`scenes/${part(scene)}/film`)
            .then(take)
            .catch((e) => setLost(e.message));
    useEffect(() => {
        load();
    }, [scene]);
    const send = (what: string, body: unknown) =>
        post<Partial<Film>>(`scenes/${part(scene)}/film/${what}`, body)
            .then(take)
            .catch((error) => {
                fail(error);
                if (latest.current) setFilm({ ...latest.current });
            });
    const change = (path: Partial<CameraPath>) => {
        const next = { ...latest.current!.path, ...path };
        return send('path', { path: { ...next, keys: sorted(next.keys) } });
    };
    return { film, lost, version, send, change, load };
};
