// The list of scenes with a picture of each.
import type { Scene } from "../api/types.ts";
import { fill, h } from "./dom.ts";
import { roughly } from "./format.ts";

/** Of the catalogue's scenes, by file. */
const CATALOGUE = import.meta.glob<string>("../thumbnails/*.webp", { eager: true, query: "?url", import: "default" });
const pictures = new Map<string, string>(); // of scenes that were shown here, by name and hash

/** Keeps a small picture of what a canvas shows, for a scene without one of its own. */
export function keepPicture(scene: Scene, canvas: HTMLCanvasElement): void {
  const key = `${scene.name} ${scene.hash}`;
  if (scene.fidelity !== "uploaded" || pictures.has(key)) return;
  const small = h("canvas", { width: 96, height: 72 });
  const height = Math.min(canvas.height, canvas.width * 0.75);
  small.getContext("2d")?.drawImage(canvas, 0, (canvas.height - height) / 2, canvas.width, height, 0, 0, 96, 72);
  small.toBlob((blob) => blob && pictures.set(key, URL.createObjectURL(blob)));
}

function picture(scene: Scene): HTMLElement {
  const source = pictures.get(`${scene.name} ${scene.hash}`) ?? CATALOGUE[`../thumbnails/${scene.name}.webp`];
  if (source === undefined) return h("span", { class: "no-picture", "aria-hidden": "true" }, scene.name.slice(0, 1));
  return h("img", { src: source, alt: "", width: 56, height: 42, loading: "lazy", decoding: "async" });
}

export interface ScenePicker {
  element: HTMLElement;
  show(scenes: Scene[], chosen: string): void;
}

export function scenePicker(choose: (name: string) => void): ScenePicker {
  const list = h("ul", {});
  const element = h("nav", { class: "scenes", "aria-label": "Scenes" }, list);
  const row = (scene: Scene, chosen: boolean) =>
    h(
      "li",
      {},
      h(
        "button",
        {
          type: "button",
          "aria-current": chosen ? "true" : null,
          disabled: scene.available === false && !scene.loaded,
          title: scene.description ?? scene.title,
          onclick: () => choose(scene.name),
        },
        picture(scene),
        h(
          "span",
          { class: "scene-text" },
          h("span", { class: "scene-name" }, scene.name),
          h("span", { class: "scene-facts" }, `${roughly(scene.triangles)} tri · ${scene.fidelity}`),
        ),
        scene.loaded && h("span", { class: "dot", title: "resident" }, h("span", { class: "hidden" }, "resident")),
      ),
    );
  let shown = "";
  return {
    element,
    show: (scenes, chosen) => {
      fill(list, ...scenes.map((scene) => row(scene, scene.name === chosen)));
      const current = list.querySelector("[aria-current]");
      if (chosen !== shown && current !== null) {
        current.scrollIntoView({ block: "nearest", inline: "nearest" });
        shown = chosen;
      }
    },
  };
}
