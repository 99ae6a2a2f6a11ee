// The chosen tile or seam, map and colours. Views subscribe to changes.
export function makeState(initial) {
    const listeners = [];
    let now = initial;
    return {
        get now() {
            return now;
        },
        listen(listener) {
            listeners.push(listener);
        },
        change(changes) {
            const before = now;
            now = { ...now, ...changes };
            for (const listener of listeners) listener(now, before);
        },
    };
}

export const isChosen = (state, kind, index) => state.chosen?.kind === kind && state.chosen.index === index;
