// The wheel scrolls the page. Over a focused picture, or with Ctrl, it zooms the picture.
export const isZooming = (event, picture) => event.ctrlKey || event.metaKey || document.activeElement === picture;

// Hides the wheel from a picture's own zoom when it belongs to the page; `zoom` is used if nothing else zooms.
export function zoomByWheel(picture, zoom) {
    const onWheel = (event) => {
        if (!isZooming(event, picture)) return event.stopImmediatePropagation();
        if (!zoom) return;
        event.preventDefault();
        zoom(Math.min(1.4, Math.max(0.7, Math.exp(event.deltaY / 500))), event);
    };
    picture.addEventListener('wheel', onWheel, { passive: false, capture: true });
}
