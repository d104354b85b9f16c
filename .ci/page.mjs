// Opens the page in a headless Chromium as a student would, and checks by its address and title what happens. Screenshots go to the
// second folder. Usage: node page.mjs SITE OUT SCENE.json
import { spawn } from "node:child_process";
import { mkdtemp, readdir, readFile, writeFile } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { basename, extname, join, resolve } from "node:path";

const [site, out, scene] = process.argv.slice(2);
const types = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm" };
const frame = `<iframe src="./?embed#lesson=shadows&step=4" style="width: 900px; height: 600px"></iframe>
<script>var heard = []; addEventListener("message", ({ data }) => heard.push(data));</script>`;
// In a subfolder, as on a course page.
const server = createServer(async (request, response) => {
  const path = new URL(request.url, "http://x").pathname.replace(/^\/course\//, "");
  try {
    const bytes = path === "frame.html" ? Buffer.from(frame) : await readFile(join(site, path === "" ? "index.html" : path));
    response.writeHead(200, { "Content-Type": types[extname(path || "index.html")] ?? "", "Content-Length": bytes.length });
    response.end(bytes);
  } catch {
    response.writeHead(404).end();
  }
});
await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
const home = `http://127.0.0.1:${server.address().port}/course/`;

const profile = await mkdtemp(join(tmpdir(), "page-"));
const chromium = spawn(process.env.CHROMIUM ?? "chromium", [
  "--headless", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync", "--enable-unsafe-swiftshader", "--lang=en-US",
  `--user-data-dir=${profile}`, "--remote-debugging-pipe", "about:blank",
], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });

// Messages end with a zero byte.
const waiting = new Map();
// The last event of each kind.
const heard = new Map();
const problems = [];
let [session, number, rest] = [undefined, 0, ""];
chromium.stdio[4].on("data", (data) => {
  const parts = (rest + data).split("\0");
  rest = parts.pop();
  for (const message of parts.map((part) => JSON.parse(part))) {
    const { id, result, error, method, params } = message;
    heard.set(method, params);
    if (method === "Runtime.consoleAPICalled" && params.type === "error") problems.push(params.args.map(({ value, description }) => value ?? description).join(" "));
    if (method === "Runtime.exceptionThrown") problems.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    const [done, failed] = waiting.get(id) ?? [];
    waiting.delete(id);
    if (error) failed?.(new Error(error.message));
    else done?.(result);
  }
});
function send(method, params = {}) {
  number += 1;
  chromium.stdio[3].write(JSON.stringify({ id: number, method, params, sessionId: session }) + "\0");
  return new Promise((done, failed) => waiting.set(number, [done, failed]));
}
const later = (milliseconds) => new Promise((then) => setTimeout(then, milliseconds));
async function evaluate(expression) {
  const { result, exceptionDetails } = await send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
  if (exceptionDetails) throw new Error(exceptionDetails.text);
  return result.value;
}
// However slow the machine is: what came in is drawn, and nothing moves any more.
async function still() {
  await evaluate("(async () => { for (let n = 0; n < 4; n++) await new Promise(requestAnimationFrame) })()");
  for (let [before, tries] = ["", 0]; tries < 30; tries++) {
    const { data } = await send("Page.captureScreenshot", { format: "jpeg" });
    if (data === before) return;
    before = data;
    await later(100);
  }
}
// Waits for a condition: an expression of the page, or a function.
async function until(condition, what) {
  const holds = typeof condition === "string" ? () => evaluate(condition) : condition;
  const end = Date.now() + 60000;
  while (Date.now() < end) {
    if (await holds()) return;
    await later(50);
  }
  await picture("page-failed");
  const trouble = await evaluate("document.getElementById('trouble')?.textContent ?? ''");
  throw new Error(`failed: ${what}. The address is ${await evaluate("location.href")}. ${trouble} ${problems.join("; ")}`);
}
async function press(key, code, modifiers = 0) {
  for (const type of ["keyDown", "keyUp"]) {
    await send("Input.dispatchKeyEvent", { type, key, code: key, windowsVirtualKeyCode: code, modifiers });
  }
}
const mouse = (type, [x, y]) =>
  send("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons: type === "mouseReleased" ? 0 : 1, clickCount: 1 });
// At once: what is held for 0.8 s is no click.
async function click(place) {
  await still();
  await mouse("mouseMoved", place);
  await still();
  await Promise.all([mouse("mousePressed", place), mouse("mouseReleased", place)]);
  await still();
}
async function drag(from, to) {
  for (const [type, place] of [["mouseMoved", from], ["mousePressed", from], ["mouseMoved", to], ["mouseReleased", to]]) {
    await mouse(type, place);
    await still();
  }
}
async function picture(name) {
  await still();
  const { data } = await send("Page.captureScreenshot");
  await writeFile(join(out, `${name}.png`), Buffer.from(data, "base64"));
}
async function open(hash) {
  await send("Page.navigate", { url: "about:blank" });
  const start = Date.now();
  await send("Page.navigate", { url: home + hash });
  const shown = "document.readyState === 'complete' && document.getElementById('lightwalk') && !document.getElementById('loading')";
  await until(`location.href !== 'about:blank' && Boolean(${shown})`, `${hash} opens`);
  return Date.now() - start;
}
const at = (part) => `location.hash.includes("${part}")`;

let failed = true;
try {
  const { targetInfos } = await send("Target.getTargets");
  const { targetId } = targetInfos.find(({ type }) => type === "page");
  session = (await send("Target.attachToTarget", { targetId, flatten: true })).sessionId;
  for (const domain of ["Runtime", "Page", "Network"]) await send(`${domain}.enable`);
  await send("Emulation.setDeviceMetricsOverride", { width: 1280, height: 720, deviceScaleFactor: 1, mobile: false });

  const first = await open("#lesson=shadows&step=12");
  await until(at("step=12"), "a link opens its step");
  await picture("page-link");
  await press("ArrowRight", 39);
  await until(at("step=13"), "an arrow goes one step on");
  await press("l", 76);
  await until(at("language=id"), "l changes the language");
  await picture("page-indonesian");
  await press("h", 72);
  await until("!" + at("lesson="), "h shows the list of lessons");
  await picture("page-lessons");
  await evaluate("history.back()");
  await until(at("lesson=shadows"), "back leads to the lesson");
  await evaluate("location.hash = '#lesson=gathering&step=3'");
  await until(at("lesson=gathering&step=3"), "another address is followed");
  await until("document.title.includes('langkah 3')", "the title names the step");
  await until("document.getElementById('step').textContent !== ''", "what is said is there for screen readers");

  // A question is answered, a slider is moved, and a handout comes.
  await open("#lesson=gouraud-triangle&step=0");
  await evaluate("window.said = []; window.shows = window.report; window.report = (text) => { said.push(JSON.parse(text)); shows(text); }");
  await press("End", 35);
  await until("said.at(-1)?.answers.includes('open')", "a question waits");
  await click([88, 328]);
  await until("said.at(-1).answers.includes('right')", "a click answers it");
  await picture("page-question");
  await click([1136, 615]);
  await drag([1130, 94], [1150, 94]);
  await until(at("change=0:"), "a slider changes a value");
  await send("Page.setDownloadBehavior", { behavior: "allow", downloadPath: resolve(out) });
  for (const place of [[1215, 20], [1085, 336], [814, 378]]) await click(place);
  await until(async () => (await readdir(out)).some((name) => name.endsWith("-handout-id.html")), "a handout comes");
  await picture("page-slider");

  // A scene from the user's own computer.
  const at_middle = { x: 640, y: 300, data: { items: [], files: [resolve(scene)], dragOperationsMask: 1 } };
  for (const type of ["dragEnter", "dragOver", "drop"]) await send("Input.dispatchDragEvent", { type, ...at_middle });
  await until(`document.title.includes("${basename(scene)}")`, "a scene that is dropped is walked through");
  await picture("page-scene");
  // The same by the browser's dialog.
  await open("#lesson=shadows&step=4");
  await send("Page.setInterceptFileChooserDialog", { enabled: true });
  await press("o", 79, 2);
  await until(() => heard.has("Page.fileChooserOpened"), "Ctrl+O asks for a file");
  const { backendNodeId } = heard.get("Page.fileChooserOpened");
  await send("DOM.setFileInputFiles", { files: [resolve(scene)], backendNodeId });
  await until(`document.title.includes("${basename(scene)}")`, "a scene that is chosen is walked through");
  await until(at("scene="), "the address holds a scene of one's own");
  await open(await evaluate("location.hash"));
  await until("document.title.includes('Adegan yang dibagikan')", "a link to a scene opens it");
  await evaluate("location.hash = '#lesson=shadows&change=0:1.5,4,2.5&step=3'");
  await until("document.title.includes('langkah 3')", "a link with a changed value is followed");
  await press("ArrowRight", 39);
  await until(at("change=0:1.5,4,2.5&step=4"), "a changed value stays in the address");

  // In a frame of another page, which steers it and hears of it.
  await send("Page.navigate", { url: `${home}frame.html` });
  await until("window.heard?.at(-1)?.address?.includes('step=4')", "a page with a frame hears where it is");
  await evaluate("document.querySelector('iframe').contentWindow.postMessage({ lightwalk: 'show', address: 'lesson=shadows&step=9' }, '*')");
  await until("window.heard?.at(-1)?.address?.includes('step=9')", "a page with a frame says where to go");
  await picture("page-frame");

  // What was seen is kept, and the page works without a network.
  await until("navigator.serviceWorker.ready.then(() => true)", "the page is kept for later");
  await send("Network.emulateNetworkConditions", { offline: true, latency: 0, downloadThroughput: 0, uploadThroughput: 0 });
  await open("#lesson=shadows&step=5");
  await until(at("step=5"), "it opens without a network");
  await send("Network.emulateNetworkConditions", { offline: false, latency: 0, downloadThroughput: -1, uploadThroughput: -1 });
  if (!(await evaluate("localStorage.getItem('lightwalk').includes('shadows')"))) throw new Error("nothing is kept");

  // On a phone, with a finger. (Where the pixels of a point are emulated, the canvas gets the wrong size.)
  await send("Emulation.setDeviceMetricsOverride", { width: 390, height: 844, deviceScaleFactor: 1, mobile: true });
  await send("Emulation.setTouchEmulationEnabled", { enabled: true });
  await open("#lesson=shadows&step=5");
  await picture("page-phone");
  const one_on = [{ x: 122, y: 818 }];
  await send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: one_on });
  await send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await until(at("step=6"), "a finger goes one step on");
  if (problems.length > 0) throw new Error(problems.join("; "));
  console.log(`the page opens in ${first} ms, and does what it should`);
  failed = false;
} catch (error) {
  console.error(`the page: ${error.message}`);
} finally {
  chromium.kill();
  server.close();
}
process.exit(failed ? 1 : 0);
