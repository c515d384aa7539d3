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

// A letter of a formula lights up its part in the nearest drawing that has it: under the pointer, at a tap, or by the row of
// letters below the drawing, which the Tab key reaches once.
const drawn = [...document.querySelectorAll('main .fig')].filter(figure => figure.querySelector('svg [data-letter]'));
if (drawn.length > 0) {
    const parts = figure => [...figure.querySelectorAll('svg [data-letter]')];
    const letters = figure => [...new Set(parts(figure).map(part => part.dataset.letter))];
    const light = (figure, letter) => parts(figure).forEach(part => part.classList.toggle('lit', part.dataset.letter === letter));
    const chosen = figure => figure.querySelector('.letters :checked').value;

    drawn.forEach((figure, number) => {
        const row = document.createElement('fieldset');
        row.className = 'letters';
        row.append(Object.assign(document.createElement('legend'), { textContent: 'Show in the drawing' }));
        for (const letter of ['', ...letters(figure)]) {
            const [label, button] = ['label', 'input'].map(name => document.createElement(name));
            Object.assign(button, { type: 'radio', name: `letters-${number}`, value: letter, checked: !letter });
            label.append(button, letter.replaceAll("'", '\u2032').replace('_', '\u200a') || 'no letter');
            row.append(label);
        }
        row.addEventListener('change', () => light(figure, chosen(figure)));
        figure.insertBefore(row, figure.querySelector(':scope > figcaption'));
    });

    // With its index and dots: r_b is another letter than r. A rate that no drawing shows lights up its angle. What is quoted
    // from a source has the source's letters.
    const inside = ':is(msub, msup, msubsup) > :nth-child(n + 2)';
    const quoted = '.erratum, [popover], .compare';
    const known = new Set(drawn.flatMap(letters));
    document.querySelectorAll(`main math mi:not(${inside}, ${inside} *)`).forEach(mi => {
        if (mi.closest(quoted)) {
            return;
        }
        let [element, name] = [mi, mi.textContent];
        for (let up = mi.parentElement; /^(mover|msu[bp]|msubsup)$/.test(up.localName); element = up, up = up.parentElement) {
            const second = up.children[1].textContent;
            name += up.localName === 'mover' ? { '\u02d9': "'", '\u00a8': "''" }[second] ?? '' : up.localName === 'msup' ? '' : `_${second}`;
        }
        while (!known.has(name) && name.endsWith("'")) {
            name = name.slice(0, -1);
        }
        if (known.has(name)) {
            element.dataset.letter = name;
        }
    });

    const middle = element => (element.getBoundingClientRect().top + element.getBoundingClientRect().bottom) / 2;
    const nearest = letter => drawn
        .filter(figure => figure.querySelector('svg').getClientRects().length && letters(figure).includes(letter.dataset.letter))
        .map(figure => [Math.abs(middle(figure.querySelector('svg')) - middle(letter)), figure])
        .sort(([one], [other]) => one - other)[0]?.[1];
    const touched = event => event.target.closest('math [data-letter]');
    let over;
    const point = letter => {
        over?.letter.classList.remove('lit');
        over?.figure && light(over.figure, chosen(over.figure));
        over = letter ? { letter, figure: nearest(letter) } : undefined;
        over?.letter.classList.add('lit');
        over?.figure && light(over.figure, letter.dataset.letter);
    };
    document.addEventListener('pointerover', event => point(event.pointerType === 'mouse' && touched(event)));
    document.documentElement.addEventListener('pointerleave', () => point());
    document.querySelector('main').addEventListener('click', event => {
        const letter = touched(event);
        const figure = letter && nearest(letter);
        if (figure) {
            const again = chosen(figure) === letter.dataset.letter;
            figure.querySelectorAll('.letters input').forEach(button => {
                button.checked = button.value === (again ? '' : letter.dataset.letter);
            });
            light(figure, chosen(figure));
        }
    });
}
