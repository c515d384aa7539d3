// Figures that a reader moves. The drawing and its numbers come from the module beside this script, which is the program of
// the book itself; here are only the controls. The page's HTML has them all, hidden until this script runs.
(() => {
    const round = (value, step) => Number((Math.round(value / step) * step).toFixed(4));
    let module;

    // The module is text in a script, so that a page opened from disk can load it too; once, when it is first needed.
    const load = () => module ??= new Promise((done, failed) => {
        globalThis.genevaModule = async text => {
            try {
                const packed = Uint8Array.from(atob(text), character => character.charCodeAt(0));
                const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
                const code = await WebAssembly.compile(await new Response(unpacked).arrayBuffer());
                // It asks the system for nothing: what it could ask for is answered by zero.
                const system = {};
                for (const { module, name } of WebAssembly.Module.imports(code)) {
                    (system[module] ??= {})[name] = () => 0;
                }
                const { exports } = await WebAssembly.instantiate(code, system);
                exports._initialize?.();
                done(question => {
                    const bytes = new TextEncoder().encode(question);
                    const room = exports.room(bytes.length);
                    new Uint8Array(exports.memory.buffer, room, bytes.length).set(bytes);
                    const length = exports.ask();
                    return new TextDecoder().decode(new Uint8Array(exports.memory.buffer, exports.answer(), length));
                });
            } catch (error) {
                failed(error);
            }
        };
        const script = document.createElement('script');
        script.src = 'data/live-module.js';
        script.onerror = failed;
        document.head.append(script);
    });

    // An answer is lines of fields with tabs, an empty line, the caption, the drawing.
    const parse = text => {
        const end = text.indexOf('\n\n');
        const lines = text.slice(0, end < 0 ? undefined : end).trim().split('\n').map(line => line.split('\t'));
        const rest = end < 0 ? '' : text.slice(end + 2);
        const cut = rest.indexOf('\n');
        return { lines, caption: rest.slice(0, cut), svg: rest.slice(cut + 1) };
    };

    const begin = figure => {
        const form = figure.querySelector('form');
        const inputs = [...form.querySelectorAll('input[name], select')];
        const player = form.querySelector('[data-play]');
        const message = form.querySelector('.message');
        const stale = form.querySelector('.stale');
        const follows = input => input.dataset.follows !== undefined;
        const first = Object.fromEntries(inputs.map(input => [input.name, follows(input) ? '' : input.value]));
        // Those that nobody has moved and that stand where the answer has them; values that a slider cannot stand at.
        const followers = new Set(inputs.filter(follows)), exact = new Map();
        let pending = false, playing = false, seen = true, last = 0;

        const value = input => followers.has(input) ? '' : exact.get(input) ?? input.value;
        const settings = () => inputs.map(input => `${input.name}=${value(input)}`).join('&');
        const ask = (answer, ending = '') =>
            answer(`${figure.dataset.live}${ending}?${figure.dataset.given}&${settings()}`);
        const say = (text, wrong) => {
            message.textContent = text;
            message.classList.toggle('wrong', Boolean(wrong));
        };

        const write = (input, value) => {
            input.value = value;
            const box = form.querySelector(`[data-box="${input.name}"]`);
            if (box && box !== document.activeElement) {
                box.value = value;
            }
        };

        const show = text => {
            const { lines, caption, svg } = parse(text);
            const refused = lines[0][0] === 'error';
            figure.classList.toggle('refused', refused);
            stale.hidden = !refused;
            if (refused) {
                stop();
                // No number stays that would seem to be of this setting.
                form.querySelectorAll('output').forEach(output => output.value = '–');
                return say(lines[0][1], true);
            }
            followers.forEach(input => write(input, lines.find(line => line[0] === 'follower' && line[1] === input.name)[2]));
            const told = Object.fromEntries(lines.filter(line => line[0] === 'number').map(line => [line[1], line[3]]));
            form.querySelectorAll('output').forEach(output => output.value = told[output.name] ?? '–');
            const progress = lines.find(line => line[0] === 'progress');
            const words = lines.find(line => line[0] === 'message');
            say(progress ? `${progress[1]} of ${progress[2]} runs` : words?.[1] ?? '', words);
            figure.querySelector('.drawing').innerHTML = svg;
            figure.querySelector('.says').textContent = caption;
            if (progress) {
                draw();
            }
        };

        const draw = () => {
            if (pending) {
                return;
            }
            pending = true;
            load().then(answer => requestAnimationFrame(() => {
                pending = false;
                show(ask(answer));
            }), error => say(`The figure cannot be moved here: ${error.message ?? 'its module does not load'}.`, true));
        };

        const save = (ending, text) => {
            if (text.startsWith('error\t')) {
                return say(text.slice(6), true);
            }
            const link = document.createElement('a');
            link.href = URL.createObjectURL(new Blob([text]));
            link.download = `${figure.dataset.live}.${ending}`;
            link.click();
            URL.revokeObjectURL(link.href);
        };

        const put = (input, value) => {
            if (value === '' && follows(input)) {
                followers.add(input);
                return;
            }
            followers.delete(input);
            write(input, value);
            // A number beside the slider's is asked for all the same, and the answer says what is possible.
            if (Number(input.value) === Number(value)) {
                exact.delete(input);
            } else {
                exact.set(input, value);
            }
        };
        const moved = () => {
            form.querySelector('[data-do=link]').href = `#${figure.id}?${settings()}`;
            draw();
        };
        const set = values => {
            for (const [name, value] of new URLSearchParams(values)) {
                const input = inputs.find(input => input.name === name);
                if (input) {
                    put(input, value);
                }
            }
            moved();
        };
        const advance = by => {
            const span = player.max - player.min;
            const value = (Number(player.value) + by - player.min) % span;
            put(player, round(Number(player.min) + (value < 0 ? value + span : value), player.step));
            moved();
        };

        const still = matchMedia('(prefers-reduced-motion: reduce)');
        const frame = now => {
            if (!playing) {
                return;
            }
            const passed = (now - last) / 1000;
            // Who wants less motion sees one step in a second.
            if (!still.matches || passed >= 1) {
                if (seen && !document.hidden && !pending && last) {
                    advance(player.dataset.play * Math.min(passed, still.matches ? 0.25 : 0.1));
                }
                last = now;
            }
            requestAnimationFrame(frame);
        };
        const play = on => {
            playing = on;
            last = 0;
            form.querySelector('[data-do=play]').textContent = on ? 'Pause' : 'Play';
            // What runs is not read out.
            form.querySelector('dl').setAttribute('aria-live', on ? 'off' : 'polite');
            if (on) {
                requestAnimationFrame(frame);
            }
        };
        const stop = () => playing && play(false);

        const actions = {
            play: () => play(!playing),
            back: () => advance(-player.dataset.play / 10),
            forth: () => advance(player.dataset.play / 10),
            reset: () => set(first),
        };
        form.addEventListener('input', ({ target }) => {
            if (target.dataset.box !== undefined) {
                const input = inputs.find(input => input.name === target.dataset.box);
                if (target.value === '') {
                    return;
                }
                put(input, target.value);
            } else {
                put(target, target.value);
            }
            if (target.name === player.name || target.dataset.box === player.name) {
                stop();
            }
            moved();
        });
        form.addEventListener('click', event => {
            const { do: what, set: values, file } = event.target.dataset;
            if (what && what !== 'link') {
                if (what !== 'play') {
                    stop();
                }
                actions[what]();
            } else if (values) {
                set(values);
            } else if (file) {
                load().then(answer => save(file, ask(answer, `.${file}`)));
            }
        });
        form.addEventListener('submit', event => event.preventDefault());

        // The pointer on the drawing turns what turns there.
        if (figure.dataset.drag) {
            const [name, right, sense] = figure.dataset.drag.split(' ');
            const drawing = figure.querySelector('.drawing');
            const input = inputs.find(input => input.name === name);
            const follow = event => {
                const svg = drawing.querySelector('svg'), circle = svg.querySelector('.pin-circle');
                const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
                const [x, y] = [at.x - circle.getAttribute('cx'), circle.getAttribute('cy') - at.y];
                if (event.type === 'pointerdown' && Math.hypot(x, y) > 1.3 * circle.getAttribute('r')) {
                    return false;
                }
                const turn = Number(right) + sense * Math.atan2(y, x) * 180 / Math.PI;
                const value = turn - 360 * Math.floor((turn - input.min) / 360);
                stop();
                put(input, round(value, input.step));
                moved();
                return true;
            };
            drawing.addEventListener('pointerdown', event => {
                if (event.button === 0 && follow(event)) {
                    event.preventDefault();
                    drawing.setPointerCapture(event.pointerId);
                }
            });
            drawing.addEventListener('pointermove', event => drawing.hasPointerCapture(event.pointerId) && follow(event));
        }

        new IntersectionObserver(([entry]) => seen = entry.isIntersecting).observe(figure);
        form.hidden = false;
        const linked = () => {
            const [id, values] = location.hash.slice(1).split('?');
            if (id === figure.id && values) {
                figure.scrollIntoView();
                set(values);
            }
        };
        addEventListener('hashchange', linked);
        linked();
    };

    const figures = document.querySelectorAll('[data-live]');
    const near = new IntersectionObserver(entries => entries.some(entry => entry.isIntersecting) && load().catch(() => {}), {
        rootMargin: '800px',
    });
    figures.forEach(figure => {
        begin(figure);
        near.observe(figure);
    });
    // For tests, and for whoever wants to ask by himself.
    globalThis.genevaLive = question => load().then(answer => answer(question));
})();
