// What all pages share: the server's state, kept current by its stream of events.
import { useEffect, useState } from 'preact/hooks';
import { get, part, type FilmWork, type Job, type State } from './api';
import { t } from './text';

export interface Notice {
    id: number;
    text: string;
    action?: { label: string; run: () => void };
    bad?: boolean;
}

interface Shared {
    state: State | null;
    jobs: Job[];
    notices: Notice[];
    online: boolean;
    path: string;
    look: string;
    film: FilmWork | null;
}
const shared: Shared = { state: null, jobs: [], notices: [], online: true, path: location.pathname, look: '', film: null };
const listeners = new Set<() => void>();
const tell = () => listeners.forEach((listener) => listener());

export const useShared = (): Shared => {
    const [, again] = useState(0);
    useEffect(() => {
        const listener = () => again((n) => n + 1);
        listeners.add(listener);
        return () => {
            listeners.delete(listener);
        };
    }, []);
    return shared;
};

export const refresh = async () => {
    try {
        shared.state = await get<State>('state');
        shared.jobs = shared.state.jobs;
        shared.online = true;
    } catch {
        shared.online = false;
    }
    tell();
};

let notices = 0;
const shown_ms = 8000;
export const notify = (text: string, more: Omit<Notice, 'id' | 'text'> = {}) => {
    const id = ++notices;
    shared.notices = [...shared.notices.slice(-2), { id, text, ...more }];
    tell();
    setTimeout(() => dismiss(id), shown_ms);
};
export const dismiss = (id: number) => {
    shared.notices = shared.notices.filter((n) => n.id !== id);
    tell();
};
export const fail = (error: unknown) => {
    if (error instanceof DOMException && error.name === 'AbortError') return;
    notify(error instanceof Error ? error.message : String(error), { bad: true });
};

export const go = (path: string) => {
    if (path !== location.pathname) history.pushState(null, '', path);
    shared.path = path;
    tell();
    scrollTo(0, 0);
};
addEventListener('popstate', () => {
    shared.path = location.pathname;
    tell();
});

// Scenes and costs change when a job ends; while it runs only the jobs do.
const ended = (jobs: Job[]) =>
    jobs
        .filter((j) => j.state === 'finished' || j.state === 'failed')
        .map((j) => j.id)
        .join();

// Who looks at another page learns that a scene is ready.
const tellEnds = (before: Job[], now: Job[]) => {
    for (const job of now) {
        const was = before.find((one) => one.id === job.id)?.state;
        if (was === job.state || was === undefined) continue;
        if (job.state === 'finished')
            notify(`${job.request.title}: ${t.finished}`, {
                action: { label: t.open, run: () => go(`/scene/${part(job.id)}`) },
            });
        if (job.state === 'failed') notify(`${job.request.title}: ${job.error}`, { bad: true });
    }
    const running = now.find((job) => job.state === 'running');
    if (!shared.path.startsWith('/scene/'))
        document.title = running
            ? `${Math.round(100 * running.overall)} % · ${running.request.title}`
            : 'fastscene studio';
};

let source: EventSource | null = null;
const listen = () => {
    source = new EventSource('/api/events');
    source.onopen = () => {
        if (!shared.online) refresh();
    };
    source.onmessage = (event) => {
        const { jobs, look, film } = JSON.parse(event.data) as { jobs: Job[]; look: string; film: FilmWork };
        shared.look = look;
        shared.film = film;
        const scenes = ended(jobs) !== ended(shared.jobs) || jobs.length !== shared.jobs.length;
        tellEnds(shared.jobs, jobs);
        shared.jobs = jobs;
        shared.online = true;
        if (scenes) refresh();
        else tell();
    };
    source.onerror = () => {
        shared.online = false;
        tell();
    };
};
// A browser opens few connections to one server: pages in the background leave theirs to others.
export const begin = () => {
    refresh();
    listen();
    document.addEventListener('visibilitychange', () => {
        source?.close();
        if (document.visibilityState === 'visible') {
            refresh();
            listen();
        }
    });
};
