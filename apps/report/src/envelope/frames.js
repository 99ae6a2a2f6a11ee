// Decides when WebGL draws: only after a change; coarsely during motion, with four times the pixels at rest. If even
// that is slow, as without a graphics card, more coarsely. The canvas is `aria-busy` from a change to the picture at
// rest.

// `onCoarse(isCoarse)` is called before each picture; `step.now`, if set, before each picture during motion.
export function makeFrames(renderer, scene, camera, onCoarse) {
    const step = { now: null };
    let waiting = false,
        resting = 0,
        last = 0,
        coarse = 1,
        isMoving = false;
    const render = (share) => {
        isMoving = share < 2;
        onCoarse(isMoving);
        const ratio = Math.min(3, window.devicePixelRatio * share);
        if (renderer.getPixelRatio() !== ratio) renderer.setPixelRatio(ratio);
        renderer.render(scene, camera);
        renderer.domElement.ariaBusy = String(isMoving);
    };
    const draw = (now) => {
        waiting = false;
        if (now - last > 45 && now - last < 300) coarse = Math.max(0.5, coarse - 0.125);
        last = now;
        step.now?.();
        render(coarse);
        clearTimeout(resting);
        resting = setTimeout(() => render(2), 200);
    };
    const request = () => {
        if (!waiting) requestAnimationFrame(draw);
        waiting = true;
        renderer.domElement.ariaBusy = 'true';
    };
    // For changes without motion: switching to coarse pixels and back would take longer.
    const refresh = () => {
        if (isMoving) return request();
        renderer.domElement.ariaBusy = 'true';
        requestAnimationFrame(() => !waiting && !isMoving && render(2));
    };
    return { step, request, refresh, drawNow: () => render(2) };
}
