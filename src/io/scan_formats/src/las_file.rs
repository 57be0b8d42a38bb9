// SPDX-License-Identifier: GPL-3.0-or-later
//! LAS 1.0 to 1.4, plain or compressed (LAZ, COPC). Chunks of LAZ are decoded one by one, each out of its own
//! bytes and after its sizes were compared with these.

use crate::las_bits::Bits;
use crate::laz_chunks::Chunks;
use crate::scan::{bytes_at, check_points, About, Column, Kind, Result, Scan};
use crate::units;
use las::PointDataBuilder;
use las::{Header, PointData};
use std::io::Cursor;

enum Records {
    Plain { next: u64 },
    Compressed(Box<Chunks>),
}

pub struct LasFile {
    bytes: &'static [u8],
    begin: usize,
    header: Header,
    record: usize,
    records: Records,
    bits: Bits,
    read: u64,
    about: About,
}

/// The crate reads an extended record of any announced length at once.
fn check_extended_records(bytes: &[u8]) -> Result<()> {
    let [major, minor] = bytes_at::<2>(bytes, 24)?;
    if (major, minor) < (1, 4) {
        return Ok(());
    }
    let first = u64::from_le_bytes(bytes_at(bytes, 235)?);
    let count = u32::from_le_bytes(bytes_at(bytes, 243)?);
    if count == 0 {
        return Ok(());
    }
    let length = u64::from_le_bytes(bytes_at(bytes, first.saturating_add(20))?);
    if length > (bytes.len() as u64).saturating_sub(first.saturating_add(60)) {
        return Err(
            "has an extended record that is longer than the file; it is truncated: copy it again".into()
        );
    }
    Ok(())
}

fn columns_of(header: &Header, bits: &Bits) -> Vec<Column> {
    let format = header.point_format();
    let mut columns = vec![
        Column::new("intensity", Kind::UInt16),
        Column::new("return_number", Kind::UInt8),
        Column::new("number_of_returns", Kind::UInt8),
        Column::new("classification", Kind::UInt8),
        Column::new("scan_angle", Kind::Float32),
        Column::new("user_data", Kind::UInt8),
        Column::new("point_source_id", Kind::UInt16),
    ];
    if format.has_gps_time {
        columns.push(Column::new("gps_time", Kind::Float64));
    }
    if format.has_color {
        columns.extend(["red", "green", "blue"].map(|name| Column::new(name, Kind::UInt16)));
    }
    if format.has_nir {
        columns.push(Column::new("nir", Kind::UInt16));
    }
    columns.extend(bits.columns());
    columns
}

fn name_of(header: &Header, number: u8, unknown_bytes: usize) -> String {
    let copc = header.all_vlrs().any(|vlr| vlr.user_id == "copc");
    let kind = if copc {
        "COPC"
    } else if header.point_format().is_compressed {
        "LAZ"
    } else {
        "LAS"
    };
    let version = header.version();
    let name = format!("{kind} {}.{}, point format {number}", version.major, version.minor);
    match unknown_bytes {
        0 => name,
        bytes => format!("{name}, {bytes} bytes a point that it does not describe"),
    }
}

impl LasFile {
    pub fn open(bytes: &'static [u8]) -> Result<Self> {
        check_extended_records(bytes)?;
        let header =
            Header::new(Cursor::new(bytes)).map_err(|e| format!("has a LAS header that is wrong: {e}"))?;
        let begin = u32::from_le_bytes(bytes_at(bytes, 96)?) as usize;
        let record = header.point_format().len() as usize;
        let points = header.number_of_points();
        check_points(points, bytes.len())?;
        let compressed = header.point_format().is_compressed;
        let records = if compressed {
            Records::Compressed(Box::new(Chunks::open(bytes, begin, &header, record)?))
        } else {
            let room = bytes.len().saturating_sub(begin) as u64;
            if record == 0 || points > room / record as u64 {
                return Err(format!(
                    "ends at byte {}, before the {points} points that its header announces; the file is truncated",
                    bytes.len()
                ));
            }
            Records::Plain { next: 0 }
        };
        let bits = Bits::new(&header);
        let [number] = bytes_at::<1>(bytes, 104)?;
        let about = About {
            format: name_of(&header, number & 0x3f, bits.unknown),
            unit: units::of_las(&header),
            points,
            columns: columns_of(&header, &bits),
        };
        Ok(LasFile { bytes, begin, header, record, records, bits, read: 0, about })
    }

    /// The next records as they are in an uncompressed file; none at the end.
    fn next_records(&mut self, most: u64) -> Result<Vec<u8>> {
        const MOST_BYTES: u64 = 1 << 24;
        let most = most.min(MOST_BYTES / self.record as u64 + 1);
        let wanted = most.min(self.about.points - self.read);
        let records = match &mut self.records {
            Records::Plain { next } => {
                let first = self.begin + *next as usize * self.record;
                *next += wanted;
                self.bytes[first..first + wanted as usize * self.record].to_vec()
            }
            Records::Compressed(chunks) => chunks.read(wanted)?,
        };
        self.read += (records.len() / self.record) as u64;
        Ok(records)
    }

    fn append_rows(&self, points: &PointData, rows: &mut Vec<f64>) {
        let width = 3 + self.about.columns.len();
        let first = rows.len();
        rows.resize(first + points.len() * width, 0.0);
        let mut column = 0;
        let mut put = |values: &mut dyn Iterator<Item = f64>| {
            for (row, value) in rows[first..].chunks_exact_mut(width).zip(values) {
                row[column] = value;
            }
            column += 1;
        };
        put(&mut points.x());
        put(&mut points.y());
        put(&mut points.z());
        put(&mut points.intensity().map(f64::from));
        put(&mut points.return_number().map(f64::from));
        put(&mut points.number_of_returns().map(f64::from));
        put(&mut points.classification().map(f64::from));
        put(&mut points.scan_angle_degrees().map(f64::from));
        put(&mut points.user_data().map(f64::from));
        put(&mut points.point_source_id().map(f64::from));
        if let Some(mut times) = points.gps_time() {
            put(&mut times);
        }
        if let Some(colours) = points.rgb() {
            let colours: Vec<_> = colours.collect();
            put(&mut colours.iter().map(|c| f64::from(c.0)));
            put(&mut colours.iter().map(|c| f64::from(c.1)));
            put(&mut colours.iter().map(|c| f64::from(c.2)));
        }
        if let Some(nir) = points.nir() {
            put(&mut nir.map(f64::from));
        }
        for (row, record) in
            rows[first..].chunks_exact_mut(width).zip(points.raw_bytes().chunks_exact(self.record))
        {
            self.bits.put(record, &mut row[column..]);
        }
    }
}

impl Scan for LasFile {
    fn about(&self) -> &About {
        &self.about
    }

    fn read(&mut self, most: usize, rows: &mut Vec<f64>) -> Result<()> {
        let records = self.next_records(most as u64)?;
        let points = PointDataBuilder::new()
            .for_header(&self.header)
            .build_from_bytes(records)
            .map_err(|e| format!("has records that are wrong: {e}"))?;
        self.append_rows(&points, rows);
        Ok(())
    }
}
