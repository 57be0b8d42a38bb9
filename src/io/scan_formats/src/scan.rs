// SPDX-License-Identifier: GPL-3.0-or-later
//! What the formats have in common: points come as rows of numbers, the first three of which are x, y and z.

/// The type of a column, by the numbers that the C header gives them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Kind {
    UInt8 = 0,
    Int16 = 1,
    UInt16 = 2,
    Int32 = 3,
    UInt32 = 4,
    Float32 = 5,
    Float64 = 6,
}

/// One number of every point beside its place.
#[derive(Clone, Debug)]
pub struct Column {
    pub name: String,
    pub kind: Kind,
}

impl Column {
    pub fn new(name: &str, kind: Kind) -> Self {
        Column { name: name.to_string(), kind }
    }
}

/// What a file tells of itself.
#[derive(Clone, Debug, Default)]
pub struct About {
    /// "LAZ 1.4, point format 7"
    pub format: String,
    /// Of the coordinates: "m"; empty where the file does not tell.
    pub unit: String,
    /// Points that the file announces, checked against its size.
    pub points: u64,
    pub columns: Vec<Column>,
}

/// Messages are sentences without the name of the file.
pub type Result<T> = std::result::Result<T, String>;

pub trait Scan {
    fn about(&self) -> &About;

    /// Appends at most `most` points to `rows`, 3 + columns numbers each; none at the end.
    fn read(&mut self, most: usize, rows: &mut Vec<f64>) -> Result<()>;
}

/// No file holds more points than this a byte: what announces more is made to fill the memory.
const MOST_POINTS_PER_BYTE: u64 = 64;

pub fn check_points(points: u64, bytes: usize) -> Result<()> {
    if points > MOST_POINTS_PER_BYTE.saturating_mul(bytes as u64) {
        return Err(format!(
            "announces {points} points, too many for its {bytes} bytes; the file is truncated or its count wrong"
        ));
    }
    Ok(())
}

/// The `N` bytes at `at`, where they are there.
pub fn bytes_at<const N: usize>(bytes: &[u8], at: u64) -> Result<[u8; N]> {
    usize::try_from(at)
        .ok()
        .and_then(|begin| bytes.get(begin..begin.checked_add(N)?))
        .and_then(|slice| slice.try_into().ok())
        .ok_or_else(|| "ends within its header; the file is truncated: copy it again".to_string())
}
