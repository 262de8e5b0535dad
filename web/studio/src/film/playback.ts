// What the camera sees at a time of the film, at rest or playing.
import { useEffect, useRef, useState } from 'preact/hooks';
import { part, post } from '../api';
import { fail } from '../store';

const frame_px = 640;

// One request at a time: for the newest frame that is wanted. `version` changes with the path.
const useFrame = (scene: string, time_s: number, version: number) => {
    const [picture, setPicture] = useState(''),
        [shown_s, setShown] = useState(-1);
    const wanted = useRef({ time_s, version }),
        busy = useRef(false);
    wanted.current = { time_s, version };
    const fetchNext = async () => {
        if (busy.current) return;
        busy.current = true;
        const now = wanted.current;
        try {
            const { jpeg } = await post<{ jpeg: string }>(`scenes/${part(scene)}/film/frame`, {
                time_s: now.time_s,
                width: frame_px,
            });
            setPicture(`data:image/jpeg;base64,${jpeg}`);
            setShown(now.time_s);
        } catch (error) {
            fail(error);
            busy.current = false;
            return;
        }
        busy.current = false;
        if (wanted.current.time_s !== now.time_s || wanted.current.version !== now.version) fetchNext();
    };
    useEffect(() => {
        fetchNext();
    }, [scene, time_s, version]);
    return { picture, shown_s };
};

export const usePlayback = (scene: string, end_s: number, version: number) => {
    const [asked_s, setTime] = useState(0),
        [playing, setPlaying] = useState(false);
    const time_s = Math.min(asked_s, end_s); // the path may have become shorter
    const { picture, shown_s } = useFrame(scene, time_s, version);
    // Plays in time, with as many frames as there are.
    const begun = useRef(0);
    useEffect(() => {
        if (!playing) return;
        const now = (performance.now() - begun.current) / 1000;
        if (now >= end_s) {
            setTime(end_s);
            setPlaying(false);
        } else setTime(now);
    }, [playing, shown_s]);
    const seek = (to_s: number) => {
        setPlaying(false);
        setTime(to_s);
    };
    const toggle = () => {
        const from = time_s >= end_s - 0.05 ? 0 : time_s;
        begun.current = performance.now() - 1000 * from;
        if (!playing) setTime(from);
        setPlaying(!playing);
    };
    return { time_s, picture, playing, seek, toggle };
};
