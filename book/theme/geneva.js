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
