// Figures that a reader moves. The drawing and its numbers come from the module beside this script, which is the program of
// the book itself. This script has only the controls. The page's HTML has them all, hidden until the script runs.
(() => {
    const round = (value, step) => Number((Math.round(value / step) * step).toFixed(4));
    const svgSpace = 'http://www.w3.org/2000/svg';
    // The elements and attributes of the book's drawings. A drawing with any other is not shown.
    const elements = new Set('circle desc g line path svg text title tspan'.split(' '));
    const attributes = new Set(('aria-labelledby class cx cy d data-letter dx dy fill fill-opacity fill-rule font-family font-size ' +
        'font-style id opacity paint-order r role stroke stroke-dasharray stroke-linecap stroke-linejoin stroke-opacity stroke-width ' +
        'text-anchor viewBox width x x1 x2 xmlns y y1 y2').split(' '));
    // A module by the name of its file; each is loaded once, when it is first needed. Meshes may take longer than a drawing.
    const modules = {}, slow = 20000;
    const module = (name, limit) => modules[name] ??= genevaThread(`data/${name}-module.js`, limit);
    const moduleOf = figure => module(figure.dataset.liveModule);

    // The drawing as an element of this page.
    const drawn = svg => {
        const parsed = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
        for (const element of [parsed, ...parsed.querySelectorAll('*')]) {
            const strange = element.namespaceURI !== svgSpace || !elements.has(element.localName) ||
                element.getAttributeNames().some(name =>
                    !attributes.has(name) || name !== 'xmlns' && /url\(|:\/\//.test(element.getAttribute(name)));
            if (strange) {
                throw new Error('the drawing has parts that no drawing of this book has');
            }
        }
        return document.adoptNode(parsed);
    };

    // The same words written again would be laid out again.
    const write = (element, text) => {
        if (element.textContent !== text) {
            element.textContent = text;
        }
    };

    const begin = figure => {
        const { load, ask } = moduleOf(figure);
        const form = figure.querySelector('form');
        const inputs = [...form.querySelectorAll('input[name], select')];
        const player = form.querySelector('[data-play]');
        const [message, ignored, stale] = ['message', 'ignored', 'stale'].map(name => figure.querySelector(`.${name}`));
        const announced = figure.querySelector('.results output');
        const outputs = figure.querySelectorAll('output'), files = figure.querySelectorAll('[data-file]');
        const box = input => form.querySelector(`[data-box="${input.name}"]`);
        const side = input => (input.dataset.side ?? '').split(' ');
        const follows = input => input.dataset.follows !== undefined || side(input)[1] > 0;
        const shown = input => (box(input) ?? input).value;
        const first = Object.fromEntries(inputs.map(input => [input.name, follows(input) ? '' : shown(input)]));
        // Those that nobody has moved and that stand where the answer has them; values that a slider cannot stand at.
        const followers = new Set(inputs.filter(follows));
        const isBeside = input => !follows(input) && box(input) && Number(box(input).value) !== Number(input.value);
        const exact = new Map(inputs.filter(isBeside).map(input => [input, shown(input)]));
        let heard = [], jammed = false, busy = false, again = false, playing = false, seen = true, last = 0;
        // What the drawing was made for, and the controls that move only its parts.
        let drawnFor, movedBy = [], halfFree = 0, described = '';

        const value = input => followers.has(input) ? '' : exact.get(input) ?? input.value;
        const settings = () => new URLSearchParams(inputs.map(input => [input.name, value(input)]));
        const question = (ending = '') =>
            `${figure.dataset.live}${ending}?${[figure.dataset.given, settings()].filter(part => `${part}`).join('&')}`;
        const say = (text, wrong) => {
            write(message, text);
            message.classList.toggle('wrong', Boolean(wrong));
        };

        // Where there is nothing that a control would stand for, its box is empty.
        const stand = (input, value) => {
            if (value === null) {
                box(input).value = '';
                return;
            }
            if (input.type !== 'number' || input !== document.activeElement) {
                input.value = value;
            }
            const number = box(input);
            if (number && number !== document.activeElement) {
                number.value = value;
            }
        };

        // Where the drawing is so small that nobody could read its dimensions, it shows the parts alone.
        const picture = figure.querySelector('.drawing');
        const isCropped = () => figure.classList.contains('cropped');
        const crop = () => {
            if (!isCropped()) {
                return;
            }
            const svg = picture.querySelector('svg');
            const boxes = [...svg.querySelectorAll('.wheel, .plate')].map(part => part.getBBox());
            const [left, top] = ['x', 'y'].map(side => Math.min(...boxes.map(box => box[side])) - 6);
            const right = Math.max(...boxes.map(({ x, width }) => x + width)), bottom = Math.max(...boxes.map(({ y, height }) => y + height));
            svg.dataset.whole ??= svg.getAttribute('viewBox');
            svg.setAttribute('viewBox', `${left} ${top} ${right + 6 - left} ${bottom + 6 - top}`);
        };

        // What a cropped drawing does not show (live.css) is not put into the page.
        const unseen = /<g [^]*?<\/g>|<text [^]*?<\/text>|<(line|path) (?![^>]*class="(?!ground))[^>]*>/g;
        const visible = svg => drawn(isCropped() ? svg.replace(unseen, '') : svg);
        // The last drawing, and how its parts were turned.
        let source, posed;

        // The heights of what stays and of its drawing while nothing was refused.
        let usual;
        const refuse = why => {
            stop();
            drawnFor = late = undefined;
            if (!figure.classList.contains('refused')) {
                usual = [shows, picture].map(({ offsetHeight }) => offsetHeight);
            }
            figure.classList.add('refused');
            stale.hidden = false;
            files.forEach(button => button.disabled = true);
            // No number stays that would seem to be of this setting.
            outputs.forEach(output => output.value = '–');
            if (worked) {
                worked.hidden = true;
            }
            say(why, true);
            // Long words take their room from the drawing, and cover no control.
            const [all, drawing] = usual, spare = height => figure.style.setProperty('--spared', `${height}px`);
            spare(drawing);
            spare(Math.max(drawing - Math.max(shows.offsetHeight - all, 0), 0));
        };
        // Steps are written where they are seen: not behind a closed fold, however often the figure moves.
        const worked = figure.querySelector('.worked');
        let solution;
        // The symbols of a step in italics, with their indices: {v:P} is v with the index P.
        const line = text => {
            const paragraph = document.createElement('p');
            text.split(/[{}]/).forEach((part, place) => {
                const [symbol, ...indices] = place % 2 ? part.split(':') : [part];
                const put = (element, textContent, more) => {
                    paragraph.append(Object.assign(document.createElement(element), { textContent }, more));
                };
                const dotted = /[\u0307\u0308]/.test(symbol) && { className: 'dotted' };
                place % 2 ? put('i', symbol, dotted) : paragraph.append(symbol);
                // Who copies the steps gets v_P, and not vP.
                indices.forEach((index, level) => {
                    put('span', '_^'[level], { className: 'unseen', ariaHidden: true });
                    put(['sub', 'sup'][level], index);
                });
            });
            return paragraph;
        };
        const solve = () => worked.open && solution && worked.querySelector('ol').replaceChildren(...solution.map(({ heading, lines }) => {
            const item = document.createElement('li');
            item.appendChild(document.createElement('strong')).append(heading);
            item.append(...lines.map(line));
            return item;
        }));
        worked?.addEventListener('toggle', solve);
        // Wheel and driver turn in the drawing, which stays. Play and errors come as large as they are to be seen.
        const words = figure.querySelector('.turned');
        const turn = parts => {
            posed = parts;
            const svg = figure.querySelector('.drawing svg'), line = svg.querySelector('.line-of-centres');
            const [x, y, far] = ['x1', 'y1', 'x2'].map(name => Number(line.getAttribute(name)));
            const scale = (far - x) / parts.centre_distance, apart = parts.apart * scale;
            const set = (element, ...steps) => {
                const transform = parts.words && steps.filter(step => !/^(rotate\(0 .*|translate\(0 0\)|scale\(1\))$/.test(step)).join(' ');
                transform ? element.setAttribute('transform', transform) : element.removeAttribute('transform');
            };
            const driver = [`translate(${apart} 0)`, `rotate(${parts.driver} ${far} ${y})`];
            const larger = (by, atX, atY) => by === 1 ? [] : [`translate(${atX} ${atY})`, `scale(${by})`, `translate(${-atX} ${-atY})`];
            svg.querySelectorAll('.wheel').forEach(wheel => set(wheel, `rotate(${-parts.wheel} ${x} ${y})`));
            svg.querySelectorAll('.plate').forEach(plate => set(plate, ...driver));
            svg.querySelectorAll('.locking-disc').forEach(disc => set(disc, ...driver, ...larger(parts.disc_scale, far, y)));
            svg.querySelectorAll('.pin').forEach(pin => {
                if (!parts.words) {
                    return pin.removeAttribute('transform');
                }
                const box = pin.getBBox(), [atX, atY] = [box.x + box.width / 2, box.y + box.height / 2];
                const out = parts.pins_out * scale / Math.hypot(atX - far, atY - y);
                set(pin, ...driver, `translate(${(atX - far) * out} ${(atY - y) * out})`, ...larger(parts.pin_scale, atX, atY));
            });
            svg.querySelectorAll('.contact').forEach(contact => contact.remove());
            for (const [along, left] of parts.contacts) {
                const contact = svg.appendChild(document.createElementNS(svgSpace, 'circle'));
                const places = { class: 'contact', cx: x + along * scale, cy: y - left * scale, r: 10 };
                Object.entries(places).forEach(([name, value]) => contact.setAttribute(name, value));
            }
            write(words, parts.words);
            svg.querySelector('desc').textContent = `${described} ${parts.words}`.trim();
            figure.classList.toggle('jams', parts.jams);
            [halfFree, movedBy, jammed] = [parts.half_free, parts.moved_by, parts.jams];
            if (jammed) {
                stop();
            }
        };
        // Whether the last answer has only a part of a long calculation, and the settings that were asked for last.
        let pending = false, before;
        // Numbers far out of sight are written once a setting stays: a picture does not wait for them.
        const others = figure.querySelector('.others');
        let isFar = false, late;
        others && new IntersectionObserver(([entry]) => {
            isFar = !entry.isIntersecting;
            isFar || late?.();
        }, { rootMargin: '64px' }).observe(others);
        const show = ({ error, numbers, followers: told, message: words, progress, caption, svg, steps, jams, turned, command }, stays) => {
            if (error !== undefined) {
                pending = false;
                return refuse(error);
            }
            const drawing = visible(svg);
            source = svg;
            figure.classList.remove('refused');
            stale.hidden = true;
            files.forEach(button => button.disabled = false);
            followers.forEach(input => stand(input, told.find(({ name }) => name === input.name).value));
            heard = numbers;
            const texts = Object.fromEntries(numbers.map(({ name, text }) => [name, text]));
            const tell = outputs => outputs.forEach(output => write(output, texts[output.name] ?? '–'));
            tell(figure.querySelectorAll('.results output'));
            late = () => {
                tell(others?.querySelectorAll('output') ?? []);
                late = undefined;
            };
            isFar && !stays || late();
            say([words, progress?.parts && `${progress.done} of ${progress.all} ${progress.parts}`].filter(Boolean).join(' '), words);
            picture.replaceChildren(drawing);
            crop();
            write(figure.querySelector('.says'), caption);
            if (worked) {
                worked.hidden = !steps.length;
                solution = steps;
                solve();
            }
            jammed = jams;
            if (jammed) {
                stop();
            }
            if (turned) {
                described = figure.querySelector('.drawing desc').textContent;
                turn(turned);
            }
            if (command) {
                write(form.querySelector('.command'), command);
            }
            pending = Boolean(progress);
        };

        // A fifth of a second, or until something is asked for.
        let wake;
        const quiet = () => new Promise(done => {
            wake = done;
            setTimeout(done, 200);
        });
        const answered = async () => {
            try {
                await load();
            } catch (error) {
                return say(`The figure cannot be moved here: ${error.message}.`, true);
            }
            while (again) {
                again = false;
                const asked = Object.fromEntries(settings());
                // A setting that stays is asked for again for the rest of its calculation.
                const stays = before && inputs.every(({ name }) => asked[name] === before[name]);
                const turns = !(pending && stays) && drawnFor && movedBy.length > 0
                    && inputs.every(({ name }) => asked[name] === drawnFor[name] || movedBy.includes(name));
                before = asked;
                try {
                    // While it moves, what takes long is not asked for.
                    const answer = JSON.parse(await ask(question(turns ? '.turned' : stays ? '' : '.motion')));
                    if (turns && answer.error === undefined) {
                        turn(answer);
                    } else {
                        show(answer, stays);
                        drawnFor = answer.error === undefined ? asked : undefined;
                    }
                } catch (error) {
                    pending = false;
                    refuse(`The figure has no answer for this setting: ${error.message}.`);
                }
                // What runs goes on instead of waiting for the rest, which is counted once the setting stays for a while.
                if ((pending || late) && !playing && !again) {
                    if (!stays) {
                        await quiet();
                    }
                    again || late?.();
                    again ||= pending && !playing;
                }
                // A first question does not wait for a frame; those that follow it are asked once in each.
                if (again) {
                    await new Promise(requestAnimationFrame);
                }
            }
        };
        const draw = async () => {
            again = true;
            wake?.();
            if (!busy) {
                busy = true;
                // Nothing is read out before the last answer is there.
                figure.setAttribute('aria-busy', 'true');
                await answered();
                await tolerate();
                busy = false;
                figure.removeAttribute('aria-busy');
                if (again) {
                    draw();
                }
            }
        };

        // The table of tolerances, where it is seen and once a setting stays: it takes longer than a drawing.
        const table = figure.querySelector('.tolerances');
        let toleratedFor;
        const tolerate = async () => {
            const asked = JSON.stringify(drawnFor);
            if (!table?.closest('details').open || !drawnFor || playing || asked === toleratedFor) {
                return;
            }
            try {
                const rows = JSON.parse(await ask(question('.tolerances')));
                if (rows.error !== undefined) {
                    return;
                }
                toleratedFor = asked;
                const list = table.tBodies[0].rows;
                rows.forEach(({ name, set, alone, together, state, words }, at) => {
                    const [head, ...cells] = list[at].cells;
                    list[at].className = state;
                    head.firstChild.data = name;
                    head.querySelector('.state').textContent = words;
                    [set, alone, together].forEach((text, cell) => { cells[cell].textContent = text; });
                });
            } catch {
                // The next setting asks again.
            }
        };
        table?.closest('details').addEventListener('toggle', ({ target }) => target.open && drawnFor && draw());

        const save = async file => {
            let answer;
            try {
                answer = JSON.parse(await module('live-files', slow).ask(question(`.${file}`)));
            } catch (error) {
                answer = { error: `The file cannot be made: ${error.message}.` };
            }
            if (answer.error !== undefined) {
                return say(answer.error, true);
            }
            const link = document.createElement('a');
            const bytes = answer.file ?? Uint8Array.from(atob(answer.base64), sign => sign.charCodeAt(0));
            link.href = URL.createObjectURL(new Blob([bytes]));
            link.download = file;
            link.click();
            URL.revokeObjectURL(link.href);
        };

        const put = (input, value) => {
            if (value === '' && (follows(input) || input.dataset.side)) {
                followers.add(input);
                return;
            }
            followers.delete(input);
            // What is on the other side follows now; what is on this side stays as it is shown.
            const [group, number] = side(input);
            for (const other of inputs.filter(other => group && other !== input && side(other)[0] === group)) {
                if (side(other)[1] !== number) {
                    followers.add(other);
                } else if (followers.delete(other) && box(other)) {
                    exact.set(other, shown(other));
                }
            }
            stand(input, value);
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
                // `*2` is twice what it is.
                put(input, value[0] === '*' ? Number((shown(input) * value.slice(1)).toPrecision(12)) : value);
            }
            moved();
        };
        // An address is anybody's: a value is taken if it is a number that can be typed in its control's box, or one of its
        // choices. It is not told what the address says instead.
        const isPossible = (input, value) => {
            if (value === '') {
                return follows(input) || Boolean(input.dataset.side);
            }
            if (input.options) {
                return [...input.options].some(option => option.value === value);
            }
            const { min, max } = box(input) ?? input;
            return /^-?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(value) && Number(value) >= min && Number(value) <= max;
        };
        const address = values => {
            const pairs = [...new URLSearchParams(values)], wrong = new Set();
            let unknown = false;
            for (const [name, value] of pairs) {
                const input = inputs.find(input => input.name === name);
                if (!input) {
                    unknown = true;
                } else if (pairs.filter(pair => pair[0] === name).length > 1 || !isPossible(input, value)) {
                    wrong.add(input);
                } else {
                    put(input, value);
                }
            }
            moved();
            const labels = [...wrong].map(input => {
                const { min, max } = box(input) ?? input, range = max ? ` (${min} to ${max})` : '';
                return `“${input.labels[0].textContent}”${range}`;
            });
            ignored.textContent = [
                labels.length ? `The address has no possible value for ${labels.join(', ')}, and it was ignored.` : '',
                unknown ? 'The address names something that this figure does not have, and it was ignored.' : '',
            ].join(' ').trim();
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
                if (seen && !document.hidden && !busy && last) {
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
            [announced, words].forEach(element => element?.setAttribute('aria-live', on ? 'off' : 'polite'));
            if (on) {
                requestAnimationFrame(frame);
            } else {
                late?.();
                pending && draw();
            }
        };
        const stop = () => {
            if (playing) {
                play(false);
                draw();
            }
        };

        // Two seconds of its beat, each a click that dies away: only when asked for, and only if there is a beat.
        let audio;
        const hear = async ({ dataset: { beat } }) => {
            if (!heard.length) {
                await draw();
            }
            const every = heard.find(({ name }) => name === beat)?.value / 1000;
            if (!(every > 0)) {
                return;
            }
            audio ??= new AudioContext();
            const rate = audio.sampleRate, buffer = audio.createBuffer(1, 2 * rate, rate), source = audio.createBufferSource();
            buffer.getChannelData(0).forEach((_, at, samples) => {
                const passed = at / rate % every;
                samples[at] = 0.5 * Math.exp(-400 * passed) * Math.sin(9000 * passed);
            });
            source.buffer = buffer;
            source.connect(audio.destination);
            source.start();
        };
        const copy = async button => {
            const command = form.querySelector('.command');
            try {
                await navigator.clipboard.writeText(command.textContent);
                button.textContent = 'Copied';
                setTimeout(() => { button.textContent = 'Copy'; }, 2000);
            } catch {
                // Where a page may not copy, the reader can.
                getSelection().selectAllChildren(command);
            }
        };
        const actions = {
            copy,
            hear,
            play: () => playing || jammed ? stop() : play(true),
            back: () => advance(-player.dataset.play / 10),
            forth: () => advance(player.dataset.play / 10),
            reset: () => set(first),
        };
        form.addEventListener('input', ({ target }) => {
            ignored.textContent = '';
            if (target.type === 'number' && target.value === '') {
                return;
            }
            if (target.dataset.box !== undefined) {
                const input = inputs.find(input => input.name === target.dataset.box);
                put(input, target.value);
            } else {
                put(target, target.value);
            }
            if (player && [target.name, target.dataset.box].includes(player.name)) {
                stop();
            }
            moved();
        });
        figure.addEventListener('click', event => {
            const { do: what, set: values, whole, file } = event.target.dataset;
            ignored.textContent = '';
            if (what && what !== 'link') {
                if (what !== 'play' && what !== 'copy') {
                    stop();
                }
                actions[what](event.target);
            } else if (values) {
                if (whole !== undefined) {
                    set(first);
                }
                set(values);
            } else if (file) {
                save(file);
            }
        });
        form.addEventListener('submit', event => event.preventDefault());

        // One fold at a time: the others would take its room. What was pressed stays under the pointer.
        form.addEventListener('click', ({ target }) => {
            const own = target.closest('summary')?.parentElement;
            if (own && !own.open) {
                const top = own.getBoundingClientRect().top;
                form.querySelectorAll('.moved details').forEach(fold => { fold.open &&= fold === own; });
                // Beside the drawing the folds are in sight as they are.
                if (getComputedStyle(form).display !== 'contents') {
                    scrollBy({ top: own.getBoundingClientRect().top - top, behavior: 'instant' });
                }
            }
        });

        // A finger that holds a part of the drawing moves no page.
        let isHeld = false;
        const hold = event => {
            isHeld = true;
            event.preventDefault();
            picture.setPointerCapture(event.pointerId);
        };
        picture.addEventListener('lostpointercapture', () => { isHeld = false; });
        picture.addEventListener('touchstart', event => isHeld && event.preventDefault(), { passive: false });

        // The pointer on the wheel turns it within its play.
        if (figure.dataset.hand) {
            const drawing = picture;
            const input = inputs.find(input => input.name === figure.dataset.hand);
            let from;
            const angle = event => {
                const svg = drawing.querySelector('svg'), line = svg.querySelector('.line-of-centres');
                const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
                return Math.atan2(line.getAttribute('y1') - at.y, at.x - line.getAttribute('x1')) * 180 / Math.PI;
            };
            drawing.addEventListener('pointerdown', event => {
                if (event.button === 0 && event.target.matches('.wheel')) {
                    hold(event);
                    stop();
                    from = { angle: angle(event), value: Number(value(input)) };
                    // Before the first answer it is not known how far it is free.
                    moved();
                }
            });
            drawing.addEventListener('pointermove', event => {
                if (drawing.hasPointerCapture(event.pointerId) && halfFree > 0) {
                    const by = (angle(event) - from.angle + 540) % 360 - 180;
                    const turned = from.value + 100 * by / halfFree;
                    put(input, round(Math.min(Math.max(turned, input.min), input.max), input.step));
                    moved();
                }
            });
        }

        // The pointer on the drawing turns what turns there.
        if (figure.dataset.drag) {
            const [name, right, sense] = figure.dataset.drag.split(' ');
            const drawing = picture;
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
                    hold(event);
                }
            });
            drawing.addEventListener('pointermove', event => drawing.hasPointerCapture(event.pointerId) && follow(event));
        }

        // The drawing stays in sight if there is room below it for a control, or for nothing where the controls are beside it.
        // In a lower window it shrinks while the page goes by, and stays as soon as there is room.
        const shows = figure.querySelector('.shown'), least = 160;
        let whole = 0, spare = 0, above = 0;
        const shrink = () => {
            const top = Number.parseFloat(getComputedStyle(shows).top) || 0;
            const gone = Math.min(Math.max(top - figure.getBoundingClientRect().top - above, 0), spare);
            figure.classList.toggle('smaller', gone > 0);
            figure.style.setProperty('--drawn', `${whole - gone}px`);
            figure.style.setProperty('--gone', `${gone}px`);
        };
        const fit = () => {
            figure.classList.remove('stays', 'shrinks', 'smaller');
            const svg = picture.querySelector('svg');
            if (svg.dataset.whole) {
                svg.setAttribute('viewBox', svg.dataset.whole);
                delete svg.dataset.whole;
            }
            const wasCropped = isCropped();
            figure.classList.toggle('cropped', getComputedStyle(picture).getPropertyValue('--cropped').trim() === '1');
            if (source && isCropped() !== wasCropped) {
                picture.replaceChildren(visible(source));
                posed && turn(posed);
            }
            crop();
            const isBeside = getComputedStyle(form).display === 'contents';
            const { clientHeight } = document.documentElement;
            above = shows.getBoundingClientRect().top - figure.getBoundingClientRect().top;
            whole = picture.offsetHeight;
            const height = shows.offsetHeight, smallest = height - whole + least;
            // Controls below it need some room to be found in.
            const shrinks = whole > least && height + (isBeside ? 52 : 0.4 * clientHeight) > clientHeight
                && smallest + (isBeside ? 52 : 300) <= clientHeight;
            const stays = shrinks || height + (isBeside ? 52 : 140) <= clientHeight;
            spare = shrinks ? whole - least : 0;
            figure.classList.toggle('stays', stays);
            figure.classList.toggle('shrinks', shrinks);
            shrink();
        };
        addEventListener('scroll', () => spare > 0 && requestAnimationFrame(shrink), { passive: true });
        new IntersectionObserver(([entry]) => seen = entry.isIntersecting).observe(figure);
        form.hidden = false;
        addEventListener('resize', fit);
        document.fonts.ready.then(fit);
        const linked = () => {
            const [id, values] = location.hash.slice(1).split('?');
            if (id === figure.id && values) {
                figure.scrollIntoView();
                address(values);
            }
        };
        addEventListener('hashchange', linked);
        linked();
    };

    const figures = document.querySelectorAll('[data-live]');
    const near = new IntersectionObserver(entries => entries.forEach(({ isIntersecting, target }) => {
        isIntersecting && moduleOf(target).load().catch(() => {});
    }), { rootMargin: '800px' });
    figures.forEach(figure => {
        begin(figure);
        near.observe(figure);
    });
    // For tests, and for readers who want to ask from the console.
    globalThis.genevaLive = question => {
        const asked = [...figures].find(({ dataset }) => dataset.live === question.split(/[.?]/)[0]) ?? figures[0];
        return moduleOf(asked).ask(question);
    };
})();
