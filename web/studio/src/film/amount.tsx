// A number with its label. What is typed out of range becomes the nearest value in it.
export const Amount = ({
    label,
    value,
    step,
    low,
    high,
    onSet,
}: {
    label: string;
    value: number;
    step: number;
    low: number;
    high: number;
    onSet: (value: number) => void;
}) => (
    <label>
        {label}
        <input
            type="number"
            value={value}
            step={step}
            min={low}
            max={high}
            onChange={(e) => {
                const next = Number(e.currentTarget.value);
                if (e.currentTarget.value !== '' && Number.isFinite(next)) onSet(Math.min(high, Math.max(low, next)));
            }}
        />
    </label>
);
