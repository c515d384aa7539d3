// A text of the reader's own, proofread by the module beside this script. What is pasted goes to the module's memory and into
// text nodes, and nowhere else. The page's HTML has all controls, hidden until the script runs.
(() => {
    const { ask } = genevaThread('data/proofread-module.js');
    const place = document.querySelector('[data-proofread]');
    const form = place.querySelector('form'), area = form.querySelector('textarea');
    const { format, bindings, units, doubts, file } = form.elements;
    const [summary, from, done, result, apart] = ['.summary', '.from', '.done', '.result', '.apart'].map(name => place.querySelector(name));
    const [list, folded] = place.querySelectorAll('.findings');
    const most = Number(place.dataset.proofread), example = area.value;
    // How long nobody types before the text is checked, in milliseconds.
    const pause = 250;
    let timer, last, asked = 0, extension = '';

    const element = (name, text, attributes = {}) => {
        const made = document.createElement(name);
        made.textContent = text;
        Object.entries(attributes).forEach(pair => made.setAttribute(...pair));
        return made;
    };
    const say = (sentences, wrong = false) => {
        summary.classList.toggle('wrong', wrong);
        // What stands already is not read out again.
        if (sentences.join() !== [...summary.children].map(of => of.textContent).join()) {
            summary.replaceChildren(...sentences.map(sentence => element('p', sentence)));
        }
    };

    const link = ({ line, column, from, to }) => element('a', `line ${line}, column ${column}`, {
        href: `#${area.id}`, 'data-from': from, 'data-to': to,
    });
    const found = ({ list, verdict, chain: [before, marked, after], facts, others, more, ...at }) => {
        const item = element('li', '', { 'data-list': list });
        const head = element('p', '', { class: 'where' });
        head.append(link(at), ': ', element('strong', verdict));
        const chain = element('p', '', { class: 'chain' }), shown = element('samp', before);
        shown.append(element('mark', marked), after);
        chain.append(shown);
        const told = element('dl', '');
        for (const { label, text } of facts) {
            const pair = element('div', '');
            pair.append(element('dt', label), ' ', element('dd', text));
            told.append(pair);
        }
        if (others.length > 0) {
            const pair = element('div', ''), places = element('dd', '');
            places.append(...others.flatMap((of, index) => index > 0 ? ['; ', link(of)] : [link(of)]), more > 0 ? `; and ${more} more` : '');
            pair.append(element('dt', 'also'), ' ', places);
            told.append(pair);
        }
        item.append(head, chain, told);
        return item;
    };
    const show = answer => {
        last = answer;
        say(answer.error === undefined ? answer.summary : [answer.error], answer.error !== undefined);
        // What is less certain is folded.
        const isFolded = ({ list }) => list === 'less-certain';
        const all = answer.findings ?? [];
        list.replaceChildren(...all.filter(of => !isFolded(of)).map(found));
        folded.replaceChildren(...all.filter(isFolded).map(found));
        apart.hidden = !folded.hasChildNodes();
        apart.firstElementChild.textContent = answer.less_certain ?? '';
    };
    const refuse = why => show({ error: why });

    const question = hints =>
        `format=${format.value} extension=${extension} bindings=${bindings.value} units=${units.checked ? 'yes' : 'no'} ` +
        `doubts=${doubts.checked ? 'yes' : 'no'} hints=${hints}\n${area.value}`;
    // First without hints, which take longer than all the rest, and then with them.
    const check = async () => {
        clearTimeout(timer);
        const mine = ++asked;
        done.textContent = '';
        if (area.value.length > most) {
            return refuse(place.dataset.proofreadRefusal);
        }
        if (area.value.trim() === '') {
            show({ summary: ['Paste a text, or drop a file anywhere on this page.'], findings: [] });
            return;
        }
        place.setAttribute('aria-busy', 'true');
        try {
            const answer = JSON.parse(await ask(question('no')));
            if (mine !== asked) {
                return;
            }
            show(answer);
            if (answer.findings?.length) {
                try {
                    const hinted = JSON.parse(await ask(question('yes')));
                    if (mine === asked) {
                        show(hinted);
                    }
                } catch (error) {
                    if (mine === asked) {
                        say([...answer.summary, `Hints could not be searched: ${error.message}.`]);
                    }
                }
            }
        } catch (error) {
            if (mine === asked) {
                refuse(`This text could not be checked here: ${error.message}. Give a part of it, or use the command.`);
            }
        } finally {
            if (mine === asked) {
                place.removeAttribute('aria-busy');
            }
        }
    };
    const soon = () => {
        clearTimeout(timer);
        timer = setTimeout(check, pause);
    };
    const put = (text, ending = '', words = '') => {
        area.value = text;
        area.scrollTop = 0;
        extension = ending;
        from.textContent = words;
        return check();
    };

    // A file is text in UTF-8, or in UTF-16 if its first bytes say so.
    const encoding = ([first, second]) =>
        first === 0xff && second === 0xfe ? 'utf-16le' : first === 0xfe && second === 0xff ? 'utf-16be' : 'utf-8';
    // A file's name as it can be shown: of a long one the end, and characters that change the direction of writing by their number.
    const shown = name => {
        const signs = [...name];
        const end = signs.length > 60 ? ['…', ...signs.slice(-59)] : signs;
        const words = sign => `\\u{${sign.codePointAt(0).toString(16)}}`;
        return end.join('').replace(/[\p{Cc}\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]/gu, words);
    };
    const read = async files => {
        const [one] = files;
        const name = shown(one.name);
        if (one.size > 2 * most) {
            from.textContent = '';
            return refuse(place.dataset.proofreadRefusal);
        }
        let text;
        try {
            const bytes = new Uint8Array(await one.arrayBuffer());
            text = new TextDecoder(encoding(bytes)).decode(bytes);
        } catch (error) {
            return refuse(`The file “${name}” could not be opened: ${error.message}. It may be a folder.`);
        }
        if (text.includes('\0')) {
            return refuse(`The file “${name}” is not text. Save it as text first, for example with pdftotext if it is a PDF.`);
        }
        const strange = text.split('\ufffd').length - 1;
        const words = [`From the file “${name}”.`];
        if (strange > 0) {
            words.push(`It is not all UTF-8, and ${strange} of its characters could not be read.`);
        }
        if (files.length > 1) {
            words.push('The other files were left out, because the page takes one at a time.');
        }
        return put(text, /\.([a-z0-9]{1,20})$/i.exec(one.name)?.[1] ?? '', words.join(' '));
    };

    const copied = async text => {
        try {
            await navigator.clipboard.writeText(text);
            return true;
        } catch {
            const aside = element('textarea', text);
            document.body.append(aside);
            aside.select();
            const isCopied = document.execCommand('copy');
            aside.remove();
            return isCopied;
        }
    };
    const actions = {
        file: () => file.click(),
        copy: async () => {
            if (!last) {
                await check();
            }
            const isCopied = await copied(last.text ?? `${last.error ?? last.summary.join('\n')}\n`);
            done.textContent = isCopied ? 'The result is in the clipboard.' : 'The browser does not let the page copy.';
        },
        clear: () => {
            put('');
            area.focus();
        },
        example: () => put(example),
    };
    form.addEventListener('click', event => actions[event.target.dataset.do]?.());
    form.addEventListener('submit', event => event.preventDefault());
    form.addEventListener('input', ({ target, inputType }) => {
        if (target === area) {
            // What is typed over a file is no longer of its kind only if nothing of it is left.
            if (area.value === '') {
                [extension, from.textContent] = ['', ''];
            }
            // Nobody waits for the end of a paste.
            inputType === 'insertFromPaste' ? check() : soon();
        }
    });
    form.addEventListener('change', ({ target }) => {
        if (target === file) {
            file.files.length && read(file.files);
            file.value = '';
        } else if (target !== area) {
            check();
        }
    });

    // A file that is dropped anywhere on the page is opened here, and the browser does not go to it.
    const hasFile = event => event.dataTransfer?.types.includes('Files');
    addEventListener('dragover', event => {
        if (hasFile(event)) {
            event.preventDefault();
            place.classList.add('over');
        }
    });
    addEventListener('dragleave', event => event.relatedTarget ?? place.classList.remove('over'));
    addEventListener('drop', event => {
        place.classList.remove('over');
        if (hasFile(event)) {
            event.preventDefault();
            event.dataTransfer.files.length && read(event.dataTransfer.files);
        }
    });

    // The place of a finding leads to the text, and selects it there.
    result.addEventListener('click', event => {
        const { from, to } = event.target.dataset;
        if (from !== undefined) {
            event.preventDefault();
            area.setSelectionRange(Number(from), Number(to));
            // A browser shows the selection when the text gets the focus.
            area.blur();
            area.focus();
        }
    });

    if (typeof WebAssembly === 'object' && typeof DecompressionStream === 'function') {
        area.readOnly = false;
        form.querySelector('.controls').hidden = false;
        form.querySelector('.without').hidden = true;
        // The module comes when somebody turns to the form, and the example warms it up, so that the first text is answered as fast as
        // any other.
        let warm;
        ['focusin', 'pointerenter', 'dragenter'].forEach(kind => form.addEventListener(kind, () => {
            warm ??= ask(`hints=no\n${example}`).catch(() => {});
        }, { once: true }));
        // A browser may bring back what was typed before the page was left.
        if (area.value !== area.defaultValue) {
            soon();
        }
    }
    // For tests, and for readers who want to ask from the console.
    globalThis.genevaProofread = ask;
})();
