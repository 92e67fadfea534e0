// Benchmarks: start one, watch it, read its table.
import { isAbort } from "../api/errors.ts";
import { followJob } from "../api/events.ts";
import { cancelJob, getKinds, getResult, listJobs, listScenes, submitJob } from "../api/resources.ts";
import type { BenchmarkSpec, Job } from "../api/types.ts";
import type { OpenPage, Page } from "../app/page.ts";
import { replaceAddress } from "../app/router.ts";
import { type BenchForm, benchForm } from "../bench/form.ts";
import { hasEnded, JobView, stateText, titleOf } from "../bench/jobView.ts";
import { accuracyView, benchmarkView, type ResultView } from "../bench/resultView.ts";
import { fill, h, put } from "../ui/dom.ts";
import { dismiss, noticeOf } from "../ui/notice.ts";

const REFRESH_MS = 3000;
const FOLLOW_AGAIN_MS = 1000;

/** A key of its own for each press of the button: the daemon takes a repeated request for the same job. */
function newKey(): string {
  const numbers = crypto.getRandomValues(new Uint32Array(4));
  return `web-${[...numbers].map((number) => number.toString(16).padStart(8, "0")).join("")}`;
}

class Benchmarks implements Page {
  private readonly left = h("div", { class: "left" });
  private readonly list = h("ul", { class: "jobs" });
  private readonly view = new JobView(() => void this.cancel());
  private readonly empty = h("p", { class: "hint" }, "Start a benchmark, or choose one of those before.");
  private form: BenchForm | null = null;
  private jobs: Job[] = [];
  private chosen: string;
  private result: ResultView | null = null;
  private resultOf = "";
  private following = new AbortController();
  private readonly timer: ReturnType<typeof setInterval>;

  constructor(root: HTMLElement, parameters: URLSearchParams) {
    this.chosen = parameters.get("job") ?? "";
    const right = h("div", { class: "right" }, this.view.element, this.empty);
    put(root, [h("h1", { class: "hidden" }, "Benchmarks"), this.left, right]);
    this.timer = setInterval(() => void this.refresh(), REFRESH_MS);
    void this.start();
  }

  readdress(parameters: URLSearchParams): void {
    const job = parameters.get("job");
    if (job !== null) this.choose(job);
  }

  recover(): void {
    dismiss("bench");
    if (this.form === null) void this.start();
    else void this.refresh().then(() => this.choose(this.chosen));
  }

  close(): void {
    clearInterval(this.timer);
    this.following.abort();
    this.result?.close();
    dismiss("bench");
  }

  private async start(): Promise<void> {
    try {
      const [kinds, scenes] = await Promise.all([getKinds(), listScenes()]);
      this.form = benchForm(scenes, kinds, (spec) => void this.submit(spec));
      const before = h("section", { class: "card", "aria-label": "Jobs" }, h("h2", {}, "Jobs"), this.list);
      fill(this.left, this.form.element, before);
    } catch (error) {
      noticeOf("bench", error, { label: "Try again", run: () => void this.start() });
      return;
    }
    await this.refresh();
    if (this.chosen !== "") this.choose(this.chosen);
  }

  private async refresh(): Promise<void> {
    if (document.visibilityState === "hidden" || this.form === null) return;
    try {
      this.jobs = await listJobs();
      this.showList();
    } catch (error) {
      noticeOf("bench", error);
    }
  }

  private showList(): void {
    const row = (job: Job) =>
      h(
        "li",
        {},
        h(
          "button",
          {
            type: "button",
            "aria-current": job.id === this.chosen ? "true" : null,
            onclick: () => this.choose(job.id),
          },
          h("span", { class: "scene-name" }, titleOf(job)),
          h("span", { class: "scene-facts" }, `${stateText(job)} · ${job.created_at.replace("T", " ").slice(0, 16)}`),
        ),
      );
    const focused = document.activeElement instanceof HTMLElement && this.list.contains(document.activeElement);
    const at = focused
      ? [...this.list.querySelectorAll("button")].indexOf(document.activeElement as HTMLButtonElement)
      : -1;
    fill(this.list, ...this.jobs.map(row), this.jobs.length === 0 && h("li", { class: "hint" }, "None yet."));
    if (at >= 0) this.list.querySelectorAll("button")[at]?.focus();
  }

  private async submit(spec: BenchmarkSpec): Promise<void> {
    this.form?.lock(true);
    try {
      const job = await submitJob({ kind: "benchmark", spec }, newKey());
      dismiss("bench");
      this.jobs = [job, ...this.jobs];
      this.choose(job.id);
    } catch (error) {
      noticeOf("bench", error);
    }
    this.form?.lock(false);
  }

  private async cancel(): Promise<void> {
    try {
      this.showJob(await cancelJob(this.chosen));
    } catch (error) {
      noticeOf("bench", error);
    }
  }

  /** Follows a job to its end. */
  private choose(id: string): void {
    if (id !== this.chosen) this.view.hide();
    this.chosen = id;
    dismiss("bench");
    this.following.abort();
    this.following = new AbortController();
    replaceAddress("benchmarks", id === "" ? {} : { job: id });
    this.showList();
    if (id === "") return;
    const { signal } = this.following;
    this.follow(id, signal).catch((error: unknown) => {
      if (!isAbort(error)) noticeOf("bench", error);
    });
  }

  /** A stream may end before its job, as when the daemon stops in good order. */
  private async follow(id: string, signal: AbortSignal): Promise<void> {
    let isOver = false;
    while (!isOver && !signal.aborted) {
      await followJob(
        id,
        (job) => {
          isOver = hasEnded(job);
          this.showJob(job);
        },
        signal,
      );
      if (!isOver) await new Promise((done) => setTimeout(done, FOLLOW_AGAIN_MS));
    }
  }

  private showJob(job: Job): void {
    if (job.id !== this.chosen) return;
    const before = this.jobs.find((one) => one.id === job.id);
    if (before !== undefined && hasEnded(before) && !hasEnded(job)) return; // an answer that was overtaken
    this.jobs = this.jobs.map((one) => (one.id === job.id ? job : one));
    if (before?.state !== job.state) this.showList(); // else it follows by itself
    this.view.show(job);
    this.empty.remove();
    if (this.resultOf !== job.id) {
      this.result?.close();
      this.result = null;
      this.resultOf = "";
      this.view.content(null);
    }
    if (job.state === "succeeded" && this.resultOf !== job.id) void this.showResult(job);
    if (hasEnded(job)) void this.refresh();
  }

  private async showResult(job: Job): Promise<void> {
    this.resultOf = job.id;
    try {
      const result = await getResult(job.result ?? job.id);
      if (this.chosen !== job.id) return;
      this.result = "cases" in result ? accuracyView(job.id, result) : benchmarkView(job.id, result);
      this.view.content(this.result.element);
    } catch (error) {
      this.resultOf = "";
      noticeOf("bench", error);
    }
  }
}

export const openBenchmarks: OpenPage = (root, parameters) => new Benchmarks(root, parameters);
