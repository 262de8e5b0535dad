// Chromium without a graphics card and without a network.
import { createRequire } from 'node:module';
import path from 'node:path';

const flags = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync', '--use-gl=angle', '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];

export const openChromium = (web) => {
    const { chromium } = createRequire(path.resolve(web, 'package.json'))('playwright-core');
    return chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: flags });
};
