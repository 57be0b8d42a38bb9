// SPDX-License-Identifier: GPL-3.0-or-later
//! Writes tests/io/files/spherical.e57, which pye57 can not: spherical coordinates, times, returns, normals and a
//! pose. `cargo run --release --example spherical FILE`

use e57::{
    E57Writer, Extension, Quaternion, Record, RecordDataType, RecordName, RecordValue, Transform, Translation,
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("the file to write is missing")?;
    let mut writer = E57Writer::from_file(path, "{6d0cbd3e-3d8e-4c0a-9a2e-0d6f3f3a1a57}")?;
    writer.register_extension(Extension::new("nor", "http://www.libe57.org/E57_NOR_surface_normals.txt"))?;
    let double = |name| Record { name, data_type: RecordDataType::F64 };
    let normal = |name: &str| double(RecordName::Unknown { namespace: "nor".into(), name: name.into() });
    let prototype = vec![
        Record::SPHERICAL_RANGE_F64,
        Record::SPHERICAL_AZIMUTH_F64,
        Record::SPHERICAL_ELEVATION_F64,
        double(RecordName::TimeStamp),
        Record { name: RecordName::ReturnIndex, data_type: RecordDataType::Integer { min: 0, max: 3 } },
        Record { name: RecordName::ReturnCount, data_type: RecordDataType::Integer { min: 4, max: 4 } },
        normal("normalX"),
        normal("normalY"),
        normal("normalZ"),
    ];
    let mut cloud = writer.add_pointcloud("{0f3c5b0e-93f6-4f0e-8c55-d9a4d3c3b0f1}", prototype)?;
    // A quarter turn about z, and a step along x.
    cloud.set_transform(Some(Transform {
        rotation: Quaternion { w: 0.5f64.sqrt(), x: 0.0, y: 0.0, z: 0.5f64.sqrt() },
        translation: Translation { x: 100.0, y: 0.0, z: 0.0 },
    }));
    for i in 0..20 {
        let k = f64::from(i);
        let numbers = [5.0 + k / 8.0, k / 16.0, -k / 32.0, k / 4.0];
        let mut values: Vec<_> = numbers.map(RecordValue::Double).into();
        values.push(RecordValue::Integer(i64::from(i) % 4));
        values.push(RecordValue::Integer(4));
        values.extend([1.0, 0.0, 0.0].map(RecordValue::Double));
        cloud.add_point(values)?;
    }
    cloud.finalize()?;
    writer.finalize()?;
    Ok(())
}
