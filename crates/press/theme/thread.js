// Questions to a module of WebAssembly, which runs in a thread of its own. `source` is the script that holds it as text, or what
// loads it for another thread. `limit` is how long an answer may take, in milliseconds, before the module is taken to be stuck.
// `load` gets the module, `ask` the text of an answer, and `stop` ends the thread.
globalThis.genevaThread ??= (source, limit = 5000) => {
    let module, thread, abort, queue = Promise.resolve();

    // Bytes of text in which a character is seven bits, or twice seven: one of these groups, then any; the last may stand alone.
    const forbidden = [0, 10, 13, 39, 92, 60, 62];
    const bytesOf = text => {
        const bytes = new Uint8Array(Math.floor(text.length * 7 / 4));
        let held = 0, bits = 0, to = 0;
        const push = group => {
            held = held << 7 | group;
            bits += 7;
            if (bits >= 8) {
                bits -= 8;
                bytes[to] = held >>> bits;
                to += 1;
                held &= (1 << bits) - 1;
            }
        };
        for (let at = 0; at < text.length; at += 1) {
            const both = text.charCodeAt(at) - 128;
            if (both >> 7 === forbidden.length) {
                push(forbidden[both & 127]);
            } else if (both >= 0) {
                push(forbidden[both >> 7]);
                push(both & 127);
            } else {
                push(both + 128);
            }
        }
        return bytes.subarray(0, to);
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
