// SPDX-License-Identifier: GPL-3.0-or-later
//! The unit of the coordinates, as the reference system of a LAS file names it.

use las::Header;

const PROJECTION: &str = "LASF_Projection";
const WKT_RECORD: u16 = 2112;
const GEO_KEYS_RECORD: u16 = 34735;
const MODEL_KEY: u16 = 1024;
const LINEAR_UNITS_KEY: u16 = 3076;

/// The first UNIT that is no angle: "metre" of a projected system.
fn of_wkt(wkt: &str) -> String {
    let mut rest = wkt;
    let mut angle = false;
    while let Some(at) = rest.find("UNIT[\"") {
        rest = &rest[at + 6..];
        let name = rest.split('"').next().unwrap_or("").to_lowercase();
        if name.contains("degree") || name.contains("radian") || name.contains("unity") {
            angle = true;
        } else {
            return short(&name);
        }
    }
    if angle {
        "degrees".into()
    } else {
        String::new()
    }
}

fn short(name: &str) -> String {
    match name {
        "metre" | "meter" | "m" => "m".into(),
        "foot" | "feet" | "international foot" | "ft" => "ft".into(),
        "us survey foot" | "us survey feet" | "foot_us" | "ftus" => "US survey ft".into(),
        _ => name.chars().filter(|c| !c.is_control()).take(40).collect(),
    }
}

/// Keys are four numbers each, after a head of four: id, place (0: here), count, value.
fn of_geo_keys(data: &[u8]) -> String {
    let numbers: Vec<u16> = data.chunks_exact(2).map(|b| u16::from_le_bytes([b[0], b[1]])).collect();
    let key =
        |wanted: u16| numbers.chunks_exact(4).skip(1).find(|k| k[0] == wanted && k[1] == 0).map(|k| k[3]);
    match (key(LINEAR_UNITS_KEY), key(MODEL_KEY)) {
        (Some(9001), _) => "m".into(),
        (Some(9002), _) => "ft".into(),
        (Some(9003), _) => "US survey ft".into(),
        (None, Some(2)) => "degrees".into(),
        _ => String::new(),
    }
}

pub fn of_las(header: &Header) -> String {
    let record = |id: u16| header.all_vlrs().find(|v| v.user_id == PROJECTION && v.record_id == id);
    if let Some(vlr) = record(WKT_RECORD) {
        let unit = of_wkt(&String::from_utf8_lossy(&vlr.data));
        if !unit.is_empty() {
            return unit;
        }
    }
    record(GEO_KEYS_RECORD).map(|vlr| of_geo_keys(&vlr.data)).unwrap_or_default()
}
