//! One wheel: its sizes, its times, its greatest speed and acceleration, or its drawing.

mod arguments;
mod record;
mod sheet;

pub use arguments::WheelArguments;

use arguments::WheelFormat;
use geneva_kinematics::wheel::Wheel;
use record::WheelRecord;

/// The wheel that is wanted, as it is wanted.
pub fn page(wanted: &WheelArguments) -> anyhow::Result<String> {
    let wheel = Wheel::with_pins(wanted.stations, wanted.pins)?;
    let record = WheelRecord::new(&wheel, wanted.rpm, wanted.crank_radius)?;
    match wanted.format {
        WheelFormat::Text => Ok(sheet::page(&record)),
        WheelFormat::Json => Ok(serde_json::to_string_pretty(&record)? + "\n"),
        WheelFormat::Csv => csv(&record),
        WheelFormat::Svg => Ok(standalone(&geneva_figures::stations::mechanism(&wheel).svg) + "\n"),
    }
}

fn csv(record: &WheelRecord) -> anyhow::Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.serialize(record)?;
    Ok(String::from_utf8(writer.into_inner()?)?)
}

/// The drawing with fixed colours: each custom property, which only a page can set and only a browser understands,
/// gives way to what stands behind it.
fn standalone(svg: &str) -> String {
    let mut parts = svg.split("var(--");
    let mut fixed = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once(')').and_then(|(property, rest)| Some((property.split_once(", ")?.1, rest))) {
            Some((colour, rest)) => fixed.extend([colour, rest]),
            None => fixed.extend(["var(--", part]),
        }
    }
    fixed
}

#[cfg(test)]
mod tests {
    use super::standalone;

    #[test]
    fn colours_of_the_page_give_way_to_their_fallbacks() {
        let svg = "<g fill=\"var(--a, #111)\" stroke=\"var(--b)\"><path stroke=\"var(--c, #222)\"/></g>";
        assert_eq!(standalone(svg), "<g fill=\"#111\" stroke=\"var(--b)\"><path stroke=\"#222\"/></g>");
        assert_eq!(standalone("<g/>"), "<g/>");
    }
}
