// The wheel scrolls the page. Over a picture that has the focus, or with Ctrl, it zooms that.
export const isZooming = (event, picture) => event.ctrlKey || event.metaKey || document.activeElement === picture;

// Keeps the wheel of a picture from those who would zoom with it when it is the page's; `zoom`, where nobody else does.
export function zoomByWheel(picture, zoom) {
    const onWheel = (event) => {
        if (!isZooming(event, picture)) return event.stopImmediatePropagation();
        if (!zoom) return;
        event.preventDefault();
        zoom(Math.min(1.4, Math.max(0.7, Math.exp(event.deltaY / 500))), event);
    };
    picture.addEventListener('wheel', onWheel, { passive: false, capture: true });
}
