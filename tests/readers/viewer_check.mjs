// Opens viewer.html from disk in Chromium and looks: red wall left, green right, blue ahead, white above, brown below.
//   node viewer_check.mjs WEB_DIR VIEWER_HTML SCREENSHOT_PNG
import { pathToFileURL } from 'node:url';
import path from 'node:path';
import { openChromium } from './open_chromium.mjs';

const [web, html, png] = process.argv.slice(2);
const browser = await openChromium(web);
let failed = false;
const expect = (ok, text) => {
    if (!ok) failed = true;
    console.log(`viewer: ${ok ? 'ok' : 'FAILED'}: ${text}`);
};
try {
    const page = await browser.newPage({ viewport: { width: 720, height: 450 } });
    const outside = [];
    page.on('request', (r) => { if (!/^(file|data|blob):/.test(r.url())) outside.push(r.url()); });
    await page.goto(pathToFileURL(path.resolve(html)).href);

    // Mean color of a part of the screenshot (fractions of its sides); decoded by the browser itself.
    const means = async (parts) => {
        const shot = await page.screenshot({ path: png });
        const other = await browser.newPage();
        const out = await other.evaluate(async ({ data, parts }) => {
            const image = new Image();
            image.src = `data:image/png;base64,${data}`;
            await image.decode();
            const canvas = document.createElement('canvas');
            canvas.width = image.width;
            canvas.height = image.height;
            const context = canvas.getContext('2d');
            context.drawImage(image, 0, 0);
            return parts.map(([x0, y0, x1, y1]) => {
                const w = image.width, h = image.height;
                const d = context.getImageData(x0 * w, y0 * h, (x1 - x0) * w, (y1 - y0) * h).data;
                const sum = [0, 0, 0];
                for (let i = 0; i < d.length; i += 4) for (let c = 0; c < 3; ++c) sum[c] += d[i + c];
                return sum.map((s) => Math.round((4 * s) / d.length));
            });
        }, { data: shot.toString('base64'), parts });
        await other.close();
        return out;
    };
    // Left, right, ahead, above, below; clear of the edges between walls and of the viewer's panels.
    const parts = [[0.01, 0.25, 0.09, 0.38], [0.91, 0.25, 0.99, 0.38], [0.4, 0.4, 0.6, 0.6], [0.4, 0.02, 0.6, 0.12], [0.4, 0.815, 0.6, 0.845]];
    let colors = [];
    // Until the splats are there, the page is white. A busy machine takes its time.
    const seen = () => colors.length > 0 && colors[2][2] > 80 && colors[2][2] > 1.8 * colors[2][0];
    for (let i = 0; i < 80 && !seen(); ++i) {
        await page.waitForTimeout(1500);
        colors = await means(parts);
    }
    const [left, right, center, top, bottom] = colors;
    expect(outside.length === 0, `no request leaves the file (${outside.join(' ') || 'none'})`);
    expect(left[0] > 1.8 * left[1] && left[0] > 1.8 * left[2], `red on the left: ${left}`);
    expect(right[1] > 1.8 * right[0] && right[1] > 1.8 * right[2], `green on the right: ${right}`);
    expect(center[2] > 1.8 * center[0] && center[2] > 1.8 * center[1], `blue ahead: ${center}`);
    expect(Math.min(...top) > 150, `white above: ${top}`);
    expect(bottom[0] > 1.3 * bottom[1] && bottom[1] > 1.2 * bottom[2], `brown below: ${bottom}`);
} finally {
    await browser.close();
}
process.exit(failed ? 1 : 0);
