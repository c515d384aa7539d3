// Derives verdicts in the reader's own browser, by the program of the book: of one claim, with other characters if the reader likes,
// or of many. The module answers with text: lines whose parts are divided by tabs.
(() => {
    'use strict';
    // How long one check may take, in milliseconds.
    const patience = 60000;
    const first = genevaThread('data/verify-module.js', patience);
    const command = () => globalThis.genevaRecord?.command ?? '';
    const told = error => `Nothing can be checked here: ${error.message}.` +
        (command() ? ` On a machine with Rust, ${command()} does the same.` : '');

    const element = (name, properties = {}, ...children) => {
        const made = Object.assign(document.createElement(name), properties);
        made.append(...children);
        return made;
    };
    const dialog = (isAbove, title, ...children) => {
        const close = element('button', { type: 'button', className: 'close', textContent: 'Close' });
        const heading = element('h2', {}, ...title);
        const box = element('dialog', { className: 'verify' }, element('header', {}, heading, close), ...children);
        heading.id = 'verify-title';
        box.setAttribute('aria-labelledby', heading.id);
        close.onclick = () => box.close();
        // mdBook has keys of its own on the page behind, Escape among them.
        box.addEventListener('keydown', event => {
            event.stopPropagation();
            if (event.key === 'Escape') {
                box.close();
            }
        });
        box.addEventListener('close', () => {
            box.remove();
            // Who loads the page again wants the page.
            if (location.hash.startsWith('#check:') && !document.querySelector('dialog.verify')) {
                history.replaceState(null, '', location.pathname + location.search);
            }
        });
        if (!isAbove) {
            document.querySelectorAll('dialog.verify').forEach(other => other.close());
        }
        document.body.append(box);
        box.showModal();
        return box;
    };
    // The head of a check: the derived verdict, the recorded one, whether they agree, and what contradicts the record.
    const checked = text => {
        const [head, ...lines] = text.split('\n').map(line => line.split('\t'));
        if (head[0] === 'error') {
            throw new Error(head[1]);
        }
        const [verdict, , outcome, why] = head;
        return { verdict, outcome, holds: outcome === 'holds', why, lines };
    };
    const duration = milliseconds => milliseconds < 1000 ? `${Math.max(1, Math.round(milliseconds))} ms` : `${(milliseconds / 1000).toFixed(1)} s`;
    const recorded = id => globalThis.genevaRecord?.verdicts[id] ?? 'no verdict';
    const asBuilt = (id, verdict) => recorded(id) === verdict;

    // One claim: its printed characters may be changed, and the verdict follows.
    const one = async (id, characters, isAbove = false) => {
        const field = element('textarea', { spellcheck: false, rows: 2, disabled: true });
        const status = element('output', { textContent: 'The check is being loaded…' });
        const list = element('dl');
        const reset = element('button', { type: 'button', textContent: 'As printed', disabled: true });
        const link = element('a', { textContent: 'Link to this check' });
        const box = dialog(
            isAbove,
            ['Check ', element('code', { textContent: id })],
            element('label', {}, 'Characters that are checked: change one, and see what happens', field),
            element('p', {}, reset, ' ', link),
            element('p', { className: 'status' }, status),
            list,
        );
        let printed, last = 0, busy = 0;
        const isAccepted = verdict => ['right', 'right as read'].includes(verdict);
        const taken = (verdict, outcome, lines) => {
            if (outcome === 'unread') {
                return 'These characters change nothing: the check of this claim doesn’t read them.';
            }
            if (outcome === 'unreadable') {
                return '? These characters can’t be read, so they are neither right nor wrong.';
            }
            const change = verdict === recorded(id) ? `still ${verdict}` : `the verdict changes from ${recorded(id)} to ${verdict}`;
            // What a number is no rounding of, and what it is one of instead.
            const digits = lines.find(([label]) => label === 'Found')?.[1].match(/These digits.*/)?.[0] ?? '';
            return `${isAccepted(verdict) ? '✓ Accepted' : '✗ Refused'}: ${change}. ${digits}`.trimEnd();
        };
        const show = ({ verdict, outcome, holds, why, lines }, spoilt, took) => {
            let words;
            if (spoilt) {
                words = taken(verdict, outcome, lines);
            } else if (!asBuilt(id, verdict)) {
                words = `✗ The verdict is ${verdict}, but this book was built with ${recorded(id)}.`;
            } else {
                words = holds ? `✓ The same as recorded: ${verdict}.` : `✗ ${verdict} as recorded, but: ${why}.`;
            }
            status.textContent = `${words} Derived in your browser in ${duration(took)}.`;
            box.classList.toggle('differs', words[0] === '✗');
            list.replaceChildren(...lines.flatMap(([label, text]) => [
                element('dt', { textContent: label }), element('dd', { textContent: text }),
            ]));
        };
        const ask = async () => {
            const own = ++last, text = field.value, spoilt = text !== printed;
            link.href = `#check:${id}${spoilt ? `:${encodeURIComponent(text.replace(/\p{Surrogate}/gu, ''))}` : ''}`;
            reset.disabled = !spoilt;
            box.setAttribute('aria-busy', 'true');
            // A newer question does not wait for one that nobody wants any more.
            if (busy++) {
                first.stop('another question came');
            }
            const begun = performance.now();
            try {
                const answer = checked(await first.ask(`account ${id}${spoilt ? `\n${text}` : ''}`));
                if (own === last) {
                    show(answer, spoilt, performance.now() - begun);
                }
            } catch (error) {
                if (own === last) {
                    box.classList.add('differs');
                    list.replaceChildren();
                    status.textContent = `✗ The check gives no answer: ${error.message}.`;
                }
            }
            busy--;
            if (own === last) {
                box.removeAttribute('aria-busy');
            }
        };
        let waiting;
        field.oninput = () => {
            clearTimeout(waiting);
            waiting = setTimeout(ask, 200);
        };
        reset.onclick = () => {
            field.value = printed;
            ask();
            field.focus();
        };
        try {
            await first.load();
            printed = await first.ask(`printed ${id}`);
            if (printed.startsWith('error\t')) {
                throw new Error(printed.split('\t')[1]);
            }
        } catch (error) {
            status.textContent = told(error);
            return;
        }
        const { most } = globalThis.genevaRecord;
        field.maxLength = most;
        field.value = characters === undefined ? printed : Array.from(characters).slice(0, most).join('');
        field.disabled = false;
        await ask();
    };

    // Many claims, or all: shared out among as many threads as the machine has, each with a module of its own.
    const many = async wanted => {
        const bar = element('progress', { max: 1, value: 0 });
        bar.setAttribute('aria-label', 'Claims checked');
        const status = element('output', { textContent: 'The checks are being loaded…' });
        const toggle = element('button', { type: 'button', textContent: 'Stop', disabled: true });
        const list = element('ul');
        const box = dialog(
            false,
            [wanted ? 'Check this page' : 'Check everything'],
            element('p', {}, bar, ' ', toggle), element('p', { className: 'status' }, status), list,
        );
        let ids, running = false;
        box.addEventListener('close', () => running = false);
        try {
            await first.load();
            const all = (await first.ask('list')).split('\n').map(line => line.split('\t')[0]);
            ids = wanted ?? all;
        } catch (error) {
            status.textContent = told(error);
            return;
        }
        bar.max = ids.length;
        toggle.disabled = false;
        // Neighbours share what they compute, so each thread takes some in a row.
        const share = Math.max(1, Math.min(12, Math.ceil(ids.length / 16)));
        const shares = [];
        for (let at = 0; at < ids.length; at += share) {
            shares.push(ids.slice(at, at + share));
        }
        let done = 0, well = 0, spent = 0;
        const say = (id, why) => {
            const button = element('button', { type: 'button', textContent: id });
            button.onclick = () => one(id, undefined, true);
            list.append(element('li', {}, button, `: ${why}`));
        };
        const work = async () => {
            const { ask, stop } = genevaThread(first.load, patience);
            while (running && shares.length > 0) {
                const taken = shares.shift();
                while (taken.length > 0) {
                    if (!running) {
                        shares.unshift(taken);
                        break;
                    }
                    const id = taken.shift();
                    try {
                        const { verdict, holds, why } = checked(await ask(`judge ${id}`));
                        if (holds && asBuilt(id, verdict)) {
                            well++;
                        } else {
                            say(id, why || `${verdict}, and this book was built with ${recorded(id)}`);
                        }
                    } catch (error) {
                        say(id, `no answer: ${error.message}`);
                    }
                    done++;
                }
            }
            stop();
        };
        const run = async () => {
            running = true;
            toggle.textContent = 'Stop';
            const begun = performance.now(), before = spent;
            const tick = () => {
                spent = before + performance.now() - begun;
                const left = done > 0 ? `, about ${duration(spent / done * (ids.length - done))} left` : '';
                bar.value = done;
                status.textContent = `${done} of ${ids.length} checked${left}.`;
            };
            const timer = setInterval(tick, 250);
            // What is read out is the result.
            status.setAttribute('aria-live', 'off');
            const threads = Math.min(navigator.hardwareConcurrency || 2, 8, shares.length);
            await Promise.all(Array.from({ length: threads }, work));
            clearInterval(timer);
            tick();
            running = false;
            status.setAttribute('aria-live', 'polite');
            if (done < ids.length) {
                status.textContent = `Stopped: ${well} of ${done} as recorded, ${ids.length - done} not checked.`;
                toggle.textContent = 'Go on';
                return;
            }
            toggle.remove();
            box.classList.toggle('differs', well < done);
            status.textContent = well === done
                ? `✓ ${done} of ${done} verdicts derived in your browser, each as recorded, in ${duration(spent)}.`
                : `✗ ${well} of ${done} verdicts derived in your browser are as recorded. These ${done - well} are not:`;
        };
        toggle.onclick = () => running ? running = false : run();
        if (box.isConnected) {
            await run();
        }
    };
    globalThis.genevaVerify = { one, many, ask: first.ask };
})();
