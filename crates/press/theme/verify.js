// Lets a reader have claims checked in this page. It only puts the buttons; what they need comes with the first touch.
(() => {
    let panel;
    const load = () => panel ??= new Promise((done, failed) => {
        const style = document.createElement('link');
        style.rel = 'stylesheet';
        style.href = 'data/verify.css';
        const script = document.createElement('script');
        script.src = 'data/verify-panel.js';
        script.onload = () => done(globalThis.genevaVerify);
        script.onerror = () => failed(new Error('a file of the book is missing: data/verify-panel.js'));
        document.head.append(style, script);
    });
    const run = async (button, act) => {
        button.setAttribute('aria-busy', 'true');
        try {
            act(await load());
        } catch (error) {
            panel = undefined;
            const told = document.createElement('p');
            told.className = 'verify-failed';
            told.textContent = `Nothing can be checked here: ${error.message}.`;
            document.querySelector('.verify-failed')?.remove();
            button === main ? main.prepend(told) : button.after(told);
        }
        button.removeAttribute('aria-busy');
    };
    const put = (place, words, act, before) => {
        const button = document.createElement('button');
        button.type = 'button';
        button.className = 'verify';
        button.style.cssText = 'font: inherit; padding: 0.3em 0.8em';
        button.textContent = words;
        button.onclick = () => run(button, act);
        const row = document.createElement('div');
        row.append(button);
        place.insertBefore(row, before ?? null);
    };
    // Of one claim: in its note, and in its row of the ledger.
    const ofClaim = (place, id) => put(place, 'Check this here', ({ one }) => one(id));
    globalThis.genevaCheck = ofClaim;
    const notes = [...document.querySelectorAll('.note[popover]')];
    const idOf = note => note.id.slice('note-'.length);
    for (const note of notes) {
        note.addEventListener('beforetoggle', () => ofClaim(note, idOf(note)), { once: true });
    }
    // Of the page, or of everything.
    const rows = [...document.querySelectorAll('.claims > li')];
    const main = document.querySelector('main');
    const start = document.querySelector('[data-verify-all]');
    const filter = document.querySelector('form.filter');
    const all = place => put(place, 'Check everything', ({ many }) => many());
    if (start) {
        all(start);
    } else if (rows.length > 0 && filter) {
        all(filter);
    } else if (notes.length > 0) {
        const words = notes.length === 1 ? 'Check this page: 1 claim' : `Check this page: ${notes.length} claims`;
        put(main, words, ({ many }) => many(notes.map(idOf)), main.querySelector(':scope > .beside'));
    }
    // A spoiling that is prepared, and one that an address carries: the id of the claim, and the characters behind a colon.
    document.addEventListener('click', event => {
        const link = event.target.closest?.('a[data-verify]');
        if (link) {
            event.preventDefault();
            run(link, ({ one }) => one(link.dataset.verify, link.dataset.characters));
        }
    });
    const follow = () => {
        const [, id, characters] = /^#check:([a-z0-9.-]{1,120})(?::(.*))?$/is.exec(location.hash) ?? [];
        if (id === undefined) {
            return;
        }
        let text;
        try {
            text = characters === undefined ? undefined : decodeURIComponent(characters);
        } catch {
            return;
        }
        run(main, ({ one }) => one(id, text));
    };
    addEventListener('hashchange', follow);
    follow();
})();
