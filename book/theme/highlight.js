// Colours for Rust, TOML and MIMIC, in place of highlight.js: the two calls that mdBook makes, for the three
// languages of this book. Text is wrapped where it stands, so lines that mdBook hides stay hidden.
const hljs = (() => {
    const word = words => new RegExp(`\\b(?:${words})\\b`, 'y');
    const rust = [
        ['comment', /\/\/[^\n]*|\/\*[^]*?\*\//y],
        ['string', /b?r(#*)"[^]*?"\1|b?"(?:\\[^]|[^"\\])*"|b?'(?:\\(?:u\{[^}]*\}|x..|.)|[^'\\\n])'/y],
        ['symbol', /'[a-z_]\w*/y],
        ['meta', /#!?\[[^\]\n]*\]/y],
        ['number', /\b\d[\d_]*(?:\.\d[\d_]*)?(?:e[+-]?\d+)?(?:[iuf](?:8|16|32|64|128|size))?\b/iy],
        ['keyword', word('as|async|await|break|const|continue|crate|dyn|else|enum|extern|fn|for|if|impl|in|let|loop|'
            + 'match|mod|move|mut|pub|ref|return|self|static|struct|super|trait|type|unsafe|use|where|while')],
        ['literal', word('true|false')],
        ['built_in', /\b[a-z_]\w*!(?=[([{])/y],
        ['type', /\b(?:[A-Z]\w*|bool|char|str|[iu](?:8|16|32|64|128|size)|f(?:32|64))\b/y],
        [null, /\w+/y],
    ];
    const toml = [
        ['comment', /#[^\n]*/y],
        ['section', /(?<=^|\n)\[[^\n]*\]/y],
        ['string', /"(?:\\.|[^"\\\n])*"|'[^'\n]*'/y],
        ['attr', /[\w.-]+(?=\s*=)/y],
        ['literal', word('true|false')],
        ['number', /[+-]?\d[\d._]*/y],
        [null, /\w+/y],
    ];
    const mimic = [
        ['comment', /(?<=^|\n)(?:[*/]|C\s)[^\n]*/y],
        ['number', /(?:\d+\.?\d*|\.\d+)(?:E[+-]?\d+)?(?!\w)/y],
        ['keyword', /(?:CON|PAR|FIN|HDR|OUT|PLO|SCA|ZER)(?=\()|DT(?:MIN|MAX)?(?=\s+=?\s*[.\d])|END(?=\s*(?:\n|$))/y],
        ['built_in', /[A-Z]{3}(?=\()/y],
        [null, /\w+/y],
    ];
    const languages = { rust, toml, mimic };

    function tokens(text, rules) {
        const found = [];
        for (let at = 0; at < text.length;) {
            let length = 1;
            for (const [kind, pattern] of rules) {
                pattern.lastIndex = at;
                const match = pattern.exec(text);
                if (match && match[0]) {
                    length = match[0].length;
                    if (kind) {
                        found.push({ kind, start: at, end: at + length });
                    }
                    break;
                }
            }
            at += length;
        }
        return found;
    }

    function colour(node, start, found) {
        const text = node.data;
        const pieces = document.createDocumentFragment();
        let at = 0;
        for (const token of found) {
            const from = Math.max(token.start - start, 0);
            const to = Math.min(token.end - start, text.length);
            if (from >= to) {
                continue;
            }
            const span = document.createElement('span');
            span.className = `hljs-${token.kind}`;
            span.textContent = text.slice(from, to);
            pieces.append(text.slice(at, from), span);
            at = to;
        }
        pieces.append(text.slice(at));
        node.replaceWith(pieces);
    }

    function highlightBlock(block) {
        const language = Object.keys(languages).find(name => block.classList.contains(`language-${name}`));
        if (!language) {
            return;
        }
        const found = tokens(block.textContent, languages[language]);
        const walker = document.createTreeWalker(block, NodeFilter.SHOW_TEXT);
        const nodes = [];
        while (walker.nextNode()) {
            nodes.push(walker.currentNode);
        }
        let start = 0;
        for (const node of nodes) {
            const length = node.data.length;
            colour(node, start, found);
            start += length;
        }
    }

    return { configure() {}, highlightBlock };
})();
