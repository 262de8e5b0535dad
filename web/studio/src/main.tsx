import '@fontsource-variable/inter';
import '@fontsource-variable/newsreader/opsz.css';
import '@fontsource-variable/newsreader/opsz-italic.css';
import { render } from 'preact';
import { Create } from './create';
import { Gallery } from './gallery';
import { ScenePage } from './scene';
import { begin, dismiss, go, useShared } from './store';
import './style.css';
import { language, languages, speak, t, type Language } from './text';

const Link = ({ to, path, children }: { to: string; path: string; children: preact.ComponentChildren }) => (
    <a
        href={to}
        aria-current={path === to ? 'page' : undefined}
        onClick={(e) => {
            e.preventDefault();
            go(to);
        }}
    >
        {children}
    </a>
);

const App = () => {
    const { path, state, jobs, notices, online } = useShared();
    const running = jobs.find((j) => j.state === 'running');
    const scene = /^\/scene\/([^/]+)\/?$/.exec(path)?.[1];
    return (
        <>
            <a class="skip" href="#main">
                {t.skip}
            </a>
            <header class="top">
                <a
                    class="brand"
                    href="/"
                    onClick={(e) => {
                        e.preventDefault();
                        go('/');
                    }}
                >
                    <img src="/icon.svg" alt="" width="28" height="28" />
                    <span>
                        fastscene <em>studio</em>
                    </span>
                </a>
                <nav>
                    <Link to="/" path={path}>
                        {t.create}
                    </Link>
                    <Link to="/gallery" path={path}>
                        {t.scenes}
                        {state && state.scenes.length > 0 ? <span class="count">{state.scenes.length}</span> : null}
                    </Link>
                </nav>
                <span class="grow" />
                {running && (
                    <button
                        class="running"
                        onClick={() => {
                            go('/');
                            setTimeout(
                                () => document.getElementById('queue')?.scrollIntoView({ behavior: 'smooth' }),
                                50,
                            );
                        }}
                    >
                        <span class="dot" aria-hidden="true" />
                        <span class="running-title">{running.request.title}</span> {Math.round(100 * running.overall)} %
                    </button>
                )}
            </header>
            {!online && (
                <p class="offline" role="alert">
                    {t.offline}
                </p>
            )}
            <main id="main" tabIndex={-1}>
                {path === '/' ? (
                    <Create />
                ) : path === '/gallery' ? (
                    <Gallery />
                ) : scene ? (
                    <ScenePage key={scene} name={decodeURIComponent(scene)} />
                ) : (
                    <section class="lost">
                        <h1>{t.lost}</h1>
                        <Link to="/" path={path}>
                            {t.create}
                        </Link>
                    </section>
                )}
            </main>
            <footer>
                <span>fastscene {state?.version}</span>
                <span class="folder">{state?.folder}</span>
                <label class="language">
                    <span class="visually-hidden">{t.language}</span>
                    <select value={language} onChange={(e) => speak(e.currentTarget.value as Language)}>
                        {Object.entries(languages).map(([code, name]) => (
                            <option key={code} value={code}>
                                {name}
                            </option>
                        ))}
                    </select>
                </label>
                <a href="/licenses.txt" target="_blank" rel="noopener">
                    {t.licenses}
                </a>
            </footer>
            <div class="notices" role="status" aria-live="polite">
                {notices.map((n) => (
                    <div key={n.id} class={`notice ${n.bad ? 'is-bad' : ''}`}>
                        <span>{n.text}</span>
                        {n.action && (
                            <button
                                onClick={() => {
                                    n.action!.run();
                                    dismiss(n.id);
                                }}
                            >
                                {n.action.label}
                            </button>
                        )}
                        <button class="quiet" aria-label={t.close} onClick={() => dismiss(n.id)}>
                            ✕
                        </button>
                    </div>
                ))}
            </div>
        </>
    );
};

begin();
render(<App />, document.getElementById('app')!);
