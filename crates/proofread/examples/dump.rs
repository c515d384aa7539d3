//! dump
use proofread::*;
fn main() {
    let follow = match std::env::var("FOLLOW").as_deref() {
        Ok("always") => Follow::Always,
        Ok("once") => Follow::Once,
        _ => Follow::Never,
    };
    let mut all = Tally::default();
    for path in std::env::args().skip(1) {
        let text = std::fs::read_to_string(&path).unwrap();
        let f = Format::of_extension(path.rsplit('.').next().unwrap()).unwrap_or(Format::Plain);
        let r = proofread(&text, f, Options { follow, agreeing: std::env::var_os("ALL").is_some() }).unwrap();
        all.add(&r.tally);
        for x in r.findings {
            let line = text[..x.at.start as usize].matches('\n').count() + 1;
            println!(
                "{path}:{line}\t{}\t{}\t{}\t{}\t{}\t{:?}\t{:?}\t{:?}",
                x.list.name(),
                x.verdict.name(),
                x.chain,
                x.left,
                x.right,
                x.recomputed,
                x.hint.map(|h| h.words),
                x.names
            );
        }
    }
    eprintln!("{all:?}");
}
