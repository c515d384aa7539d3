// What can be wrong with a page as a browser shows it. Each check answers with a list of {kind, at, what}: what kind of
// fault, at which element, and what is the matter with it. Numbers come last, so that lists of two widths compare.
'use strict';

const geneva = (() => {
    const main = () => document.querySelector('main');
    const isShown = element => element.checkVisibility({ visibilityProperty: true });

    /** An element by its place: the nearest identity above it and what leads from there. */
    const place = element => {
        const steps = [];
        for (let at = element; at && at !== document.body; at = at.parentElement) {
            if (at.id) {
                steps.unshift(`#${at.id}`);
                break;
            }
            const name = at.localName + [...at.classList].map(of => `.${of}`).join('');
            const alike = [...(at.parentElement?.children ?? [])].filter(of => of.localName === at.localName);
            steps.unshift(alike.length > 1 ? `${name}:nth-of-type(${alike.indexOf(at) + 1})` : name);
            if (at.localName === 'main') {
                break;
            }
        }
        return steps.length > 4 ? `${steps[0]} … ${steps.slice(-2).join(' > ')}` : steps.join(' > ');
    };
    const words = text => {
        const short = text.replace(/\s+/g, ' ').trim();
        return short.length > 40 ? `${short.slice(0, 39)}…` : short;
    };
    const fault = (kind, element, what) => ({ kind, at: element ? place(element) : 'page', what });

    const hide = () => document.documentElement.style.setProperty('display', 'none');
    const show = () => document.documentElement.style.removeProperty('display');

    /**
     * What some checks find. Before and after these the page is hidden: nothing is painted that nobody looks at, and what
     * changes its width and its colours lays it out once.
     */
    const shown = async (...checks) => {
        show();
        const found = [];
        for (const check of checks) {
            found.push(await check());
        }
        hide();
        return found;
    };

    /**
     * Opens everything that is folded, and waits for what is loaded then. What is off the screen is laid out, too. The page is
     * hidden until it is checked.
     *
     * What is asked for in a list of claims is made alike for all claims of a kind and a verdict: of these it opens the first,
     * and every one that shows formulas.
     */
    const unfold = async () => {
        hide();
        const looks = new Set();
        const isOpened = details => {
            const row = details.closest('.claims > li');
            if (!row || !details.matches('.asked')) {
                return true;
            }
            const isNew = !looks.has(row.className);
            looks.add(row.className);
            return isNew || row.matches('.corrected');
        };
        [...document.querySelectorAll('main details')].filter(isOpened).forEach(of => { of.open = true; });
        document.querySelectorAll('.claims > li').forEach(of => { of.style.contentVisibility = 'visible'; });
        await until(() => !document.querySelector('main details[open] > [aria-busy="true"]'));
    };

    /** Closes the list of chapters, as it is closed for one who comes with a narrow screen. */
    const closeList = () => {
        document.querySelector('#mdbook-sidebar-toggle-anchor:checked')?.click();
        // Or the next page would open without it.
        localStorage.removeItem('mdbook-sidebar');
        return [];
    };

    /** Opens it again. */
    const openList = () => {
        document.querySelector('#mdbook-sidebar-toggle-anchor:not(:checked)')?.click();
        return [];
    };

    /** What is wider than its box. `scrolling`: the elements that may be, since they scroll by design. */
    const tooWide = scrolling => {
        const found = [];
        const root = document.documentElement;
        if (root.scrollWidth > window.innerWidth) {
            found.push(fault('wide', null, `the page scrolls sideways, by ${root.scrollWidth - window.innerWidth} px`));
        }
        const boxes = [main(), ...main().querySelectorAll('*')].filter(of => of instanceof HTMLElement && isShown(of));
        const wide = boxes.filter(of => {
            const style = getComputedStyle(of);
            const isBox = !['inline', 'contents', 'none'].includes(style.display) && of.clientWidth > 1;
            return isBox && of.scrollWidth > of.clientWidth + 1 && !(scrolling && of.matches(scrolling));
        });
        // Only the innermost: what holds a box that is too wide is too wide itself.
        for (const of of wide.filter(of => !wide.some(other => other !== of && of.contains(other)))) {
            found.push(fault('wide', of, `“${words(of.textContent)}” is wider than its box, by ${of.scrollWidth - of.clientWidth} px`));
        }
        for (const of of boxes) {
            const hides = ['hidden', 'clip'].includes(getComputedStyle(of).overflowY);
            if (hides && of.clientHeight > 1 && of.scrollHeight > of.clientHeight + 1) {
                found.push(fault('cut', of, `“${words(of.textContent)}” is cut off below, by ${of.scrollHeight - of.clientHeight} px`));
            }
        }
        return found;
    };

    /** Drawings that are wider than their box, or leave the screen. */
    const drawings = () => {
        const found = [];
        for (const svg of main().querySelectorAll('svg')) {
            const [own, box] = [svg, svg.parentElement].map(of => of.getBoundingClientRect());
            const out = Math.max(-own.left, own.right - window.innerWidth, box.left - own.left, own.right - box.right);
            if (isShown(svg) && out > 1) {
                found.push(fault('wide', svg, `the drawing leaves its box, by ${Math.round(out)} px`));
            }
        }
        return found;
    };

    /**
     * Marks that a finger does not hit: less than so many pixels wide or high, but for what other marks take of them. And
     * controls that are smaller, with their label where they are in one, or leave the window.
     */
    const targets = size => {
        const found = [];
        for (const mark of main().querySelectorAll('.mark')) {
            if (!isShown(mark)) {
                continue;
            }
            mark.scrollIntoView({ block: 'center', behavior: 'instant' });
            const box = mark.getBoundingClientRect();
            const [x, y, far] = [(box.left + box.right) / 2, (box.top + box.bottom) / 2, size / 2 - 1];
            const hits = [[far, 0], [-far, 0], [0, far], [0, -far]].every(([right, down]) =>
                document.elementFromPoint(x + right, y + down)?.closest('.mark'));
            if (!hits) {
                found.push(fault('target', mark, `is smaller than ${size} px`));
            }
        }
        for (const control of main().querySelectorAll(':is(button, input, select, summary, textarea):not(.mark)')) {
            if (!isShown(control)) {
                continue;
            }
            const box = (control.closest('label') ?? control).getBoundingClientRect();
            // Half a pixel is rounding.
            if (box.width < size - 0.5 || box.height < size - 0.5) {
                found.push(fault('target', control, `is smaller than ${size} px`));
            }
            const out = Math.max(-box.left, box.right - window.innerWidth);
            if (out > 1) {
                found.push(fault('wide', control, `leaves the window, by ${Math.round(out)} px`));
            }
        }
        return found;
    };

    /** What scrolls sideways and is not reached by the keyboard, nor anything in it. */
    const scrollers = () => [...main().querySelectorAll('*')].filter(of => of instanceof HTMLElement && isShown(of)).filter(of =>
        ['auto', 'scroll'].includes(getComputedStyle(of).overflowX) && of.scrollWidth > of.clientWidth + 1
        && ![of, ...of.querySelectorAll('a[href], button, input, select, textarea, summary, [tabindex]')].some(at => at.tabIndex >= 0)
    ).map(of => fault('scroller', of, `“${words(of.textContent)}” scrolls, but takes no focus`));

    /** What may not break on paper and is higher than so many pixels. A drawing cannot break. */
    const unbroken = most => [...main().querySelectorAll('*')].filter(of => of instanceof HTMLElement && isShown(of)).filter(of =>
        getComputedStyle(of).breakInside === 'avoid' && of.offsetHeight > most
    ).map(of => fault('unbroken', of, `may not break, and leaves a sheet white, by ${of.offsetHeight} px`));

    /** What opens over the page when its button is pressed: whether it does, within the window, and fits its box. */
    const notes = () => {
        const found = [];
        for (const button of main().querySelectorAll('[popovertarget]')) {
            const note = document.getElementById(button.getAttribute('popovertarget'));
            button.click();
            if (!note?.matches(':popover-open')) {
                found.push(fault('note', button, 'opens nothing'));
                continue;
            }
            const box = note.getBoundingClientRect();
            const out = Math.max(-box.left, box.right - window.innerWidth);
            if (out > 1) {
                found.push(fault('note', note, `leaves the window, by ${Math.round(out)} px`));
            }
            if (note.scrollWidth > note.clientWidth + 1) {
                found.push(fault('note', note, `is wider than its box, by ${note.scrollWidth - note.clientWidth} px`));
            }
            note.hidePopover();
        }
        return found;
    };

    /** Where a character is shown, by its text and its place there. */
    const shownAt = (node, at) => {
        const range = document.createRange();
        range.setStart(node, at);
        range.setEnd(node, at + 1);
        return range.getBoundingClientRect();
    };

    /** Marks that begin a line, without the word that they mark, and numbers that end one, without their unit. */
    const parted = units => {
        const found = [];
        const isUnit = new RegExp(`(?<=[0-9])[ \\n\u00a0]+(?=(?:${units.join('|')})(?![\\p{L}\\p{N}/]))`, 'gu');
        const block = element => element.closest('p, li, td, th, dt, dd, figcaption, summary, h1, h2, h3, h4, main');
        const texts = document.createTreeWalker(main(), NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT);
        let before;
        while (texts.nextNode()) {
            const node = texts.currentNode;
            if (node instanceof Element) {
                const isMark = node.matches('.mark') && isShown(node) && before && block(node) === block(before[0].parentElement);
                if (isMark && node.getBoundingClientRect().bottom - 6 > shownAt(...before).bottom + 6) {
                    found.push(fault('parted', node, `a mark begins a line, without “${words(before[0].data.slice(-12))}”`));
                }
                continue;
            }
            if (!isShown(node.parentElement) || node.parentElement.closest('pre, code, svg, form, .mark, .note')) {
                continue;
            }
            const last = node.data.replace(/[\s\u2060]+$/, '').length - 1;
            before = last < 0 ? before : [node, last];
            for (const { index, 0: blanks } of node.data.matchAll(isUnit)) {
                const [number, unit] = [index - 1, index + blanks.length].map(at => shownAt(node, at));
                if (unit.top > number.bottom - 2) {
                    found.push(fault('parted', node.parentElement, `“${words(node.data.slice(Math.max(0, index - 8), index + 8))}” breaks before its unit`));
                }
            }
        }
        return found;
    };

    /** Whether a declaration changes the colours of what is shown, or how much of one covers another, and nothing of its size
     * or place. */
    const isOfColours = (name, value) => /^(?:color|color-scheme|background-[a-z-]+|fill|stroke|filter|opacity|box-shadow)$|-color$/.test(name)
        || /^--[\w-]+-share$/.test(name) && /^\d+%$/.test(value) || name.startsWith('--') && (CSS.supports('color', value) || CSS.supports('filter', value) || /^(?:light|dark)$/.test(value));

    /**
     * What a style changes, besides colours, between light and dark: the names of mdBook's themes are classes. So boxes that are
     * right in the one are right in the other.
     */
    const schemes = () => {
        const found = [];
        const look = (rules, isAlready) => {
            for (const rule of rules) {
                const isOne = isAlready || /prefers-color-scheme/.test(rule.media?.mediaText)
                    || /\.(?:light|rust|coal|navy|ayu)\b/.test(rule.selectorText);
                for (const name of isOne ? rule.style ?? [] : []) {
                    if (!isOfColours(name, rule.style.getPropertyValue(name).trim())) {
                        found.push({ kind: 'scheme', at: rule.selectorText, what: `sets ${name} for light or dark alone` });
                    }
                }
                look(rule.cssRules ?? [], isOne);
            }
        };
        for (const sheet of document.styleSheets) {
            try {
                look(sheet.cssRules, /prefers-color-scheme/.test(sheet.media.mediaText));
            } catch {
                found.push(fault('scheme', null, `a style cannot be read, ${sheet.href}`));
            }
        }
        for (const source of document.querySelectorAll('[media*="prefers-color-scheme"]:not(style, link, meta)')) {
            found.push(fault('scheme', source, 'shows something else in light or dark'));
        }
        return found;
    };

    const canvas = document.createElement('canvas').getContext('2d');

    /** The boxes of the ink of a label's pieces, on the screen. */
    const inked = label => {
        const pieces = [];
        const walker = document.createTreeWalker(label, NodeFilter.SHOW_TEXT);
        while (walker.nextNode()) {
            const node = walker.currentNode;
            if (!node.data.trim()) {
                continue;
            }
            const range = document.createRange();
            range.selectNodeContents(node);
            const style = getComputedStyle(node.parentElement);
            canvas.font = `${style.fontStyle} ${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
            const ink = canvas.measureText(node.data);
            const em = ink.fontBoundingBoxAscent + ink.fontBoundingBoxDescent;
            const matrix = label.getScreenCTM();
            const isUpright = Math.abs(matrix.b) < 1e-6;
            for (const box of range.getClientRects()) {
                if (isUpright) {
                    const scale = box.height / em;
                    const top = box.top + scale * (ink.fontBoundingBoxAscent - ink.actualBoundingBoxAscent);
                    const bottom = box.bottom - scale * (ink.fontBoundingBoxDescent - ink.actualBoundingBoxDescent);
                    pieces.push({ left: box.left, right: box.right, top, bottom });
                } else {
                    // Turned by a quarter: its em box lies sideways.
                    pieces.push({ left: box.left, right: box.right, top: box.top, bottom: box.bottom });
                }
            }
        }
        return pieces;
    };

    /** How far two boxes lie over each other, in the direction in which it is least. */
    const overlap = (a, b) =>
        Math.min(Math.min(a.right, b.right) - Math.max(a.left, b.left), Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));

    /** Labels of figures that are too small to be read, lie on one another, or are cut off. */
    const labels = (smallest, allowed) => {
        const found = [];
        for (const svg of main().querySelectorAll('svg')) {
            if (!isShown(svg)) {
                continue;
            }
            const texts = [...svg.querySelectorAll('text')].filter(of => isShown(of) && of.textContent.trim());
            const frame = svg.getBoundingClientRect();
            const small = new Map();
            for (const text of texts) {
                const matrix = text.getScreenCTM();
                const scale = Math.sqrt(Math.abs(matrix.a * matrix.d - matrix.b * matrix.c));
                for (const part of [text, ...text.querySelectorAll('tspan')]) {
                    const own = [...part.childNodes].filter(of => of.nodeType === Node.TEXT_NODE).map(of => of.data).join('');
                    const size = parseFloat(getComputedStyle(part).fontSize) * scale;
                    if (own.trim() && size < smallest - 0.01) {
                        const key = size.toFixed(1);
                        small.set(key, [...(small.get(key) ?? []), words(own)]);
                    }
                }
            }
            for (const [size, names] of small) {
                const some = names.slice(0, 3).map(of => `“${of}”`).join(', ');
                const rest = names.length > 3 ? ` and ${names.length - 3} more` : '';
                found.push(fault('small', svg, `${some}${rest}: letters of ${size} px`));
            }
            const inks = texts.map(text => inked(text));
            texts.forEach((text, at) => {
                const out = Math.max(...inks[at].map(of => Math.max(
                    frame.left - of.left, of.right - frame.right, frame.top - of.top, of.bottom - frame.bottom)));
                if (out > allowed && getComputedStyle(svg).overflow !== 'visible') {
                    found.push(fault('cut', svg, `“${words(text.textContent)}” leaves its figure, by ${out.toFixed(1)} px`));
                }
                for (let other = 0; other < at; other += 1) {
                    const depth = Math.max(...inks[at].flatMap(a => inks[other].map(b => overlap(a, b))));
                    if (depth > allowed) {
                        const pair = `“${words(texts[other].textContent)}” and “${words(text.textContent)}”`;
                        found.push(fault('overlap', svg, `${pair} overlap, by ${depth.toFixed(1)} px`));
                    }
                }
            });
        }
        return found;
    };

    /** What can be pressed or filled in and is not reached by the keyboard, or does not show that it is. */
    const keyboard = () => {
        const found = [];
        const controls = 'a[href], button, summary, input, select, textarea, [tabindex], [onclick], [role="button"]';
        const look = style => [style.outlineStyle, style.outlineWidth, style.outlineColor, style.boxShadow, style.borderColor,
            style.backgroundColor, style.textDecoration].join();
        const kinds = new Set();
        for (const control of main().querySelectorAll(controls)) {
            if (!isShown(control) || control.disabled) {
                continue;
            }
            if (control.tabIndex < 0) {
                found.push(fault('keyboard', control, `“${words(control.textContent)}” is not reached by the Tab key`));
                continue;
            }
            // One of each kind: those in the same places of the page have the same styles.
            const kind = place(control).replace(/#[^ ]*|:nth-of-type\(\d+\)/g, '');
            if (kinds.has(kind) && !control.id) {
                continue;
            }
            kinds.add(kind);
            const style = getComputedStyle(control);
            const before = look(style);
            control.focus({ preventScroll: true, focusVisible: true });
            if (document.activeElement !== control) {
                found.push(fault('keyboard', control, `“${words(control.textContent)}” takes no focus`));
            } else if (look(style) === before) {
                found.push(fault('keyboard', control, `“${words(control.textContent)}” does not show that it has the focus`));
            }
            control.blur();
        }
        return found;
    };

    /** Loads axe-core from where it is. */
    const load = address => new Promise((done, failed) => {
        const script = document.createElement('script');
        Object.assign(script, { src: address, onload: () => done(), onerror: failed });
        document.head.append(script);
    });

    const axeFinds = async (context, runOnly, options) => {
        const sparing = { preload: false, resultTypes: ['violations'], selectors: false, elementRef: true };
        const { violations } = await axe.run(context, { runOnly, ...options, ...sparing });
        // It takes a heading of a table that is a formula for an empty one, whatever its name: it does not read MathML.
        const isFormula = (id, { element }) => id === 'empty-table-header' && element.querySelector('math') && element.ariaLabel;
        return violations.flatMap(({ id, help, nodes }) => nodes.filter(node => !isFormula(id, node)).map(node => {
            const why = [...node.any, ...node.all, ...node.none].map(of => of.message)[0] ?? '';
            return fault(`axe ${id}`, node.element, `${help}; “${words(node.element.textContent)}”: ${why}`);
        }));
    };

    /** The looks or parts that were good on an earlier page. */
    const known = name => new Set(JSON.parse(localStorage.getItem(name) ?? '[]'));
    const learn = (name, all) => localStorage.setItem(name, JSON.stringify([...all]));

    /**
     * What axe-core finds, colours aside. Its time goes with the number of elements. So what it has no rule for is left out,
     * the parts of formulas, drawings and code; and of rows, paragraphs, items and figures that differ in their words and
     * in the names and sizes of their parts only, and are in the same place of a page, it sees one. The page is of no use afterwards.
     */
    const accessibility = async () => {
        // Where the page begins, its bar covers nothing that can be pressed.
        window.scrollTo({ top: 0, behavior: 'instant' });
        main().querySelectorAll('math, pre > code').forEach(of => { of.textContent = of.textContent; });
        main().querySelectorAll('svg > :not(title, desc)').forEach(of => of.remove());
        const words = />[^<]+</g;
        const names = / (id|href|src|title|for|name|value|width|height|viewBox|popovertarget|aria-(?:label|labelledby|describedby|controls)|data-[\w-]+)="[^"]+"/g;
        const around = of => of && of !== document.body ? `${around(of.parentElement)} ${of.localName}.${of.className}` : '';
        // What is small or scrolls on one screen is not on another.
        const parts = `good parts ${innerWidth}`;
        const seen = known(parts);
        const skipped = [];
        for (const part of document.querySelectorAll('tbody tr, main li, main p, main figure, nav li')) {
            const alike = `${around(part.parentElement)} ${part.outerHTML.replace(words, '>x<').replace(names, ' $1="x"')}`;
            (seen.has(alike) ? skipped : []).push(part);
            seen.add(alike);
        }
        skipped.forEach(of => of.remove());
        const tags = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];
        const found = await axeFinds(document, { type: 'tag', values: tags }, { rules: { 'color-contrast': { enabled: false } } });
        if (found.every(({ at }) => !/\b(?:tr|li|p|figure|nav)\b/.test(at))) {
            learn(parts, seen);
        }
        return found;
    };

    /** The numbers of a colour: red, green, blue, and how much of what is below it covers. */
    const colour = text => {
        const numbers = /^rgba?\(([^)]*)\)$/.exec(text)?.[1].split(/[ ,/]+/).map(Number);
        return numbers && [...numbers.slice(0, 3), numbers[3] ?? 1];
    };
    const over = ([r, g, b, share], below) => [r, g, b].map((part, k) => share * part + (1 - share) * below[k]);
    const luminance = parts => {
        const [r, g, b] = parts.map(part => part / 255).map(part => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };

    /**
     * Text too faint on its ground (WCAG 1.4.3). Where it may be, by the colours of the text and of what is behind it, axe-core
     * says whether it is: it takes its time.
     */
    const contrast = async () => {
        const looks = new Map();
        const grounds = new Map();
        // The colour behind an element, or null where there is more than colours.
        const ground = element => {
            if (!element) {
                return [255, 255, 255];
            }
            if (!grounds.has(element)) {
                const { backgroundColor, backgroundImage, opacity } = getComputedStyle(element);
                const [own, below] = [colour(backgroundColor), ground(element.parentElement)];
                const isPlain = own && below && backgroundImage === 'none' && opacity === '1';
                grounds.set(element, isPlain ? over(own, below) : null);
            }
            return grounds.get(element);
        };
        for (const element of document.body.querySelectorAll('*')) {
            const hasText = [...element.childNodes].some(of => of.nodeType === Node.TEXT_NODE && of.data.trim());
            if (!hasText || !isShown(element)) {
                continue;
            }
            const { color, fontSize, fontWeight } = getComputedStyle(element);
            const [text, behind, size] = [colour(color), ground(element), parseFloat(fontSize)];
            const needed = size >= 24 || size >= 18.66 && fontWeight >= 700 ? 3 : 4.5;
            if (text && behind) {
                const [low, high] = [over(text, behind), behind].map(luminance).sort((a, b) => a - b);
                if ((high + 0.05) / (low + 0.05) > needed + 0.01) {
                    continue;
                }
            }
            looks.set([color, fontSize, fontWeight, behind ?? place(element)].join('|'), element);
        }
        const good = known('good looks');
        const doubtful = [...looks].filter(([look]) => !good.has(look));
        if (doubtful.length === 0) {
            return [];
        }
        const include = doubtful.map(([, element]) => element);
        const found = await axeFinds({ include }, { type: 'rule', values: ['color-contrast'] });
        if (found.length === 0) {
            learn('good looks', [...good, ...looks.keys()]);
        }
        return found;
    };

    /** A colour that a style sheet mixes, as `colour` reads it. */
    const mixed = text => {
        const parts = /^color\(srgb ([^)]*)\)$/.exec(text)?.[1].split(/[ /]+/).map(Number);
        return parts ? [...parts.slice(0, 3).map(part => 255 * part), parts[3] ?? 1] : colour(text);
    };

    /** The faces of a drawing that are seen through or are of the page's colour, and how much each covers. */
    const faces = svg => [...svg.querySelectorAll('path, circle')].flatMap(face => {
        const { fill, fillOpacity } = getComputedStyle(face);
        let share = mixed(fill)?.[3] * fillOpacity;
        for (let at = face; at !== svg; at = at.parentElement) {
            share *= getComputedStyle(at).opacity;
        }
        // What is seen from its edge has no width, and covers nothing.
        const matrix = face.getScreenCTM();
        const isSeen = share > 0 && matrix.a * matrix.d !== matrix.b * matrix.c;
        return isSeen ? [{ face, parts: [...mixed(fill).slice(0, 3), share], inverse: matrix.inverse() }] : [];
    });

    /** The colour of the page behind an element: the nearest that covers all. */
    const behind = element => {
        const own = mixed(getComputedStyle(element).backgroundColor);
        return own?.[3] === 1 ? own.slice(0, 3) : element.parentElement ? behind(element.parentElement) : [255, 255, 255];
    };

    /** Labels of figures whose halo has another colour than what is below most of the label. */
    const halos = () => {
        const found = [];
        for (const svg of main().querySelectorAll('svg')) {
            const texts = isShown(svg) ? [...svg.querySelectorAll('text')].filter(of => getComputedStyle(of).stroke !== 'none') : [];
            const [page, below] = [behind(svg), texts.length > 0 ? faces(svg) : []];
            for (const text of texts) {
                const halo = mixed(getComputedStyle(text).stroke);
                const box = text.getBoundingClientRect();
                const grounds = new Map();
                for (let k = 0; halo && k < 35; k += 1) {
                    const [x, y] = [box.left + box.width * (k % 7) / 6, box.top + box.height * (0.2 + 0.6 * Math.floor(k / 7) / 4)];
                    const isIn = ({ face, inverse }) => face.isPointInFill(new DOMPoint(x, y).matrixTransform(inverse));
                    const key = below.filter(isIn).reduce((ground, { parts }) => over(parts, ground), page).map(Math.round).join();
                    grounds.set(key, (grounds.get(key) ?? 0) + 1);
                }
                const [most, count] = [...grounds].sort(([, a], [, b]) => b - a)[0] ?? ['', 0];
                const ground = most.split(',').map(Number);
                const off = halo && count > 21 && Math.max(...over(halo, ground).map((part, k) => Math.abs(part - ground[k])));
                if (off > 3) {
                    found.push(fault('halo', svg, `“${words(text.textContent)}” has a halo unlike what is below it`));
                }
            }
        }
        return found;
    };

    /** What a reader can read: how many formulas, drawings, tables are shown, and the words. What moves a figure or lights up a
     * part of it, what filters, and what is asked for, which has its test, are no reading. */
    const content = () => {
        const aside = 'button, .buttons, .take, form, details.letters, .asked';
        const isContent = of => !of.closest(aside) && isShown(of);
        const count = name => [...main().querySelectorAll(name)].filter(isContent).length;
        const counts = ['math', 'svg', 'table', 'img', 'pre', 'p', 'li', 'td'].map(name => `${count(name)} ${name}`).join(', ');
        const text = main().cloneNode(true);
        text.querySelectorAll(aside).forEach(of => of.remove());
        return { counts, text: text.textContent.replace(/\s+/g, ' ').trim() };
    };

    return { unfold, show, shown, schemes, closeList, openList, tooWide, drawings, targets, scrollers, unbroken, notes, labels, halos, parted, keyboard, load, accessibility, contrast, content };
})();
