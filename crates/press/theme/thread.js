// Questions to a module of WebAssembly, which runs in a thread of its own. `source` is the script that holds it as text, or what
// loads it for another thread. `limit` is how long an answer may take, in milliseconds, before the module is taken to be stuck.
// `load` gets the module, `ask` the text of an answer, and `stop` ends the thread.
globalThis.genevaThread ??= (source, limit = 5000) => {
    let module, thread, abort, queue = Promise.resolve();

    // Bytes of text in which five characters stand for four bytes (ZeroMQ RFC 32); missing ones at the end count as the last digit.
    const digits = '0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.-:+=^!/*?&<>()[]{}@%$#';
    const bytesOf = text => {
        const values = new Uint8Array(128).fill(84);
        [...digits].forEach((digit, value) => { values[digit.charCodeAt(0)] = value; });
        const bytes = new Uint8Array(Math.floor(text.length * 4 / 5));
        for (let at = 0, to = 0; at < text.length; at += 5, to += 4) {
            let value = 0;
            for (let k = 0; k < 5; k += 1) {
                value = 85 * value + (at + k < text.length ? values[text.charCodeAt(at + k)] : 84);
            }
            for (let k = 0; k < 4; k += 1) {
                bytes[to + k] = value >>> 24 - 8 * k;
            }
        }
        return bytes;
    };

    // The module is text in a script, so that a page opened from disk can load it too; once, when it is first needed.
    const load = () => module ??= source.call ? source() : new Promise((done, failed) => {
        const script = document.createElement('script');
        globalThis.genevaModule = text => document.currentScript.take(text);
        script.take = async text => {
            try {
                const unpacked = new Blob([bytesOf(text)]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
                done(await WebAssembly.compile(await new Response(unpacked).arrayBuffer()));
            } catch (error) {
                failed(error);
            }
        };
        script.onerror = () => failed(new Error('no module loads'));
        script.src = source;
        document.head.append(script);
    });

    // What runs in the module's own thread: it gets the module, then questions one at a time.
    const answering = () => {
        let instance;
        const start = async code => {
            // It asks the system for nothing: each function that it could call gives zero.
            const system = {};
            for (const { module, name } of WebAssembly.Module.imports(code)) {
                (system[module] ??= {})[name] = () => 0;
            }
            const { exports } = await WebAssembly.instantiate(code, system);
            exports._initialize?.();
            return exports;
        };
        onmessage = async ({ data: { code, question } }) => {
            if (code) {
                instance = start(code);
                return;
            }
            try {
                const exports = await instance;
                const bytes = new TextEncoder().encode(question);
                const room = exports.room(bytes.length);
                new Uint8Array(exports.memory.buffer, room, bytes.length).set(bytes);
                const length = exports.ask();
                postMessage({ text: new TextDecoder().decode(new Uint8Array(exports.memory.buffer, exports.answer(), length)) });
            } catch (error) {
                postMessage({ failed: error.message });
            }
        };
    };
    const begun = code => {
        const address = URL.createObjectURL(new Blob([`(${answering})()`], { type: 'text/javascript' }));
        const worker = new Worker(address);
        URL.revokeObjectURL(address);
        worker.postMessage({ code });
        return worker;
    };
    // Ends the thread, and the question that it has; the next one gets a fresh module.
    const stop = why => {
        thread?.terminate();
        thread = undefined;
        abort?.(new Error(why));
    };
    const answered = async question => {
        const code = await load();
        thread ??= begun(code);
        return new Promise((done, failed) => {
            const timer = setTimeout(() => stop(`no answer within ${limit / 1000} s`), limit);
            abort = error => {
                clearTimeout(timer);
                failed(error);
            };
            thread.onmessage = ({ data: { text, failed: why } }) => why === undefined ? (clearTimeout(timer), done(text)) : stop(why);
            thread.onerror = event => stop(event.message ?? 'no thread starts');
            thread.postMessage({ question });
        });
    };
    // The text of an answer; questions are asked one after the other.
    const ask = question => {
        const answer = queue.then(() => answered(question));
        queue = answer.catch(() => {});
        return answer;
    };
    return { load, ask, stop };
};
