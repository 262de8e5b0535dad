// What is being made, with its pictures as they come.
import { useEffect, useState } from 'preact/hooks';
import { part, post, type Job } from './api';
import { fail, go, refresh } from './store';
import { clock, t } from './text';

const act = (job: Job, what: string) =>
    post(`jobs/${part(job.id)}/${what}`)
        .then(refresh)
        .catch(fail);
const workOf = (job: Job) => t.works[job.work.split(':')[0]] ?? (job.work || t.starting);

const Picture = ({ job }: { job: Job }) => {
    if (job.state === 'finished') return <img src={`/files/${part(job.id)}/preview.jpg`} alt={t.panorama_alt} />;
    if (!job.picture) return <div class={`no-picture ${job.state === 'running' ? 'is-waiting' : ''}`} />;
    return (
        <img
            key={job.picture}
            class={job.picture}
            src={`/api/jobs/${part(job.id)}/picture?${job.picture}-${job.picture_version}`}
            alt={t[`${job.picture}_alt`]}
        />
    );
};

// The server tells of changes; between them the time goes on.
const useNow = (running: boolean) => {
    const [, tick] = useState(0);
    useEffect(() => {
        if (!running) return;
        const timer = setInterval(() => tick((n) => n + 1), 1000);
        return () => clearInterval(timer);
    }, [running]);
};

const Item = ({ job }: { job: Job }) => {
    const running = job.state === 'running',
        percent = Math.round(100 * (job.state === 'finished' ? 1 : job.overall));
    useNow(running);
    const name = job.request.title;
    return (
        <li class={`job is-${job.state}`}>
            <Picture job={job} />
            <div class="job-words">
                <h3>{name}</h3>
                {job.request.changes && (
                    <p class="hint">
                        {t.changed}: {job.request.changes.map((c) => `${c.id} ${c.what}`).join('; ')}
                    </p>
                )}
                <p class="job-state">
                    {running ? (
                        <>
                            {workOf(job)}
                            {job.overall > 0 && <> · {percent} %</>}
                            {job.seconds_left >= 0 && job.overall > 0.02 && (
                                <>
                                    {' '}
                                    · {t.about} {clock(job.seconds_left)} {t.left}
                                </>
                            )}
                        </>
                    ) : (
                        t[job.state]
                    )}
                    {!running && job.request.quality && (
                        <> · {t[job.request.quality as 'draft'] ?? job.request.quality}</>
                    )}
                </p>
                {(running || job.state === 'stopped') && (
                    <progress
                        max="100"
                        value={job.overall > 0 ? percent : undefined}
                        aria-label={`${name}: ${workOf(job)}`}
                    />
                )}
                {job.error && (
                    <p class="problem" role="alert">
                        {job.error}
                    </p>
                )}
                {job.warnings.length > 0 && (
                    <ul class="warnings">
                        {job.warnings.map((w) => (
                            <li key={w}>{w}</li>
                        ))}
                    </ul>
                )}
                <div class="row">
                    {job.state === 'finished' && (
                        <button class="primary small" onClick={() => go(`/scene/${part(job.id)}`)}>
                            {t.open}
                        </button>
                    )}
                    {(running || job.state === 'waiting') && (
                        <button onClick={() => act(job, 'stop')} aria-label={`${t.stop}: ${name}`}>
                            {t.stop}
                        </button>
                    )}
                    {job.state === 'waiting' && (
                        <button class="quiet" onClick={() => act(job, 'first')}>
                            {t.first}
                        </button>
                    )}
                    {job.state === 'stopped' && (
                        <button onClick={() => act(job, 'resume')} aria-label={`${t.resume}: ${name}`}>
                            {t.resume}
                        </button>
                    )}
                    {job.state === 'failed' && <button onClick={() => act(job, 'resume')}>{t.retry}</button>}
                    {!running && (
                        <button class="quiet" onClick={() => act(job, 'forget')}>
                            {job.state === 'finished' ? t.close : t.forget}
                        </button>
                    )}
                </div>
            </div>
        </li>
    );
};

export const Queue = ({ jobs }: { jobs: Job[] }) => {
    const running = jobs.find((j) => j.state === 'running');
    // Said aloud in tenths, not at each step.
    const spoken = running
        ? `${running.request.title}: ${workOf(running)}, ${10 * Math.floor(10 * running.overall)} %`
        : '';
    return (
        <section id="queue" aria-labelledby="queue-title" hidden={jobs.length === 0}>
            <div class="section-head">
                <h2 id="queue-title">{t.queue}</h2>
            </div>
            <p class="visually-hidden" aria-live="polite">
                {spoken}
            </p>
            <ul class="jobs">
                {[...jobs]
                    .sort((a, b) => rank(a) - rank(b))
                    .map((job) => (
                        <Item key={job.id} job={job} />
                    ))}
            </ul>
        </section>
    );
};
const rank = (job: Job) => ({ running: 0, finished: 1, failed: 2, waiting: 3, stopped: 4 })[job.state];
