// SPDX-License-Identifier: GPL-3.0-or-later
//! LAS, LAZ, COPC and E57 for rimline. This file is the C ABI, as rimline_scan_formats.h declares it: no panic
//! leaves it, and nothing is kept of the caller's but the bytes, until the scan is closed.

mod e57_file;
mod las_bits;
mod las_file;
mod laz_chunks;
mod scan;
mod units;

use scan::Scan;
use std::ffi::{c_char, CString};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::Once;

/// A file that is being read.
pub struct RimlineScan {
    scan: Box<dyn Scan>,
    format: CString,
    unit: CString,
    names: Vec<CString>,
    rows: Vec<f64>,
}

fn c_text(text: &str) -> CString {
    let clean: Vec<u8> = text.bytes().filter(|b| *b != 0).collect();
    CString::new(clean).unwrap_or_default()
}

/// Writes the message, cut to `room` with its end.
unsafe fn put_message(message: &str, to: *mut c_char, room: usize) {
    if to.is_null() || room == 0 {
        return;
    }
    let text = c_text(message);
    let bytes = text.as_bytes();
    let length = bytes.len().min(room - 1);
    std::ptr::copy_nonoverlapping(bytes.as_ptr().cast(), to, length);
    *to.add(length) = 0;
}

/// Runs `body`; a panic becomes a message, and prints nothing.
fn guarded<T>(body: impl FnOnce() -> scan::Result<T>) -> scan::Result<T> {
    static SILENT: Once = Once::new();
    SILENT.call_once(|| std::panic::set_hook(Box::new(|_| {})));
    catch_unwind(AssertUnwindSafe(body)).unwrap_or_else(|_| {
        Err("is damaged in a way that its reader can not cope with; copy it again".into())
    })
}

fn open(bytes: &'static [u8]) -> scan::Result<RimlineScan> {
    let scan: Box<dyn Scan> = if bytes.starts_with(b"LASF") {
        Box::new(las_file::LasFile::open(bytes)?)
    } else {
        Box::new(e57_file::E57File::open(bytes)?)
    };
    let about = scan.about();
    Ok(RimlineScan {
        format: c_text(&about.format),
        unit: c_text(&about.unit),
        names: about.columns.iter().map(|column| c_text(&column.name)).collect(),
        rows: Vec::new(),
        scan,
    })
}

/// # Safety
/// `bytes` are `size` bytes that stay until `rimline_scan_close`; `message` has room for `room` bytes.
#[no_mangle]
pub unsafe extern "C" fn rimline_scan_open(
    bytes: *const u8,
    size: usize,
    message: *mut c_char,
    room: usize,
) -> *mut RimlineScan {
    let bytes: &'static [u8] = std::slice::from_raw_parts(bytes, size);
    match guarded(|| open(bytes)) {
        Ok(scan) => Box::into_raw(Box::new(scan)),
        Err(text) => {
            put_message(&text, message, room);
            std::ptr::null_mut()
        }
    }
}

/// # Safety
/// `scan` comes from `rimline_scan_open` and was not closed; so below.
#[no_mangle]
pub unsafe extern "C" fn rimline_scan_points(scan: *const RimlineScan) -> u64 {
    (*scan).scan.about().points
}

/// # Safety
/// As above.
#[no_mangle]
pub unsafe extern "C" fn rimline_scan_format(scan: *const RimlineScan) -> *const c_char {
    (*scan).format.as_ptr()
}

/// # Safety
/// As above.
#[no_mangle]
pub unsafe extern "C" fn rimline_scan_unit(scan: *const RimlineScan) -> *const c_char {
    (*scan).unit.as_ptr()
}

/// # Safety
/// As above.
#[no_mangle]
pub unsafe extern "C" fn rimline_scan_columns(scan: *const RimlineScan) -> usize {
    let scan = &*scan;
    scan.names.len()
}

/// # Safety
/// As above; `column` is below the number of columns.
#[no_mangle]
pub unsafe extern "C" fn rimline_scan_column_name(scan: *const RimlineScan, column: usize) -> *const c_char {
    let scan = &*scan;
    scan.names.get(column).map_or(std::ptr::null(), |name| name.as_ptr())
}

/// # Safety
/// As above.
#[no_mangle]
pub unsafe extern "C" fn rimline_scan_column_kind(scan: *const RimlineScan, column: usize) -> u8 {
    (*scan).scan.about().columns.get(column).map_or(scan::Kind::Float64 as u8, |c| c.kind as u8)
}

/// # Safety
/// As above; `rows` and `message` may be written to, the latter for `room` bytes.
#[no_mangle]
pub unsafe extern "C" fn rimline_scan_read(
    scan: *mut RimlineScan,
    most: usize,
    rows: *mut *const f64,
    message: *mut c_char,
    room: usize,
) -> i64 {
    let scan = &mut *scan;
    let width = 3 + scan.names.len();
    scan.rows.clear();
    let RimlineScan { scan: file, rows: buffer, .. } = scan;
    match guarded(|| file.read(most, buffer)) {
        Ok(()) => {
            *rows = buffer.as_ptr();
            (buffer.len() / width) as i64
        }
        Err(text) => {
            put_message(&text, message, room);
            -1
        }
    }
}

/// # Safety
/// As above; the scan and all that was got from it are gone after this.
#[no_mangle]
pub unsafe extern "C" fn rimline_scan_close(scan: *mut RimlineScan) {
    let _ = guarded(|| {
        drop(Box::from_raw(scan));
        Ok(())
    });
}
