// mdBook turns the chapter at the keys Left and Right. Inside something that scrolls or slides by these keys,
// a table, a long formula, a block of code, a control, they keep their own meaning.
document.body.addEventListener('keydown', event => {
    const own = '.compare, .listing, .table-wrapper, .display, .fig, pre, input, select';
    if ((event.key === 'ArrowLeft' || event.key === 'ArrowRight') && event.target.closest(own)) {
        event.stopPropagation();
    }
});

// What scrolls sideways can be reached by keyboard.
// The page of all claims sees to its own rows, of which it lays out only those on the screen.
const scrollable = () => document.querySelectorAll('main :is(.display, .form):not(.claims *)').forEach(element => {
    if (element.scrollWidth > element.clientWidth) {
        element.tabIndex = 0;
    }
});
scrollable();
addEventListener('resize', scrollable);
addEventListener('toggle', scrollable, true);

// A link to a fold opens it.
const openLinked = () => {
    const linked = document.getElementById(location.hash.slice(1));
    if (linked?.matches('main details')) {
        linked.open = true;
    }
};
openLinked();
addEventListener('hashchange', openLinked);

// A letter of a formula lights up its part in the nearest drawing that has it: under the pointer, at a tap, or by the row of
// letters that a button below the drawing opens, and which the Tab key reaches once.
const drawn = [...document.querySelectorAll('main .fig:has(svg [data-letter])')];
if (drawn.length > 0) {
    const parts = figure => [...figure.querySelectorAll('svg [data-letter]')];
    const light = (figure, letter) => parts(figure).forEach(part => part.classList.toggle('lit', part.dataset.letter === letter));
    const chosen = figure => figure.querySelector('.letters :checked').value;
    const known = new Set();

    drawn.forEach((figure, number) => {
        const letters = new Set(parts(figure).map(part => part.dataset.letter));
        const shown = ([stem, index]) => stem.replaceAll("'", '\u0307') + (index ? `<sub>${index}</sub>` : '');
        const button = letter => `<label><input type="radio" name="letters-${number}" value="${letter}"> <span>${letter ? shown(letter.split('_')) : 'none'}</span></label>`;
        const row = document.createElement('details');
        row.className = 'letters';
        row.innerHTML = `<summary>letters</summary><fieldset><legend>Show in the drawing:</legend>${['', ...letters].map(button).join('')}</fieldset>`;
        row.querySelector('input').checked = true;
        row.onchange = () => light(figure, chosen(figure));
        figure.insertBefore(row, figure.querySelector(':scope > figcaption'));
        letters.forEach(letter => known.add(letter));
    });

    // With its index and dots: r_b is another letter than r. A rate that no drawing shows lights up its angle. What is quoted
    // from a source has the source's letters.
    document.querySelectorAll('main math mi').forEach(mi => {
        if (mi.closest(':is(msub, msup, msubsup) > :nth-child(n + 2), .erratum, [popover], .compare')) {
            return;
        }
        let [element, name] = [mi, mi.textContent];
        for (let up = mi.parentElement; /^(mover|msu[bp]|msubsup)$/.test(up.localName); up = up.parentElement) {
            const second = up.children[1].textContent;
            name += { mover: { '˙': "'", '¨': "''" }[second] ?? '', msup: '' }[up.localName] ?? `_${second}`;
            element = up;
        }
        while (!known.has(name) && name.endsWith("'")) {
            name = name.slice(0, -1);
        }
        if (known.has(name)) {
            element.dataset.letter = name;
        }
    });

    const height = element => element.getBoundingClientRect().top + element.getBoundingClientRect().bottom;
    const away = (figure, letter) => Math.abs(height(figure.querySelector('svg')) - height(letter));
    const nearest = letter => drawn
        .filter(figure => figure.checkVisibility() && parts(figure).some(part => part.dataset.letter === letter.dataset.letter))
        .sort((one, other) => away(one, letter) - away(other, letter))[0];
    const touched = event => event.target.closest('math [data-letter]');
    let over;
    let figure;
    const point = letter => {
        over?.classList.remove('lit');
        figure && light(figure, chosen(figure));
        over = letter;
        figure = letter && nearest(letter);
        over?.classList.add('lit');
        figure && light(figure, letter.dataset.letter);
    };
    document.addEventListener('pointerover', event => point(event.pointerType === 'mouse' ? touched(event) : null));
    document.documentElement.addEventListener('pointerleave', () => point());
    document.addEventListener('click', event => {
        const letter = touched(event);
        const figure = letter && nearest(letter);
        if (figure) {
            const name = chosen(figure) === letter.dataset.letter ? '' : letter.dataset.letter;
            figure.querySelector(`.letters [value="${name}"]`).checked = true;
            light(figure, name);
        }
    });
}

// Where the window has room for it, the sections of the page stand beside the text. The list gives way to a table or a caption
// that needs its place.
const heads = [...document.querySelectorAll('main > h2[id] > a.header')];
if (heads.length > 2) {
    const main = document.querySelector('main');
    const list = document.createElement('nav');
    list.className = 'sections';
    list.setAttribute('aria-label', 'On this page');
    const entries = heads.map(head => {
        const link = head.cloneNode(true);
        link.removeAttribute('class');
        const item = document.createElement('li');
        item.append(link);
        return item;
    });
    const order = document.createElement('ol');
    order.append(...entries);
    list.append(order);
    main.after(list);

    const tables = '.tab, .compare, .listing, .table-wrapper';
    const parts = part => part.matches('.fig:not(.live)') ? [...part.children] : part.matches(tables) ? [...part.querySelectorAll('table')] : [part];
    let waits = false;
    const follow = () => {
        waits = false;
        const own = list.getBoundingClientRect();
        if (own.width === 0) {
            return;
        }
        const isUnder = part => {
            const { right, top, bottom } = part.getBoundingClientRect();
            return right > own.left && bottom > own.top && top < own.bottom;
        };
        list.classList.toggle('covered', [...main.children].flatMap(parts).some(isUnder));
        const at = heads.findLastIndex(head => head.getBoundingClientRect().top < 130);
        entries.forEach((item, k) => k === at ? item.firstChild.setAttribute('aria-current', 'true') : item.firstChild.removeAttribute('aria-current'));
    };
    const soon = () => {
        if (!waits) {
            waits = true;
            requestAnimationFrame(follow);
        }
    };
    addEventListener('scroll', soon, { passive: true });
    new ResizeObserver(soon).observe(main);
    document.fonts.ready.then(soon);
}

// After a jump upwards, the book's bar stands where the window was before, over text. Told of the same place again, it goes to the
// top of the window.
{
    const bar = document.querySelector('#mdbook-menu-bar');
    document.addEventListener('scroll', ({ isTrusted }) => {
        if (isTrusted && bar?.getBoundingClientRect().top > 0) {
            document.dispatchEvent(new Event('scroll'));
        }
    }, { passive: true });
}
