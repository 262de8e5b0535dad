// From a sentence to walking and back, in Chromium: types, waits for a small real scene, walks, changes a color, makes it
// anew, compares, deletes and undoes; in between the studio is killed.
//   node studio_check.mjs FASTSCENE WEB_DIR OUT_DIR
import { spawn } from 'node:child_process';
import path from 'node:path';
import { openChromium } from '../readers/open_chromium.mjs';

const [fastscene, web, out] = process.argv.slice(2);
// As tests/end_to_end/lib.sh has it: a scene in seconds.
const tiny = (
    '--panorama-width 128 --panorama-cell 0.25 --panorama-cell-samples 8 --panorama-pixel-samples 2 ' +
    '--panorama-outside-detail 0 --walk-viewpoints 2 --walk-room-viewpoints 2 --views-size 48 --views-points 4000 ' +
    '--splat-count 2000 --splat-steps 1500'
).split(' ');
let failed = false;
const expect = (ok, text) => {
    if (!ok) failed = true;
    console.log(`studio: ${ok ? 'ok' : 'FAILED'}: ${text}`);
};

let server;
const start = async (port = '0') => {
    const begun = Date.now();
    server = spawn(fastscene, ['studio', path.join(out, 'scenes'), '--port', port, '--no-open', ...tiny], {
        stdio: ['ignore', 'pipe', 'inherit'],
        env: { ...process.env, OMP_WAIT_POLICY: 'passive' },
    });
    const address = await new Promise((resolve, reject) => {
        server.stdout.once('data', (text) => resolve(String(text).trim()));
        server.once('exit', (code) => reject(new Error(`the studio ended with code ${code}`)));
    });
    console.log(`studio: started in ${Date.now() - begun} ms`);
    return address;
};
const end = (signal) =>
    new Promise((resolve) => {
        server.removeAllListeners('exit');
        server.once('exit', resolve);
        server.kill(signal);
    });

let address = await start();
const browser = await openChromium(web);
const open = async (options = {}) => {
    const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, locale: 'en-US', ...options });
    const page = await context.newPage();
    page.setDefaultNavigationTimeout(90_000);  // beside a scene in the making, on a busy machine
    page.said = [];
    page.on('console', (m) => m.type() === 'error' && page.said.push(m.text()));
    page.on('pageerror', (e) => page.said.push(String(e)));
    page.on(
        'request',
        (r) =>
            /^(data|blob):/.test(r.url()) ||
            r.url().startsWith(address) ||
            expect(false, `no request leaves: ${r.url()}`),
    );
    return page;
};
// Tries until it holds; the pages' policy forbids Playwright's own waiting by strings.
const until = async (text, holds, seconds = 60) => {
    for (const begun = Date.now(); Date.now() - begun < 1000 * seconds; await new Promise((r) => setTimeout(r, 150)))
        if (await holds().catch(() => false)) return expect(true, `${text} (${Date.now() - begun} ms)`);
    return expect(false, text);
};
const shot = (page, name) => page.screenshot({ path: path.join(out, `${name}.png`) });
// Everything that can be used has a name; nothing is wider than the page.
const usable = async (page, what) => {
    const nameless = await page.evaluate(() =>
        [...document.querySelectorAll('button, a[href], input, select, textarea, iframe, [role=button], [role=tab]')]
            .filter(
                (e) =>
                    !(
                        e.getAttribute('aria-label') ||
                        e.textContent.trim() ||
                        e.labels?.length ||
                        e.title ||
                        e.querySelector?.('img[alt]')
                    ),
            )
            .map((e) => e.outerHTML.slice(0, 80)),
    );
    expect(nameless.length === 0, `${what}: all controls have names ${nameless}`);
    const width = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(width <= 0, `${what}: nothing sticks out (${width} px)`);
};
// WCAG's contrast of what is written, against the color behind it.
const legible = async (page, what) => {
    const dim = await page.evaluate(() => {
        const parse = (c) => (c.match(/[\d.]+/g) ?? []).map(Number),
            linear = (v) => (v / 255 <= 0.04045 ? v / 3294.6 : ((v / 255 + 0.055) / 1.055) ** 2.4);
        const light = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
        const behind = (e) => {
            for (; e; e = e.parentElement) {
                const c = parse(getComputedStyle(e).backgroundColor);
                if (c.length && (c[3] ?? 1) > 0.8 && !/color/.test(getComputedStyle(e).backgroundColor)) return c;
            }
            return [255, 255, 255];
        };
        return [
            ...document.querySelectorAll(
                'h1, h2, h3, p, dt, dd span, label, legend, small, button:not(:disabled), nav a, footer span, .card-title',
            ),
        ]
            .filter(
                (e) =>
                    e.textContent.trim() &&
                    e.getClientRects().length &&
                    !e.closest('.visually-hidden, .stage, .notices, .swatch, .skip'),
            )
            .map((e) => {
                const a = light(parse(getComputedStyle(e).color)),
                    b = light(behind(e));
                return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), e.textContent.trim().slice(0, 30)];
            })
            .filter(([ratio]) => ratio < 4.5);
    });
    expect(dim.length === 0, `${what}: text is legible ${dim.map(([r, text]) => `${r.toFixed(1)} "${text}"`)}`);
};

try {
    const page = await open();
    const sentence = 'a cozy bedroom with a red armchair, a kraken and a large window';
    let begun = Date.now();
    await page.goto(address);
    await page.waitForSelector('.quality');
    console.log(`studio: usable after ${Date.now() - begun} ms`);
    await page.keyboard.press('Shift+Tab');
    await page.fill('textarea', sentence);
    begun = Date.now();
    await page.waitForSelector('svg.plan');
    console.log(`studio: planned after ${Date.now() - begun} ms`);
    const fates = await page.locator('.fates').innerText();
    expect(/not understood\s+kraken/.test(fates) && /understood\s+cozy/.test(fates), 'words have their fates in words');
    await usable(page, 'create');
    await legible(page, 'create');
    await until('a picture of a sentence that rests', async () => (await page.locator('.look').count()) > 0);
    await shot(page, 'create');

    // Which pictures a job shows, some for less than a second.
    await page.evaluate(() => {
        window.shown = new Set();
        new MutationObserver(() =>
            document.querySelectorAll('.job img').forEach((img) => window.shown.add(img.className)),
        ).observe(document.body, { subtree: true, childList: true, attributes: true });
    });
    await page.focus('textarea');
    await page.keyboard.press('Enter');
    await until('a first picture', async () => (await page.locator('.job img').count()) > 0);
    await shot(page, 'making');
    await until('the scene is finished', async () => (await page.locator('.job.is-finished').count()) > 0, 120);
    const shown = await page.evaluate(() => [...window.shown].join(' '));
    expect(/\bpanorama\b.*\bsplats\b/.test(shown), `pictures as they come: ${shown}`);
    await page.click('.job.is-finished .primary');

    // Walking: the viewer is in an origin of its own.
    await page.waitForSelector('iframe');
    const viewer = await (await page.waitForSelector('iframe')).contentFrame();
    const camera = () =>
        viewer.evaluate(() => {
            const p = window.app.root.findComponent('camera').entity.getPosition();
            return [p.x, p.y, p.z];
        });
    await until('the viewer is there', async () => (await camera()).length === 3);
    expect(
        (await viewer.evaluate(() => {
            try {
                return window.parent.document.title;
            } catch {
                return '';
            }
        })) === '',
        'a scene cannot read the studio',
    );
    const before = await camera();
    await page.locator('iframe').click({ position: { x: 300, y: 200 } });
    await page.keyboard.press('2');
    await page.keyboard.down('s');
    await until('W, A, S and D walk', async () => Math.hypot(...(await camera()).map((v, i) => v - before[i])) > 0.15);
    await page.keyboard.up('s');
    await shot(page, 'walk');

    // A film: its path on the plan, a key that is moved, what the camera sees, and the film itself.
    await page.click('#tab-film');
    await page.waitForSelector('.film-picture img');
    const keys = await page.locator('.film-key').count();
    expect(keys >= 2 && keys <= 40, `a tour of ${keys} keys`);
    const seen = () => page.locator('.film-picture img').getAttribute('src');
    const first = await seen();
    await page.locator('.film-key circle').nth(1).focus();
    await until('what the camera sees from another key', async () => (await seen()) !== first);
    const line = () => page.locator('.film-line').first().getAttribute('d');
    const drawn = await line();
    await page.keyboard.press('ArrowUp');
    await until('a key that is moved moves the path', async () => (await line()) !== drawn);
    await usable(page, 'film');
    await legible(page, 'film');
    await shot(page, 'film');
    await page.getByLabel('Length (s)').fill('1');
    await page.getByLabel('Length (s)').press('Tab');
    await until('a shorter film', async () => /\/ 1\.0 s/.test(await page.locator('.film-clock').innerText()));
    await page.getByText('.webm', { exact: true }).click();
    await until('the film is made', async () => (await page.locator('video.film-made').count()) > 0, 120);
    const length = () => page.evaluate(() => document.querySelector('video.film-made').duration);
    await until('the film can be played', async () => (await length()) > 0);
    const length_s = await length();
    expect(Math.abs(length_s - 1) < 0.1, `the film takes ${length_s} s`);

    await page.click('#tab-panorama');
    await page.waitForSelector('canvas[data-ready]');
    await page.focus('canvas');
    await page.keyboard.press('ArrowRight');
    await shot(page, 'panorama');

    // Changing: a color; then a second window that does not know of it.
    await page.click('#tab-change');
    await page.waitForSelector('.editor svg.plan');
    const other = await open();
    await other.goto(page.url());
    await other.waitForSelector('.editor svg.plan');
    await page.selectOption('.thing-choice select', 'armchair-1');
    await page.click('.colors .swatch[title=blue]');
    await until('the armchair is blue', async () =>
        (await page.locator('.change-list').innerText()).includes('armchair-1 color: blue'),
    );
    await other.selectOption('.thing-choice select', 'armchair-1');
    await other.click('.colors .swatch[title=green]');
    await until(
        'two windows: the second one is told',
        async () =>
            (await other.locator('.notices').innerText()).includes('another window') &&
            (await other.locator('.change-list').innerText()).includes('color: blue'),
    );
    await other.context().close();
    const thing = page.locator('.plan-thing[aria-label="armchair 1"]');
    await thing.focus();
    await page.keyboard.press('Delete');
    await until(
        'Delete removes it',
        async () => (await page.locator('.change-list li').count()) >= 2 && (await thing.count()) === 0,
    );
    await page.click('.inspector button:has-text("Undo")');
    await until('undo', async () => (await page.locator('.change-list li').count()) === 1);
    await usable(page, 'change');
    await legible(page, 'change');
    await shot(page, 'change');

    // Made anew, through the studio's violent death.
    await page.click('.inspector .primary');
    await until('it is made anew', async () => (await page.locator('.job.is-running').count()) > 0);
    const port = new URL(address).port;
    await end('SIGKILL');
    address = await start(port);
    await page.goto(address);
    await until(
        'it goes on after the studio was killed',
        async () => (await page.locator('.job.is-finished').count()) > 0,
        120,
    );
    await page.click('.job.is-finished .primary');
    await page.click('#tab-panorama');
    await page.waitForSelector('.split-range');
    await page.waitForSelector('canvas[data-ready]');
    await shot(page, 'compare');
    await page.click('#tab-files');
    const [saved] = await Promise.all([
        page.waitForEvent('download'),
        page.click('button[aria-label="Download: plan.svg"]'),
    ]);
    expect(/plan\.svg$/.test(saved.suggestedFilename()), `a file is made on demand: ${saved.suggestedFilename()}`);
    expect(
        (await page.locator('.command code').first().innerText()).startsWith('fastscene make --room'),
        'the command line is shown',
    );

    // The gallery.
    await page.goto(`${address}gallery`);
    await page.waitForSelector('.card');
    await page.fill('.search', 'blue');
    await until('search finds changes', async () => (await page.locator('.card').count()) === 1);
    await page.fill('.search', '');
    await page.locator('.card').first().locator('button:has-text("Delete")').click();
    await until('deleted', async () => (await page.locator('.card').count()) === 1);
    await page.click('.notice button:has-text("Undo")');
    await until('and brought back', async () => (await page.locator('.card').count()) === 2);
    expect(
        page.said.filter(
            (text) => !/WebGPU|No available adapters|setPointerCapture|ERR_(CONNECTION|INCOMPLETE|EMPTY|SOCKET)/.test(text),
        ).length === 0,
        `no error in the console ${page.said}`,
    );

    // Markup is text; what is not there is said; a browser without WebGL sees a picture; a phone in the dark.
    const dark = await open({
        colorScheme: 'dark',
        viewport: { width: 390, height: 844 },
        hasTouch: true,
        isMobile: true,
        locale: 'de-DE',
    });
    await dark.addInitScript(() => {
        const usual = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
            return /webgl/.test(kind) ? null : usual.call(this, kind, ...more);
        };
    });
    await dark.goto(address);
    await dark.fill('textarea', '<img src=x onerror=alert(1)> bedroom');
    await dark.waitForSelector('svg.plan');
    expect((await dark.locator('.sentence-marks').innerText()).includes('<img src=x'), 'markup is shown as text');
    await usable(dark, 'phone');
    await legible(dark, 'phone, dark');
    await shot(dark, 'phone');
    await dark.goto(`${address}scene/nowhere`);
    await until('an unknown scene is said', async () =>
        (await dark.locator('h1').innerText()).includes('gibt es nicht'),
    );
    await dark.goto(`${address}gallery`);
    await dark.locator('.card a').first().click();
    await until(
        'without WebGL: a picture',
        async () =>
            (await dark.locator('.stage img').count()) === 1 &&
            (await dark.locator('.stage-message').innerText()).includes('WebGL'),
    );
    await shot(dark, 'no_webgl');
} finally {
    await browser.close();
    await end('SIGTERM');
}
process.exit(failed ? 1 : 0);
