//! Builds the book on the section into `target/drag`.

use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let built = geneva_press::build(&geneva_example_drag::BOOK, root, &root.join("../../target/drag"))?;
    println!("{}", built.first_page.display());
    Ok(())
}
