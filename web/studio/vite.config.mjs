// The studio's pages, built into one folder that the program serves: vite build --outDir DIR
import { readFileSync } from 'node:fs';
import { defineConfig } from 'vite';

const packages = ['preact', '@fontsource-variable/inter', '@fontsource-variable/newsreader'];
// What is bundled is named with its licence.
const licenses = {
    name: 'licenses',
    generateBundle() {
        const texts = packages.map((name) => {
            const text = readFileSync(new URL(`../node_modules/${name}/LICENSE`, import.meta.url), 'utf8');
            return `${name}\n\n${text.trim()}\n`;
        });
        this.emitFile({ type: 'asset', fileName: 'licenses.txt', source: texts.join(`\n${'-'.repeat(80)}\n\n`) });
    },
};

export default defineConfig({
    root: new URL('.', import.meta.url).pathname,
    esbuild: { jsx: 'automatic', jsxImportSource: 'preact' },
    plugins: [licenses],
    build: { target: 'es2022', assetsInlineLimit: 0, modulePreload: { polyfill: false }, emptyOutDir: true },
});
