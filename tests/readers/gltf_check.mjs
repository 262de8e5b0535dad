// Khronos' validator finds neither errors nor warnings: node gltf_check.mjs WEB_DIR FILE.glb…
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';

const [web, ...files] = process.argv.slice(2);
const { validateBytes, version } = createRequire(path.resolve(web, 'package.json'))('gltf-validator');
const kSerious = 1;  // severities: 0 error, 1 warning, 2 information, 3 hint
for (const file of files) {
    const { issues, info } = await validateBytes(new Uint8Array(fs.readFileSync(file)), { maxIssues: 0 });
    const serious = issues.messages.filter((m) => m.severity <= kSerious);
    if (issues.numErrors + issues.numWarnings > 0) {
        console.error(`${file}: ${issues.numErrors} errors, ${issues.numWarnings} warnings`);
        for (const m of serious.slice(0, 20)) console.error(`  ${m.code} ${m.pointer}: ${m.message}`);
        process.exit(1);
    }
    console.log(`gltf-validator ${version()}: ${path.basename(file)}: ${info.totalTriangleCount} triangles, ` +
        `${info.materialCount} materials, no error, no warning`);
}
