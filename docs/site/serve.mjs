// node serve.mjs FOLDER [PORT]: shows a folder to this machine's browser. Also used by test.mjs.
import { createServer } from 'node:http';
import { createReadStream, existsSync, statSync } from 'node:fs';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

const types = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.json': 'application/json', '.wasm': 'application/wasm', '.svg': 'image/svg+xml', '.png': 'image/png', '.gif': 'image/gif', '.woff2': 'font/woff2', '.csv': 'text/csv' };

/** `under`: the address that the folder has, such as /bounce/. */
export const serve = (folder, port, under = '/') => new Promise(begun => {
  const server = createServer((request, answer) => {
    const path = decodeURIComponent(new URL(request.url, 'http://here').pathname);
    let file = join(folder, normalize('/' + path.slice(under.length)));
    if (existsSync(file) && statSync(file).isDirectory()) file = join(file, 'index.html');
    if (!path.startsWith(under) || !existsSync(file)) { answer.writeHead(404).end('There is no such page.'); return; }
    answer.writeHead(200, { 'content-type': types[extname(file)] ?? 'application/octet-stream', 'cache-control': 'no-cache' });
    createReadStream(file).pipe(answer);
  }).listen(port, '127.0.0.1', () => begun(server));
});

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const server = await serve(process.argv[2], Number(process.argv[3] ?? 8080));
  console.log(`http://127.0.0.1:${server.address().port}/ shows the course; Ctrl-C ends this`);
}
