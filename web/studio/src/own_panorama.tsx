// The visitor's own panorama, with its range map: dropped or chosen, looked at by the server, doubts beside it.
import { useState } from 'preact/hooks';
import { part, upload, type Upload } from './api';
import { fail, notify } from './store';
import { fill, t } from './text';

export const OwnPanorama = ({
    panorama,
    range,
    most,
    onPanorama,
    onRange,
}: {
    panorama: Upload | null;
    range: Upload | null;
    most: number;
    onPanorama: (u: Upload | null) => void;
    onRange: (u: Upload | null) => void;
}) => {
    const [over, setOver] = useState(false),
        [busy, setBusy] = useState('');
    const take = async (kind: 'panorama' | 'range', file?: File) => {
        if (!file) return;
        if (file.size > most) return notify(fill(t.too_large, file.name, most / 2 ** 20), { bad: true });
        setBusy(file.name);
        try {
            const got = await upload(kind, file);
            if (kind === 'panorama') onPanorama(got);
            else onRange(got);
        } catch (error) {
            fail(error);
        }
        setBusy('');
    };
    const input = (kind: 'panorama' | 'range', text: string) => (
        <label class="button file-button">
            {text}
            <input
                type="file"
                class="visually-hidden"
                accept={kind === 'range' ? '.exr,.pfm,.png,.tif,.tiff' : 'image/*,.hdr,.exr,.tif,.tiff'}
                onChange={(e) => {
                    take(kind, e.currentTarget.files?.[0]);
                    e.currentTarget.value = '';
                }}
            />
        </label>
    );
    return (
        <div
            class={`drop ${over ? 'is-over' : ''}`}
            onDragOver={(e) => {
                e.preventDefault();
                setOver(true);
            }}
            onDragLeave={() => setOver(false)}
            onDrop={(e) => {
                e.preventDefault();
                setOver(false);
                take('panorama', e.dataTransfer?.files[0]);
            }}
        >
            {!panorama && (
                <>
                    <p>{t.own_help}</p>
                    {input('panorama', t.choose)}
                </>
            )}
            {panorama && (
                <div class="dropped">
                    <img src={`/api/uploads/${part(panorama.id)}`} alt="" />
                    <div>
                        <strong>{panorama.name}</strong>
                        <br />
                        <small>
                            {panorama.width} × {panorama.height}
                        </small>
                        <ul class="warnings">
                            {panorama.warnings?.map((w) => (
                                <li key={w}>{w}</li>
                            ))}
                        </ul>
                        <div class="row">
                            {range ? (
                                <span class="chip">
                                    {range.name} · {range.width} × {range.height}
                                </span>
                            ) : (
                                input('range', t.range)
                            )}
                            <button
                                class="quiet"
                                onClick={() => {
                                    onPanorama(null);
                                    onRange(null);
                                }}
                            >
                                {t.remove_file}
                            </button>
                        </div>
                    </div>
                </div>
            )}
            {busy && <p role="status">{fill(t.checking, busy)}</p>}
        </div>
    );
};
