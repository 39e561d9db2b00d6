"use strict";

/* Pictures and films of what is seen, labels included, as files that the browser saves. */
const Records = (() => {
  const TYPES = ["video/mp4;codecs=avc1.42E01E", "video/mp4", "video/webm;codecs=vp9", "video/webm"], RATE = 30;

  /* The picture and its labels on one canvas. */
  function compose(stage, target = document.createElement("canvas")) {
    const source = stage.renderer.domElement, scale = source.width / stage.width, pen = target.getContext("2d");
    if (target.width !== source.width || target.height !== source.height) {
      Object.assign(target, { width: source.width, height: source.height });
    }
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.drawImage(source, 0, 0);
    pen.setTransform(scale, 0, 0, scale, 0, 0);
    const frame = stage.holder.getBoundingClientRect();
    stage.holder.querySelectorAll(".label:not([hidden])").forEach((label) => {
      const box = label.getBoundingClientRect(), look = getComputedStyle(label), x = box.left - frame.left, y = box.top - frame.top;
      pen.fillStyle = look.backgroundColor;
      pen.fillRect(x, y, box.width, box.height);
      pen.strokeStyle = look.borderTopColor;
      pen.lineWidth = 1;
      pen.strokeRect(x + 0.5, y + 0.5, box.width - 1, box.height - 1);
      pen.fillStyle = look.color;
      pen.font = `${look.fontStyle} ${look.fontSize} ${look.fontFamily}`;
      pen.textBaseline = "middle";
      pen.fillText(label.textContent, x + 5, y + box.height / 2 + 0.5);
    });
    return target;
  }

  function save(blob, name) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  }

  function picture(stage, name) {
    stage.render();
    compose(stage).toBlob((blob) => save(blob, `${name}.png`), "image/png");
  }

  /* A film that takes what is drawn until `stop`; null where the browser makes none. */
  function film(stage, name) {
    const type = globalThis.MediaRecorder && TYPES.find((kind) => MediaRecorder.isTypeSupported(kind));
    if (!type) {
      return null;
    }
    const target = compose(stage), recorder = new MediaRecorder(target.captureStream(RATE), { mimeType: type, videoBitsPerSecond: 8e6 }), parts = [];
    recorder.ondataavailable = ({ data }) => parts.push(data);
    recorder.onstop = () => save(new Blob(parts, { type }), `${name}.${type.startsWith("video/mp4") ? "mp4" : "webm"}`);
    recorder.start();
    return { take: () => compose(stage, target), stop: () => recorder.stop() };
  }

  return { compose, picture, film };
})();
