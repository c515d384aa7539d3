// The page of all claims: filters its rows, orders them, and shows what is known of a claim when a reader asks for it.
// Without this script every row is there, in the order of the sources.
(() => {
    'use strict';
    const form = document.querySelector('form.filter');
    const lists = [...document.querySelectorAll('.claims')];
    const rows = lists.flatMap(list => [...list.children].map(row => {
        const [kind, verdict, changes] = row.classList;
        row.querySelector('small').dataset.title = list.dataset.title;
        return { row, list, kind, verdict, changes, source: list.dataset.source, isMirrored: 'mirrored' in list.dataset, words: null };
    }));
    const isOfDocuments = ({ isMirrored }) => isMirrored;
    const chosen = ['source', 'verdict', 'kind'];

    // What changes most comes first. Each group has its own list, in front of the sources'.
    const groups = [
        ['Wrong, and a conclusion changes', of => of.verdict === 'wrong' && of.changes === 'conclusion'],
        ['Wrong, and a result changes', of => of.verdict === 'wrong' && of.changes === 'result'],
        ['Wrong, but no result or conclusion changes', of => of.verdict === 'wrong'],
        ['Wrong only in our copy', of => of.verdict === 'wrong-in-copy'],
        ['Open', of => of.verdict === 'open'],
        ['Right', () => true],
    ].map(([title, isIn]) => {
        const heading = document.createElement('div'), list = document.createElement('ul');
        heading.className = 'group';
        heading.setAttribute('role', 'heading');
        heading.setAttribute('aria-level', '2');
        heading.textContent = title;
        list.className = 'claims mixed';
        return { heading, list, isIn };
    });
    const first = lists[0].previousElementSibling;
    groups.forEach(({ heading, list }) => first.before(heading, list));
    for (const of of rows) {
        of.group = groups.find(({ isIn }) => isIn(of)).list;
    }

    /** Puts the rows in the order that is set. */
    let order;
    const arrange = () => {
        const { value } = form.elements.order;
        if (value !== order) {
            order = value;
            rows.forEach(of => (value === 'source' ? of.list : of.group).append(of.row));
        }
    };

    // What stands in the address: of a filter the fields that are set, of a claim its id.
    const address = () => decodeURIComponent(location.hash.slice(1));
    const isFilter = () => !location.hash.startsWith('#check:') && address().includes('=');

    /** Shows the rows that have all that is asked for. */
    const filter = () => {
        const words = form.elements.words.value.toLowerCase().split(/\s+/).filter(word => word);
        const wanted = chosen.map(name => [name, form.elements[name].value]).filter(([, value]) => value);
        // What is right as read is right, too.
        const has = (of, name, value) => of[name] === value || value === 'documents' && isOfDocuments(of) ||
            value === 'right' && of[name] === 'right-as-read';
        const isWanted = of => wanted.every(([name, value]) => has(of, name, value)) && words.every(word => of.words.includes(word));
        for (const of of rows) {
            of.words ??= of.row.textContent.toLowerCase();
            of.row.hidden = !isWanted(of);
        }
        for (const list of [...lists, ...groups.map(of => of.list)]) {
            const isEmpty = [...list.children].every(row => row.hidden);
            list.hidden = isEmpty;
            list.previousElementSibling.hidden = isEmpty;
        }
        // The totals of the book are of the documents that it mirrors.
        const shown = rows.filter(of => !of.row.hidden), inDocuments = shown.filter(isOfDocuments).length;
        const count = shown.length === rows.length ? `All ${shown.length} claims` : `${shown.length} of ${rows.length} claims`;
        const isMixed = inDocuments > 0 && inDocuments < shown.length;
        form.querySelector('output').value = isMixed
            ? `${count}: ${inDocuments} ${form.dataset.documents}, ${shown.length - inDocuments} elsewhere` : count;
    };

    /** Writes the filter into the address, so that it can be kept and sent. */
    const keep = () => {
        const set = [...new FormData(form)].filter(([, value]) => value);
        if (set.length > 0 || isFilter()) {
            history.replaceState(null, '', `#${new URLSearchParams(set)}`);
        }
    };

    /** Fills the form from the address. */
    const read = () => {
        const set = new URLSearchParams(location.hash.slice(1));
        for (const name of ['words', 'order', ...chosen]) {
            form.elements[name].value = set.get(name) ?? '';
        }
    };

    /** What scrolls sideways can be reached by keyboard. */
    const reach = inside => inside.querySelectorAll('.form, dd').forEach(element => {
        if (element.scrollWidth > element.clientWidth) {
            element.tabIndex = 0;
        }
    });
    document.querySelector('main').addEventListener('contentvisibilityautostatechange', event => {
        if (!event.skipped) {
            reach(event.target);
        }
    });

    /** What to type on a machine with Rust, to copy. */
    const command = text => {
        const line = document.createElement('p'), code = document.createElement('code'), button = document.createElement('button');
        code.textContent = text;
        button.type = 'button';
        button.textContent = 'Copy';
        button.setAttribute('aria-label', `Copy the command ${text}`);
        button.onclick = async () => {
            try {
                await navigator.clipboard.writeText(text);
                button.textContent = 'Copied';
            } catch {
                getSelection().selectAllChildren(code);
                button.textContent = 'Selected';
            }
        };
        line.className = 'command';
        line.append('With Rust: ', code, ' ', button);
        return line;
    };

    // What is known of each claim comes with a script of its own, once.
    let known;
    const waiting = new Set();
    const fill = body => {
        body.innerHTML = known[body.dataset.of];
        globalThis.genevaCheck?.(body, body.dataset.of);
        if (form.dataset.command) {
            body.append(command(form.dataset.command.replace('ID', body.dataset.of)));
        }
        body.removeAttribute('aria-busy');
    };
    globalThis.genevaDetails = details => {
        known = details;
        waiting.forEach(fill);
        waiting.forEach(reach);
        waiting.clear();
    };
    const ask = body => {
        if (known) {
            fill(body);
            reach(body);
            return;
        }
        if (waiting.size === 0) {
            const script = document.createElement('script');
            script.src = 'data/ledger-details.js';
            script.onerror = () => waiting.forEach(of => {
                of.textContent = 'The file data/ledger-details.js is missing: build the book again.';
                of.removeAttribute('aria-busy');
            });
            document.head.append(script);
        }
        waiting.add(body);
    };

    for (const { row } of rows) {
        const details = document.createElement('details');
        const summary = document.createElement('summary');
        const body = document.createElement('div');
        details.className = 'asked';
        summary.textContent = 'Details';
        summary.setAttribute('aria-label', `Details of ${row.id}`);
        body.dataset.of = row.id;
        body.setAttribute('aria-busy', 'true');
        details.append(summary, body);
        details.addEventListener('toggle', () => ask(body), { once: true });
        row.append(details);
    }

    /**
     * Brings a row to the top. Rows off the screen have estimated heights, and as those near it are laid out, it moves: so it is
     * brought there again until it keeps still, or until the reader scrolls.
     */
    const bring = row => {
        const reader = new AbortController();
        for (const type of ['wheel', 'touchmove', 'keydown', 'pointerdown']) {
            addEventListener(type, () => reader.abort(), { once: true, passive: true, signal: reader.signal });
        }
        let still = 0;
        const look = () => {
            if (reader.signal.aborted) {
                return;
            }
            const before = scrollY;
            row.scrollIntoView({ behavior: 'instant' });
            still = scrollY === before ? still + 1 : 0;
            if (still < 12) {
                requestAnimationFrame(look);
            } else {
                reader.abort();
            }
        };
        look();
    };

    /** Shows what the address asks for. */
    const follow = () => {
        if (isFilter()) {
            read();
            arrange();
            filter();
            return;
        }
        const target = document.getElementById(address());
        const row = target?.closest('.claims > li');
        if (target?.hidden) {
            // A section of a source is there only in the order of the sources.
            for (const name of ['words', ...chosen]) {
                form.elements[name].value = '';
            }
            form.elements.order.value = row ? order : 'source';
            arrange();
            filter();
            target.scrollIntoView();
        }
        if (row) {
            row.querySelector('.asked').open = true;
            bring(row);
        }
    };

    form.addEventListener('input', () => {
        arrange();
        filter();
        keep();
    });
    // When a form is reset, its fields change after this event.
    form.addEventListener('reset', () => setTimeout(() => {
        arrange();
        filter();
        keep();
    }));
    form.addEventListener('submit', event => event.preventDefault());
    addEventListener('hashchange', follow);
    form.hidden = false;
    arrange();
    filter();
    follow();
})();
