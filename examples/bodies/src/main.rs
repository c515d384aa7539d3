//! Builds the book on the leaflet into `target/bodies`.

use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let built = geneva_press::build(&geneva_example_bodies::BOOK, root, &root.join("../../target/bodies"))?;
    println!("{}", built.first_page.display());
    Ok(())
}
