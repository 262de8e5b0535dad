// Looks around in an equirectangular picture; with a second one beside it, both in the same view (before and after).
import { useEffect, useRef, useState } from 'preact/hooks';
import { fail } from './store';
import { t } from './text';

const vertex = `#version 300 es
void main() { gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 0, 1); }`;
// Longitude 0 is the middle of the picture. The derivative of the column jumps at the seam: level 0 is sampled there.
const fragment = `#version 300 es
precision highp float;
uniform sampler2D after, before;
uniform vec2 size; uniform vec3 view; uniform float split;
out vec4 color;
void main() {
    vec2 p = (gl_FragCoord.xy - 0.5 * size) / (0.5 * size.y) * tan(0.5 * view.z);
    float cp = cos(view.y), sp = sin(view.y);
    vec3 ray = vec3(p.x, cp * p.y + sp, cp - sp * p.y);
    float lon = atan(ray.x, ray.z) + view.x, lat = atan(ray.y, length(ray.xz));
    vec2 uv = vec2(fract(lon / 6.28318530718 + 0.5), 0.5 - lat / 3.14159265359);
    float x = gl_FragCoord.x - split * size.x;
    color = x < 0.0 ? textureLod(before, uv, 0.0) : textureLod(after, uv, 0.0);
}`;

export const hasWebGL = () => {
    try {
        const context = document.createElement('canvas').getContext('webgl2');
        context?.getExtension('WEBGL_lose_context')?.loseContext();
        return context !== null;
    } catch {
        return false;
    }
};

const compiled = (gl: WebGL2RenderingContext) => {
    const program = gl.createProgram()!;
    for (const [kind, text] of [
        [gl.VERTEX_SHADER, vertex],
        [gl.FRAGMENT_SHADER, fragment],
    ] as const) {
        const shader = gl.createShader(kind)!;
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader) ?? 'shader');
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    return program;
};

const load = async (gl: WebGL2RenderingContext, unit: number, url: string) => {
    const image = new Image();
    image.src = url;
    await image.decode();
    const most = gl.getParameter(gl.MAX_TEXTURE_SIZE) as number;
    const source =
        image.width > most ? await createImageBitmap(image, { resizeWidth: most, resizeHeight: most / 2 }) : image;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, source);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.REPEAT);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
};

const clamp = (x: number, low: number, high: number) => Math.min(high, Math.max(low, x));

export const Panorama = ({
    url,
    before,
    label,
    yaw = 0,
}: {
    url: string;
    before?: string;
    label: string;
    yaw?: number;
}) => {
    const canvas = useRef<HTMLCanvasElement>(null),
        frame = useRef<HTMLDivElement>(null);
    const view = useRef({ yaw, pitch: -0.12, fov: 1.35, split: 0 });
    const draw = useRef(() => {});
    const [split, setSplit] = useState(before ? 0.5 : 0);
    const [compare, setCompare] = useState(Boolean(before));
    view.current.split = before && compare ? split : 0;

    useEffect(() => {
        const element = canvas.current!;
        const gl = element.getContext('webgl2', { antialias: false, alpha: false });
        if (!gl) return;
        let asked = 0;
        const program = compiled(gl),
            at = (name: string) => gl.getUniformLocation(program, name);
        const [size, look, cut] = [at('size'), at('view'), at('split')];
        gl.uniform1i(at('after'), 0);
        gl.uniform1i(at('before'), 1);
        draw.current = () => {
            cancelAnimationFrame(asked);
            asked = requestAnimationFrame(() => {
                const scale = Math.min(devicePixelRatio, 2),
                    w = Math.round(element.clientWidth * scale),
                    h = Math.round(element.clientHeight * scale);
                if (element.width !== w || element.height !== h) {
                    element.width = w;
                    element.height = h;
                }
                gl.viewport(0, 0, w, h);
                gl.uniform2f(size, w, h);
                gl.uniform3f(look, view.current.yaw, view.current.pitch, view.current.fov);
                gl.uniform1f(cut, view.current.split);
                gl.drawArrays(gl.TRIANGLES, 0, 3);
            });
        };
        const ready = () => {
            element.dataset.ready = 'true';
            draw.current();
        };
        Promise.all([load(gl, 0, url), before ? load(gl, 1, before) : null])
            .then(ready)
            .catch(fail);
        const watch = new ResizeObserver(() => draw.current());
        watch.observe(element);
        return () => {
            watch.disconnect();
            cancelAnimationFrame(asked);
            gl.getExtension('WEBGL_lose_context')?.loseContext();
        };
    }, [url, before]);
    useEffect(() => draw.current(), [split, compare]);

    const turn = (yaw: number, pitch: number, zoom = 1) => {
        const v = view.current;
        v.yaw += yaw;
        v.pitch = clamp(v.pitch + pitch, -1.5, 1.5);
        v.fov = clamp(v.fov * zoom, 0.35, 2);
        draw.current();
    };
    const pointers = useRef(new Map<number, { x: number; y: number }>());
    const moved = (event: PointerEvent) => {
        const last = pointers.current.get(event.pointerId);
        if (!last) return;
        const perPixel = view.current.fov / canvas.current!.clientHeight;
        const others = [...pointers.current.entries()].filter(([id]) => id !== event.pointerId).map(([, p]) => p);
        if (others.length) {
            const far = (p: { x: number; y: number }) => Math.hypot(p.x - others[0].x, p.y - others[0].y);
            turn(0, 0, far(last) / Math.max(1, far({ x: event.clientX, y: event.clientY })));
        } else {
            turn((last.x - event.clientX) * perPixel, (event.clientY - last.y) * perPixel);
        }
        pointers.current.set(event.pointerId, { x: event.clientX, y: event.clientY });
    };
    const key = (event: KeyboardEvent) => {
        const by: Record<string, [number, number, number]> = {
            ArrowLeft: [-0.12, 0, 1],
            ArrowRight: [0.12, 0, 1],
            ArrowUp: [0, 0.1, 1],
            ArrowDown: [0, -0.1, 1],
            '+': [0, 0, 0.88],
            '=': [0, 0, 0.88],
            '-': [0, 0, 1.14],
        };
        if (!by[event.key]) return;
        turn(...by[event.key]);
        event.preventDefault();
    };
    return (
        <div class="stage" ref={frame}>
            <canvas
                ref={canvas}
                tabIndex={0}
                role="img"
                aria-label={`${label}. ${t.panorama_help}`}
                onKeyDown={key}
                onPointerDown={(e) => {
                    canvas.current!.setPointerCapture(e.pointerId);
                    pointers.current.set(e.pointerId, { x: e.clientX, y: e.clientY });
                }}
                onPointerMove={moved}
                onPointerUp={(e) => pointers.current.delete(e.pointerId)}
                onPointerCancel={(e) => pointers.current.delete(e.pointerId)}
                onWheel={(e) => {
                    e.preventDefault();
                    turn(0, 0, Math.exp(e.deltaY * 0.0012));
                }}
            />
            {before && compare && (
                <>
                    <div class="split" style={{ left: `${split * 100}%` }} aria-hidden="true">
                        <span>{t.before}</span>
                        <span>{t.after}</span>
                    </div>
                    <input
                        class="split-range"
                        type="range"
                        min="0"
                        max="1"
                        step="0.005"
                        value={split}
                        aria-label={t.compare}
                        onInput={(e) => setSplit(Number(e.currentTarget.value))}
                    />
                </>
            )}
            <div class="stage-tools">
                {before && (
                    <button class="chip" aria-pressed={compare} onClick={() => setCompare(!compare)}>
                        {t.compare}
                    </button>
                )}
                <button class="chip" onClick={() => frame.current!.requestFullscreen().catch(fail)}>
                    {t.full}
                </button>
            </div>
        </div>
    );
};
