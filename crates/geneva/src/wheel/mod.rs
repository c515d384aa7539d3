//! One wheel: its sizes, its times, its greatest speed and acceleration, or its drawing.

mod arguments;
mod record;
mod sheet;

pub use arguments::WheelArguments;

use crate::sheet::standalone;
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
