// Searches the book. It takes the place of mdBook's script and uses its field and its list of results; the index loads with
// the first search. A file of this book, `crates/press/src/search.rs`, says what is searched and how much it weighs.
(() => {
    const part = id => document.getElementById(`mdbook-${id}`);
    const [wrapper, form, field, outer, head, list, toggle] = [
        'search-wrapper', 'searchbar-outer', 'searchbar', 'searchresults-outer', 'searchresults-header', 'searchresults', 'search-toggle',
    ].map(part);
    if (!wrapper || !toggle) {
        return;
    }
    const MOST = 20;
    // Words of a teaser.
    const WINDOW = 30;
    // Words that say nothing of what is asked for, unless all do.
    const EMPTY = new Set(('a about am an and any are as at be by can did do does for from get had has have how i if in into is it its ' +
        'me my of on or our so than that the their them then there these they this to was we were what when where which who why will ' +
        'with would you your').split(' '));

    const folded = text => text.toLowerCase().normalize('NFD').replace(/\p{M}/gu, '').replace(/['’]s\b/g, '');
    const WORD = /[\p{L}\p{N}]+(?:[.,]\p{N}+)*/gu;
    const words = text => folded(text).match(WORD) ?? [];
    // What the forms of a word have in common.
    const root = word => word.length > 4 && /(?:ies|y)$/.test(word) ? word.replace(/(?:ies|y)$/, 'i')
        : word.replace(/(?<=\p{L}{4})(?:ing|ed|es|e)$|(?<=\p{L}{2}[^sui])s$/u, '');

    // How alike two words are, from 0 to 1: a word that is being typed is like all that begin with it.
    const likeness = (typed, own, word, its) => word === typed ? 1
        : its === own ? 0.9
        : typed.length > 2 && word.startsWith(typed) ? 0.5 * typed.length / word.length : 0;
    // Whether one letter is wrong, missing, too much or swapped with the next.
    const isMistyped = (typed, word) => {
        const [short, long] = typed.length < word.length ? [typed, word] : [word, typed];
        if (short.length < 4 || long.length - short.length > 1 || /\p{N}/u.test(typed)) {
            return false;
        }
        let [from, to] = [0, 0];
        while (from < short.length && short[from] === long[from]) {
            from += 1;
        }
        while (to < short.length - from && short[short.length - 1 - to] === long[long.length - 1 - to]) {
            to += 1;
        }
        const [a, b] = [short.slice(from, short.length - to), long.slice(from, long.length - to)];
        return b.length < 2 || a.length === 2 && a[0] === b[1] && a[1] === b[0];
    };

    // The index as it is searched. Of each entry the file gives page, anchor, title, text, text that weighs little, and weight.
    const prepared = ({ title: book, pages, entries, synonyms }) => {
        const known = new Map();
        const count = (word, entry, kind, by) => {
            if (!known.has(word)) {
                known.set(word, { its: root(word), places: new Map() });
            }
            const { places } = known.get(word);
            if (!places.has(entry)) {
                places.set(entry, { text: 0, title: 0 });
            }
            const place = places.get(entry);
            place[kind] = kind === 'text' ? place.text + by : Math.max(place.title, by);
        };
        const all = entries.map(([page, id, title, text, little, weight], k) => {
            const [file, of] = pages[page];
            const [inTitle, inText] = [words(title), words(text)];
            inText.forEach(word => count(word, k, 'text', 1));
            words(little).forEach(word => count(word, k, 'text', 0.1));
            inTitle.forEach(word => count(word, k, 'title', 3));
            words(of).forEach(word => count(word, k, 'title', 0.8));
            const path = id ? `${of} » ${title}` : of;
            return {
                address: `${file}${id && '#'}${id}`, path, text: `${text} ${little}`.trim(), weight, length: inText.length,
                title: inTitle.join(' '), row: ` ${inText.join(' ')} `,
            };
        });
        const mean = all.reduce((sum, { length }) => sum + length, 0) / all.length;
        return {
            known, all, mean, likes: new Map(), common: new Set([...EMPTY, ...words(book)]),
            synonyms: synonyms.map(([typed, meant]) => [words(typed), meant.map(words)]),
        };
    };

    // Words of the index that are like a typed one, with their likeness.
    const alike = ({ known, likes }, typed) => {
        if (likes.has(typed)) {
            return likes.get(typed);
        }
        const own = root(typed);
        const found = [...known].map(([word, { its }]) => [word, likeness(typed, own, word, its)]).filter(([, like]) => like > 0);
        const mistyped = () => [...known.keys()].filter(word => isMistyped(typed, word)).map(word => [word, 0.5]);
        likes.set(typed, found.length > 0 ? found : mistyped());
        return likes.get(typed);
    };

    // What has these words: BM25 over the text, and more for a title. What lacks a word comes far behind.
    const scored = (index, reading, isTyped) => {
        const typed = asked(index, reading);
        const { all, known, mean } = index;
        const sums = new Map();
        for (const word of typed) {
            const found = new Map();
            for (const [near, like] of alike(index, word)) {
                for (const [k, { text, title }] of known.get(near).places) {
                    const sum = found.get(k) ?? { text: 0, title: 0 };
                    found.set(k, { text: sum.text + like * text, title: Math.max(sum.title, like * title) });
                }
            }
            const rare = Math.log(1 + (all.length - found.size + 0.5) / (found.size + 0.5));
            for (const [k, { text, title }] of found) {
                const score = rare * (2.2 * text / (text + 0.3 + 0.9 * all[k].length / mean) + title);
                const sum = sums.get(k) ?? { score: 0, count: 0 };
                sums.set(k, { score: sum.score + score, count: sum.count + 1 });
            }
        }
        const phrase = reading.join(' ');
        const pairs = typed.slice(1).map((word, k) => `${typed[k]} ${word}`);
        return new Map([...sums].map(([k, { score, count }]) => {
            const { title, row, weight } = all[k];
            // Words that stand side by side belong together.
            const together = pairs.reduce((sum, pair) => sum + (title.includes(pair) ? 1 : row.includes(pair) ? 0.5 : 0), 0);
            const exact = title === phrase ? 1000 : weight;
            return [k, score * exact * (1 + together / (pairs.length || 1) + (isTyped && reading.length > 1 && title.includes(phrase))) * (count / typed.length) ** 2];
        }));
    };

    // What was typed, and what it is called in the book. Of several words that are a name, none is meant by itself.
    const readings = ({ synonyms }, typed) => {
        const roots = typed.map(root);
        const at = of => roots.findIndex((_, k) => of.every((word, j) => root(word) === roots[k + j]));
        const known = synonyms.map(([of, meant]) => [of, meant, at(of)]).filter(([, , from]) => from >= 0);
        const others = known.flatMap(([of, meant, from]) =>
            meant.map(instead => [...typed.slice(0, from), ...instead, ...typed.slice(from + of.length)]));
        return known.some(([of]) => of.length > 1) ? others : [typed, ...others];
    };

    // The words that tell. Those of the book's title are in every chapter.
    const asked = (index, typed) => {
        const telling = typed.filter(word => !index.common.has(word));
        return telling.length > 0 ? telling : typed;
    };

    // The entries that answer, the best first.
    const found = (index, text) => {
        const best = new Map();
        const of = words(text);
        for (const reading of readings(index, of)) {
            const isTyped = reading === of;
            for (const [k, score] of scored(index, reading, isTyped)) {
                best.set(k, Math.max(best.get(k) ?? 0, isTyped ? score : 2 * score));
            }
        }
        const sorted = [...best].sort(([a, one], [b, other]) => other - one || a - b);
        return sorted.filter(([, score]) => score > 0.05 * sorted[0][1]).slice(0, MOST).map(([k]) => index.all[k]);
    };

    // The stretch of a text with most of the words, which stand out.
    const teaser = (text, typed) => {
        const roots = typed.map(root);
        const pieces = text.split(' ');
        const hits = pieces.map(piece => words(piece).some(word => typed.some((of, k) => likeness(of, roots[k], word, root(word)) > 0)));
        let [from, most, sum] = [0, 0, 0];
        hits.forEach((hit, k) => {
            sum += hit - (k >= WINDOW ? hits[k - WINDOW] : 0);
            if (sum > most) {
                [most, from] = [sum, Math.max(0, k - WINDOW + 1)];
            }
        });
        // It begins a little before the first word.
        const first = hits.indexOf(true, from);
        from = first < 0 ? 0 : Math.max(0, Math.min(first - 5, pieces.length - WINDOW));
        const shown = document.createElement('span');
        shown.className = 'teaser';
        pieces.slice(from, from + WINDOW).forEach((piece, k) => {
            const em = document.createElement(hits[from + k] ? 'em' : 'span');
            em.textContent = piece;
            shown.append(k > 0 ? ' ' : from > 0 ? '… ' : '', em);
        });
        shown.append(from + WINDOW < pieces.length ? ' …' : '');
        return shown;
    };

    let index;
    const row = (entry, text) => {
        const typed = asked(index, words(text));
        const link = document.createElement('a');
        const [file, id] = entry.address.split('#');
        link.href = `${path_to_root}${file}?highlight=${encodeURIComponent(typed.join(' '))}${id ? `#${id}` : ''}`;
        link.textContent = entry.path;
        const item = document.createElement('li');
        item.append(link, teaser(entry.text, typed));
        return item;
    };

    let shown = '';
    const say = text => head.textContent = text;
    const show = () => {
        const text = field.value.trim();
        if (text === '' || !index) {
            outer.classList.toggle('hidden', text === '');
            say(text === '' ? '' : 'Loading the index…');
            list.replaceChildren();
            shown = '';
            return;
        }
        if (text === shown) {
            return;
        }
        shown = text;
        const results = found(index, text);
        list.replaceChildren(...results.map(entry => row(entry, text)));
        const number = results.length === 1 ? '1 result' : results.length < MOST ? `${results.length} results` : `The best ${MOST} results`;
        say(results.length === 0 ? `Nothing in the book for “${text}”.` : `${number} for “${text}”`);
        outer.classList.remove('hidden');
    };

    // The file of the index calls this.
    globalThis.genevaIndex = json => {
        index = prepared(JSON.parse(json));
        form.classList.remove('searching');
        show();
    };
    let asking;
    const load = () => {
        if (asking) {
            return;
        }
        form.classList.add('searching');
        asking = document.createElement('script');
        asking.src = path_to_root + path_to_searchindex_js;
        asking.onerror = () => {
            asking.remove();
            asking = undefined;
            form.classList.remove('searching');
            outer.classList.remove('hidden');
            say('The search needs a file of the book that is missing: ' + path_to_searchindex_js);
        };
        document.head.append(asking);
    };

    const isOpen = () => !wrapper.classList.contains('hidden');
    const turn = open => {
        wrapper.classList.toggle('hidden', !open);
        toggle.setAttribute('aria-expanded', `${open}`);
    };
    const open = () => {
        turn(true);
        scrollTo(0, 0);
        field.focus();
        field.select();
        load();
    };
    // The address keeps what was searched for, so that the way back from a result leads to the others.
    const keep = name => {
        const address = new URL(location.href);
        ['search', 'highlight'].forEach(of => address.searchParams.delete(of));
        name && address.searchParams.set('search', name);
        history.replaceState(history.state, '', address);
    };
    const close = () => {
        const had = wrapper.contains(document.activeElement);
        turn(false);
        keep('');
        had && toggle.focus();
    };

    toggle.addEventListener('click', () => isOpen() ? close() : open());
    // Whatever puts words into the field tells it by this event: keys, a keyboard on the screen, pasting, dictating.
    field.addEventListener('input', show);
    form.addEventListener('submit', event => {
        event.preventDefault();
        show();
        list.querySelector('a')?.click();
    });
    list.addEventListener('click', event => event.target.closest('a') && keep(field.value.trim()));
    wrapper.addEventListener('keydown', event => {
        const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
        if (!step || event.altKey || event.ctrlKey || event.metaKey || event.shiftKey || event.isComposing) {
            return;
        }
        const places = [field, ...list.querySelectorAll('a')];
        const next = places[places.indexOf(document.activeElement) + step];
        if (next) {
            event.preventDefault();
            next.focus();
        }
    });
    document.addEventListener('keydown', event => {
        if (event.altKey || event.ctrlKey || event.metaKey || event.isComposing) {
            return;
        }
        if (event.key === 'Escape' && isOpen()) {
            close();
        } else if (event.key === 'Escape') {
            light('');
            keep('');
        } else if ((event.key === '/' || event.key === 's') && !event.target.closest?.('input, select, textarea')) {
            event.preventDefault();
            open();
        }
    });

    // On the page of a result, the words that were searched for stand out until Escape is pressed or the page is left.
    const light = text => {
        const typed = words(text).map(word => [word, root(word)]);
        globalThis.CSS?.highlights?.delete('searched');
        if (typed.length === 0 || !globalThis.Highlight) {
            return;
        }
        const ranges = [];
        const walker = document.createTreeWalker(document.querySelector('main'), NodeFilter.SHOW_TEXT);
        while (walker.nextNode()) {
            const node = walker.currentNode;
            for (const match of node.data.matchAll(WORD)) {
                if (typed.some(([word, own]) => words(match[0]).some(of => of === word || root(of) === own))) {
                    const range = document.createRange();
                    range.setStart(node, match.index);
                    range.setEnd(node, match.index + match[0].length);
                    ranges.push(range);
                }
            }
        }
        CSS.highlights.set('searched', new Highlight(...ranges));
    };

    field.setAttribute('aria-describedby', head.id);
    field.setAttribute('aria-label', 'Search this book');
    field.setAttribute('enterkeyhint', 'search');
    field.setAttribute('autocomplete', 'off');
    head.setAttribute('role', 'status');
    list.setAttribute('aria-label', 'Results');
    // mdBook's script for the page asks it whether keys are meant for the search.
    globalThis.search = { hasFocus: () => wrapper.contains(document.activeElement) };

    const come = () => {
        const address = new URLSearchParams(location.search);
        if (address.get('search')) {
            open();
            field.value = address.get('search');
            show();
        }
        light(address.get('highlight') ?? '');
    };
    come();
})();
