// SPDX-License-Identifier: GPL-3.0-or-later
//! The chunks of a LAZ file. The crate `laz` takes memory as sizes inside of a chunk ask for it, so these are
//! compared with the bytes of the chunk first.

use crate::scan::{bytes_at, Result};
use las::Header;
use laz::laszip::{ChunkTable, CompressorType};
use laz::record::{LayeredPointRecordDecompressor, RecordDecompressor, SequentialPointRecordDecompressor};
use laz::{LazItem, LazItemType, LazVlr};
use std::io::Cursor;

type Decoder = Box<dyn RecordDecompressor<Cursor<&'static [u8]>>>;

/// Where a chunk lies in the file, and how many points it may have.
struct Chunk {
    begin: usize,
    end: usize,
    points: u64,
}

pub struct Chunks {
    bytes: &'static [u8],
    items: Vec<LazItem>,
    layered: bool,
    record: usize,
    chunks: std::vec::IntoIter<Chunk>,
    decoder: Option<Decoder>,
    left: u64, // points of the chunk that is being decoded
}

/// Each extra byte of a point has models of its own, some kilobytes; no scanner writes as many.
const MOST_RECORD_BYTES: usize = 4096;

const TRUNCATED: &str = "has compressed points that are cut short or damaged; copy it again";

fn vlr_of(header: &Header) -> Result<LazVlr> {
    let vlr = header
        .vlrs()
        .iter()
        .find(|vlr| vlr.user_id == LazVlr::USER_ID && vlr.record_id == LazVlr::RECORD_ID)
        .ok_or("is compressed but does not tell how: it has no laszip record; export it again")?;
    LazVlr::from_buffer(&vlr.data).map_err(|e| format!("has a laszip record that is wrong: {e}"))
}

/// How many layers the items have, each with a size of four bytes before the data.
fn layers_of(items: &[LazItem]) -> usize {
    let layers = |item: &LazItem| match item.item_type() {
        LazItemType::Point14 => 9,
        LazItemType::RGBNIR14 => 2,
        LazItemType::Byte14(count) => count as usize,
        _ => 1,
    };
    items.iter().map(layers).sum()
}

/// The offset of the chunk table stands before the points, or at the end of the file.
fn table_offset(bytes: &[u8], begin: usize) -> Result<u64> {
    let first = i64::from_le_bytes(bytes_at(bytes, begin as u64)?);
    let last = i64::from_le_bytes(bytes_at(bytes, (bytes.len() as u64).saturating_sub(8))?);
    let offset = if first > begin as i64 { first } else { last };
    u64::try_from(offset).map_err(|_| TRUNCATED.to_string())
}

fn read_chunks(bytes: &'static [u8], begin: usize, vlr: &LazVlr) -> Result<Vec<Chunk>> {
    let table = table_offset(bytes, begin)?;
    let count = u32::from_le_bytes(bytes_at(bytes, table.saturating_add(4))?);
    if u64::from(count) > bytes.len() as u64 {
        return Err(TRUNCATED.into());
    }
    let mut cursor = Cursor::new(bytes);
    cursor.set_position(begin as u64);
    let entries = ChunkTable::read_from(cursor, vlr).map_err(|_| TRUNCATED.to_string())?;
    let mut at = begin as u64 + ChunkTable::OFFSET_SIZE as u64;
    let mut chunks = Vec::new();
    for i in 0..entries.len() {
        let entry = entries[i];
        let end =
            at.checked_add(entry.byte_count).filter(|end| *end <= bytes.len() as u64).ok_or(TRUNCATED)?;
        chunks.push(Chunk { begin: at as usize, end: end as usize, points: entry.point_count });
        at = end;
    }
    Ok(chunks)
}

impl Chunks {
    pub fn open(bytes: &'static [u8], begin: usize, header: &Header, record: usize) -> Result<Self> {
        let vlr = vlr_of(header)?;
        if vlr.items_size() != record as u64 {
            return Err("has compressed points of another size than its header says; export it again".into());
        }
        if record > MOST_RECORD_BYTES {
            return Err(format!("has {record} bytes a point, more than the {MOST_RECORD_BYTES} that are decoded; unpack it to LAS"));
        }
        // The compressor is the first number of the record; the crate does not show it.
        let single = header.vlrs().iter().any(|v| {
            v.record_id == LazVlr::RECORD_ID
                && v.user_id == LazVlr::USER_ID
                && v.data.first() == Some(&(CompressorType::PointWise as u8))
        });
        let layered = vlr.items().iter().any(|item| item.version() >= 3);
        let chunks = if single {
            vec![Chunk { begin, end: bytes.len(), points: u64::MAX }]
        } else {
            read_chunks(bytes, begin, &vlr)?
        };
        Ok(Chunks {
            bytes,
            items: vlr.items().clone(),
            layered,
            record,
            chunks: chunks.into_iter(),
            decoder: None,
            left: 0,
        })
    }

    /// After the first point of a layered chunk: a count, the size of each layer, and the layers.
    fn check_layers(&self, chunk: &'static [u8]) -> Result<()> {
        let mut total = (self.record + 4) as u64;
        for layer in 0..layers_of(&self.items) {
            let at = self.record + 4 + 4 * layer;
            total += 4 + u64::from(u32::from_le_bytes(bytes_at(chunk, at as u64)?));
        }
        if total > chunk.len() as u64 {
            return Err(TRUNCATED.into());
        }
        Ok(())
    }

    fn open_next(&mut self) -> Result<bool> {
        let Some(chunk) = self.chunks.next() else { return Ok(false) };
        let bytes = &self.bytes[chunk.begin..chunk.end];
        self.left = chunk.points;
        if self.left == 0 {
            return Ok(true);
        }
        let mut decoder: Decoder = if self.layered {
            self.check_layers(bytes)?;
            Box::new(LayeredPointRecordDecompressor::new(Cursor::new(bytes)))
        } else {
            Box::new(SequentialPointRecordDecompressor::new(Cursor::new(bytes)))
        };
        decoder
            .set_fields_from(&self.items)
            .map_err(|e| format!("is compressed in a way that is not read: {e}"))?;
        if decoder.record_size() != self.record {
            return Err(TRUNCATED.into());
        }
        self.decoder = Some(decoder);
        Ok(true)
    }

    /// The next `wanted` records, decoded. Fewer are an error, as the header announced them.
    pub fn read(&mut self, wanted: u64) -> Result<Vec<u8>> {
        let mut out = vec![0; wanted as usize * self.record];
        for record in out.chunks_exact_mut(self.record) {
            while self.left == 0 {
                self.decoder = None;
                if !self.open_next()? {
                    return Err(
                        "has fewer points than its header announces; it is truncated: copy it again".into()
                    );
                }
            }
            let decoder = self.decoder.as_mut().ok_or(TRUNCATED)?;
            decoder.decompress_next(record).map_err(|_| TRUNCATED.to_string())?;
            self.left -= 1;
        }
        Ok(out)
    }
}
