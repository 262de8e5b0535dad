// The selected key of the path.
import type { CameraKey, Film } from '../api';
import { t } from '../text';
import { Amount } from './amount';
import { round } from './camera_path';

export const KeyPanel = ({
    film,
    index,
    change,
    onRemove,
}: {
    film: Film;
    index: number;
    change: (key: Partial<CameraKey>) => void;
    onRemove: () => void;
}) => {
    const key = film.path.keys[index];
    const [x, y, z] = key.position_m;
    return (
        <section>
            <div class="row">
                <h2 class="small-title grow">
                    {t.film_key} {index + 1} / {film.path.keys.length}
                </h2>
                <button class="quiet" disabled={film.path.keys.length < 2} onClick={onRemove}>
                    {t.remove}
                </button>
            </div>
            <div class="fields two">
                <Amount
                    label={`${t.film_time} (s)`}
                    value={round(key.time_s, 2)}
                    step={0.1}
                    low={0}
                    high={3600}
                    onSet={(time_s) => change({ time_s })}
                />
                <Amount
                    label={`${t.film_height} (m)`}
                    value={round(film.floor_y - y, 2)}
                    step={0.05}
                    low={0.05}
                    high={20}
                    onSet={(high) => change({ position_m: [x, film.floor_y - high, z] })}
                />
                <Amount
                    label={`${t.film_yaw} (°)`}
                    value={round(key.yaw_deg, 1)}
                    step={5}
                    low={-3600}
                    high={3600}
                    onSet={(yaw_deg) => change({ yaw_deg })}
                />
                <Amount
                    label={`${t.film_pitch} (°)`}
                    value={round(key.pitch_deg, 1)}
                    step={5}
                    low={-89}
                    high={89}
                    onSet={(pitch_deg) => change({ pitch_deg })}
                />
            </div>
            <p class="hint">{t.film_keys_help}</p>
        </section>
    );
};
