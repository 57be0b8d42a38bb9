// SPDX-License-Identifier: GPL-3.0-or-later
//! What the record of a LAS point holds beside the numbers that every reader takes: flags, and the extra bytes
//! that the record 4 of LASF_Spec describes (LAS 1.4 R15, tables 7, 16 and 24).

use crate::scan::{Column, Kind};
use las::Header;

/// Some bits of one byte of the record.
struct Flag {
    name: &'static str,
    byte: usize,
    shift: u8,
    mask: u8,
}

const fn flag(name: &'static str, byte: usize, shift: u8, mask: u8) -> Flag {
    Flag { name, byte, shift, mask }
}

/// Of the point formats 0 to 5.
const FLAGS: [Flag; 5] = [
    flag("scan_direction_flag", 14, 6, 1),
    flag("edge_of_flight_line", 14, 7, 1),
    flag("synthetic", 15, 5, 1),
    flag("key_point", 15, 6, 1),
    flag("withheld", 15, 7, 1),
];

/// Of the point formats 6 to 10.
const EXTENDED_FLAGS: [Flag; 7] = [
    flag("scan_direction_flag", 15, 6, 1),
    flag("edge_of_flight_line", 15, 7, 1),
    flag("synthetic", 15, 0, 1),
    flag("key_point", 15, 1, 1),
    flag("withheld", 15, 2, 1),
    flag("overlap", 15, 3, 1),
    flag("scanner_channel", 15, 4, 3),
];

/// A number among the extra bytes.
struct Extra {
    column: Column,
    byte: usize, // of the record
    data_type: u8,
    scale: f64,
    offset: f64,
}

/// All of a file, in the order of their columns.
pub struct Bits {
    flags: &'static [Flag],
    extras: Vec<Extra>,
    /// Extra bytes of a point that nothing describes.
    pub unknown: usize,
}

const DESCRIPTION_BYTES: usize = 192;
const MOST_EXTRAS: usize = 1000; // descriptions beyond are left out, as bytes that nothing describes

/// Size and kind of the data types 1 to 10; integers of 64 bits become doubles.
fn type_of(data_type: u8) -> Option<(usize, Kind)> {
    Some(match data_type {
        1 => (1, Kind::UInt8),
        2 => (1, Kind::Int16),
        3 => (2, Kind::UInt16),
        4 => (2, Kind::Int16),
        5 => (4, Kind::UInt32),
        6 => (4, Kind::Int32),
        7 | 8 => (8, Kind::Float64),
        9 => (4, Kind::Float32),
        10 => (8, Kind::Float64),
        _ => return None,
    })
}

fn double_at(bytes: &[u8], at: usize) -> f64 {
    bytes.get(at..at + 8).and_then(|b| b.try_into().ok()).map_or(0.0, f64::from_le_bytes)
}

/// The numbers of one description, which may be up to three of one type, and the bytes that they take.
fn described(description: &[u8], first: usize) -> (Vec<Extra>, usize) {
    let (code, options) = (description[2], description[3]);
    if code == 0 || code > 30 {
        return (Vec::new(), usize::from(options)); // of type 0: that many bytes without a meaning
    }
    let (data_type, count) = ((code - 1) % 10 + 1, usize::from((code - 1) / 10) + 1);
    let Some((size, kind)) = type_of(data_type) else { return (Vec::new(), 0) };
    let text: String = description[4..36].iter().take_while(|b| **b != 0).map(|b| char::from(*b)).collect();
    let name = if text.trim().is_empty() { "extra" } else { text.trim() };
    let (has_scale, has_offset) = (options & 8 != 0, options & 16 != 0);
    let extra = |i: usize| Extra {
        column: Column {
            name: if count == 1 { name.to_string() } else { format!("{name}_{i}") },
            kind: if has_scale || has_offset { Kind::Float64 } else { kind },
        },
        byte: first + i * size,
        data_type,
        scale: if has_scale { double_at(description, 112 + 8 * i) } else { 1.0 },
        offset: if has_offset { double_at(description, 136 + 8 * i) } else { 0.0 },
    };
    ((0..count).map(extra).collect(), count * size)
}

impl Extra {
    fn value(&self, record: &[u8]) -> f64 {
        let mut b = [0u8; 8];
        let size = type_of(self.data_type).map_or(0, |(size, _)| size);
        b[..size].copy_from_slice(&record[self.byte..self.byte + size]);
        let raw = match self.data_type {
            2 => f64::from(b[0] as i8),
            4 => f64::from(i16::from_le_bytes([b[0], b[1]])),
            6 => f64::from(i32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            8 => i64::from_le_bytes(b) as f64,
            9 => f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            10 => f64::from_le_bytes(b),
            _ => u64::from_le_bytes(b) as f64, // unsigned: the bytes beyond its size are 0
        };
        raw * self.scale + self.offset
    }
}

impl Bits {
    pub fn new(header: &Header) -> Self {
        let format = header.point_format();
        let (end, extra_bytes) = (usize::from(format.len()), usize::from(format.extra_bytes));
        let mut at = end - extra_bytes;
        let mut extras = Vec::new();
        let vlr = header.all_vlrs().find(|v| v.user_id == "LASF_Spec" && v.record_id == 4);
        let data: &[u8] = vlr.map_or(&[], |v| &v.data);
        for description in data.chunks_exact(DESCRIPTION_BYTES).take(MOST_EXTRAS) {
            let (numbers, size) = described(description, at);
            if size > end - at {
                break;
            }
            at += size;
            extras.extend(numbers);
        }
        let flags: &[Flag] = if format.is_extended { &EXTENDED_FLAGS } else { &FLAGS };
        let known: usize = extras.iter().filter_map(|e| type_of(e.data_type)).map(|(size, _)| size).sum();
        Bits { flags, extras, unknown: extra_bytes - known }
    }

    pub fn columns(&self) -> impl Iterator<Item = Column> + '_ {
        let flags = self.flags.iter().map(|f| Column::new(f.name, Kind::UInt8));
        flags.chain(self.extras.iter().map(|e| e.column.clone()))
    }

    /// Into `row`, which has room for one number a column.
    pub fn put(&self, record: &[u8], row: &mut [f64]) {
        let (flags, extras) = row.split_at_mut(self.flags.len());
        for (to, flag) in flags.iter_mut().zip(self.flags) {
            *to = f64::from(record[flag.byte] >> flag.shift & flag.mask);
        }
        for (to, extra) in extras.iter_mut().zip(&self.extras) {
            *to = extra.value(record);
        }
    }
}
