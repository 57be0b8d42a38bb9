// SPDX-License-Identifier: GPL-3.0-or-later
//! E57: all scans of a file, one after the other, each moved by its pose. Values are taken as they are stored.

use crate::scan::{bytes_at, check_points, About, Column, Kind, Result, Scan};
use e57::{
    E57Reader, PointCloud, PointCloudReaderRaw, RawValues, Record, RecordDataType, RecordName, RecordValue,
};
use std::io::Cursor;

type Bytes = Cursor<&'static [u8]>;

/// Where the numbers of a scan's records go.
struct Layout {
    cartesian: Option<[usize; 3]>,
    spherical: Option<[usize; 3]>,
    invalid: Option<usize>,      // of the place: anything but 0
    columns: Vec<Option<usize>>, // of About::columns
    normals: Option<[usize; 3]>, // positions in About::columns: they turn with the scan
}

pub struct E57File {
    clouds: Vec<PointCloud>,
    next_cloud: usize,
    layout: Layout,
    // Borrows `reader`, which is never moved and lives longer: it stands after in the struct.
    points: Option<PointCloudReaderRaw<'static, Bytes>>,
    reader: Box<E57Reader<Bytes>>,
    about: About,
}

fn wrong(error: e57::Error) -> String {
    let text: String = error.to_string().chars().filter(|c| !c.is_control()).take(200).collect();
    format!("is an E57 file that is damaged or cut short ({text}); copy it again")
}

/// Bits that a value takes in the file; 0 where all values are the same.
fn bits(kind: &RecordDataType) -> u32 {
    match kind {
        RecordDataType::Single { .. } => 32,
        RecordDataType::Double { .. } => 64,
        RecordDataType::ScaledInteger { min, max, .. } | RecordDataType::Integer { min, max } => {
            128 - (i128::from(*max) - i128::from(*min)).max(0).leading_zeros()
        }
    }
}

fn kind_of(data: &RecordDataType) -> Kind {
    match data {
        RecordDataType::Single { .. } => Kind::Float32,
        RecordDataType::Integer { min: 0.., max: ..=255 } => Kind::UInt8,
        RecordDataType::Integer { min: 0.., max: ..=65535 } => Kind::UInt16,
        RecordDataType::Integer { min: -32768.., max: ..=32767 } => Kind::Int16,
        RecordDataType::Integer { min: 0.., max } if *max <= i64::from(u32::MAX) => Kind::UInt32,
        RecordDataType::Integer { min, max }
            if *min >= i64::from(i32::MIN) && *max <= i64::from(i32::MAX) =>
        {
            Kind::Int32
        }
        _ => Kind::Float64,
    }
}

/// The name of the column for a record; none for those that are no column.
fn column_name(name: &RecordName) -> Option<String> {
    use RecordName::*;
    Some(match name {
        Intensity => "intensity".into(),
        ColorRed => "red".into(),
        ColorGreen => "green".into(),
        ColorBlue => "blue".into(),
        RowIndex => "row".into(),
        ColumnIndex => "column".into(),
        ReturnCount => "number_of_returns".into(),
        ReturnIndex => "return_number".into(),
        TimeStamp => "time".into(),
        Unknown { name, .. } => match name.as_str() {
            "normalX" => "nx".into(),
            "normalY" => "ny".into(),
            "normalZ" => "nz".into(),
            _ => name.chars().filter(|c| c.is_ascii_graphic()).take(60).collect(),
        },
        _ => return None,
    })
}

/// Columns of all scans; where two differ in type, double holds both.
fn columns_of(clouds: &[PointCloud]) -> Vec<Column> {
    let mut columns: Vec<Column> = Vec::new();
    for record in clouds.iter().flat_map(|cloud| &cloud.prototype) {
        let Some(name) = column_name(&record.name) else { continue };
        let kind = kind_of(&record.data_type);
        match columns.iter_mut().find(|column| column.name == name) {
            Some(column) if column.kind != kind => column.kind = Kind::Float64,
            Some(_) => {}
            None => columns.push(Column { name, kind }),
        }
    }
    if clouds.len() > 1 {
        columns.push(Column::new("scan", Kind::UInt16));
    }
    columns
}

fn three(cloud: &PointCloud, names: [RecordName; 3]) -> Option<[usize; 3]> {
    let find = |name: &RecordName| cloud.prototype.iter().position(|record| record.name == *name);
    Some([find(&names[0])?, find(&names[1])?, find(&names[2])?])
}

fn layout_of(cloud: &PointCloud, columns: &[Column]) -> Result<Layout> {
    use RecordName::*;
    let cartesian = three(cloud, [CartesianX, CartesianY, CartesianZ]);
    let spherical = three(cloud, [SphericalRange, SphericalAzimuth, SphericalElevation]);
    if cartesian.is_none() && spherical.is_none() {
        return Err("has a scan without coordinates; export it again".into());
    }
    let invalid_name = if cartesian.is_some() { CartesianInvalidState } else { SphericalInvalidState };
    let invalid = cloud.prototype.iter().position(|record| record.name == invalid_name);
    let of_column = |column: &Column| {
        cloud.prototype.iter().position(|r: &Record| column_name(&r.name).as_deref() == Some(&column.name))
    };
    let position = |name: &str| columns.iter().position(|column| column.name == name);
    let normals = match (position("nx"), position("ny"), position("nz")) {
        (Some(x), Some(y), Some(z)) => Some([x, y, z]),
        _ => None,
    };
    Ok(Layout { cartesian, spherical, invalid, columns: columns.iter().map(of_column).collect(), normals })
}

fn number(value: &RecordValue, record: &Record) -> f64 {
    match (value, &record.data_type) {
        (RecordValue::ScaledInteger(raw), RecordDataType::ScaledInteger { scale, offset, .. }) => {
            *raw as f64 * scale + offset
        }
        (RecordValue::Single(v), _) => f64::from(*v),
        (RecordValue::Double(v), _) => *v,
        (RecordValue::ScaledInteger(v) | RecordValue::Integer(v), _) => *v as f64,
    }
}

/// Turned by the quaternion of the pose, which is made to length 1.
fn turned(cloud: &PointCloud, v: [f64; 3]) -> [f64; 3] {
    let Some(pose) = &cloud.transform else { return v };
    let q = &pose.rotation;
    let length = (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z).sqrt();
    if !(length > 0.0) {
        return v;
    }
    let (w, u) = (q.w / length, [q.x / length, q.y / length, q.z / length]);
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let t = cross(u, v);
    let s = cross(u, [t[0] + w * v[0], t[1] + w * v[1], t[2] + w * v[2]]);
    [v[0] + 2.0 * s[0], v[1] + 2.0 * s[1], v[2] + 2.0 * s[2]]
}

fn moved(cloud: &PointCloud, v: [f64; 3]) -> [f64; 3] {
    let Some(pose) = &cloud.transform else { return v };
    let p = turned(cloud, v);
    let t = &pose.translation;
    [p[0] + t.x, p[1] + t.y, p[2] + t.z]
}

impl E57File {
    pub fn open(bytes: &'static [u8]) -> Result<Self> {
        // The crate takes the memory for the XML before it looks whether the file has as much.
        if u64::from_le_bytes(bytes_at(bytes, 32)?) > bytes.len() as u64 {
            return Err(
                "ends before the XML that its header announces; the file is truncated: copy it again".into(),
            );
        }
        let reader = Box::new(E57Reader::new(Cursor::new(bytes)).map_err(wrong)?);
        let clouds = reader.pointclouds();
        let mut points: u64 = 0;
        for cloud in &clouds {
            points = points.saturating_add(cloud.records);
            // Values of no bits are made, not read: with nothing else in a record there is no end of them.
            if cloud.records > 0 && cloud.prototype.iter().all(|record| bits(&record.data_type) == 0) {
                return Err("has a scan whose points are all the same; export it again".into());
            }
        }
        check_points(points, bytes.len())?;
        let about = About {
            format: format!("E57, {} {}", clouds.len(), if clouds.len() == 1 { "scan" } else { "scans" }),
            unit: "m".into(), // the standard's
            points,
            columns: columns_of(&clouds),
        };
        let layout =
            Layout { cartesian: None, spherical: None, invalid: None, columns: Vec::new(), normals: None };
        Ok(E57File { clouds, next_cloud: 0, layout, points: None, reader, about })
    }

    fn open_next(&mut self) -> Result<bool> {
        self.points = None;
        let Some(cloud) = self.clouds.get(self.next_cloud) else { return Ok(false) };
        self.next_cloud += 1;
        if cloud.records == 0 {
            return self.open_next();
        }
        self.layout = layout_of(cloud, &self.about.columns)?;
        let reader: *mut E57Reader<Bytes> = &mut *self.reader;
        // SAFETY: the reader is boxed, so it stays where it is; `points` alone uses it, and is dropped before
        // the next one is made and before the reader.
        let points = unsafe { (*reader).pointcloud_raw(cloud) }.map_err(wrong)?;
        self.points = Some(points);
        Ok(true)
    }

    fn append_row(&self, values: &RawValues, rows: &mut Vec<f64>) {
        let cloud = &self.clouds[self.next_cloud - 1];
        let layout = &self.layout;
        let value = |i: usize| number(&values[i], &cloud.prototype[i]);
        let place = match (layout.cartesian, layout.spherical) {
            _ if layout.invalid.is_some_and(|i| value(i) != 0.0) => [f64::NAN; 3],
            (Some(c), _) => moved(cloud, c.map(value)),
            (None, Some(s)) => {
                let [range, azimuth, elevation] = s.map(value);
                let flat = range * elevation.cos();
                moved(cloud, [flat * azimuth.cos(), flat * azimuth.sin(), range * elevation.sin()])
            }
            (None, None) => [f64::NAN; 3],
        };
        rows.extend(place);
        let first = rows.len();
        for (column, record) in self.about.columns.iter().zip(&layout.columns) {
            let missing = match column.kind {
                Kind::Float32 | Kind::Float64 => f64::NAN,
                _ => 0.0,
            };
            let of_scan = column.name == "scan" && record.is_none();
            rows.push(match record {
                // E57 counts returns from 0, LAS from 1.
                Some(i) if cloud.prototype[*i].name == RecordName::ReturnIndex => value(*i) + 1.0,
                Some(i) => value(*i),
                None if of_scan => (self.next_cloud - 1) as f64,
                None => missing,
            });
        }
        if let Some(n) = layout.normals {
            let normal = turned(cloud, n.map(|i| rows[first + i]));
            for (i, v) in n.into_iter().zip(normal) {
                rows[first + i] = v;
            }
        }
    }
}

impl Scan for E57File {
    fn about(&self) -> &About {
        &self.about
    }

    fn read(&mut self, most: usize, rows: &mut Vec<f64>) -> Result<()> {
        let mut count = 0;
        while count < most {
            match self.points.as_mut().and_then(Iterator::next) {
                Some(values) => {
                    self.append_row(&values.map_err(wrong)?, rows);
                    count += 1;
                }
                None if !self.open_next()? => break,
                None => {}
            }
        }
        Ok(())
    }
}
