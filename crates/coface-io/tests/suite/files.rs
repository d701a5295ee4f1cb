//! Files while something goes wrong: an output that takes no more bytes, and an input that another program shortens
//! while it is read.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::{Error, ErrorKind};
use coface_io::{self as io, Format, Model, ReadOptions};
use std::cell::Cell;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Takes so many bytes, or so many calls, and then no more, as a full disk does; and knows whether it was asked for
/// more.
struct FullDisk<'a> {
    bytes: usize,
    calls: usize,
    has_failed: &'a Cell<bool>,
}

impl Write for FullDisk<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        if self.calls == 0 || self.bytes == 0 && !bytes.is_empty() {
            self.has_failed.set(true);
            return Err(std::io::Error::new(std::io::ErrorKind::StorageFull, "the disk is full"));
        }
        self.calls -= 1;
        let count = bytes.len().min(self.bytes);
        self.bytes -= count;
        Ok(count)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// Counts bytes and calls.
#[derive(Default)]
struct Counting {
    bytes: usize,
    calls: usize,
}

impl Write for Counting {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.bytes += bytes.len();
        self.calls += 1;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// Models that between them every format can hold.
fn models() -> Vec<Model> {
    let texts: [&[u8]; 7] = [
        b"OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
        b"MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra 1\n1 2 3 4 7\nEnd\n",
        b"[[0,1,2],[1,2,3]]",
        b"0,0,1,1\n1,1,2,0\n2,0,0,0\n",
        b"NRRD0004\ntype: double\ndimension: 2\nsizes: 3 2\nencoding: ascii\n\n1 1 1  1 0 1",
        b"{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"properties\":{\"a\":1},\"geometry\":{\"type\":\"Polygon\",\
          \"coordinates\":[[[0,0],[1,0],[0,1],[0,0]]]}}]}",
        b"cMcabbgqw",
    ];
    texts.iter().map(|text| io::read_unknown(*text).unwrap()).collect()
}

#[test]
fn every_writer_says_that_the_disk_is_full_wherever_that_is() {
    let (mut formats, mut failures) = (std::collections::BTreeSet::new(), 0);
    for (number, model) in models().iter().enumerate() {
        for format in Format::ALL {
            let mut whole = Counting::default();
            if io::write(model, &mut whole, format).is_err() {
                continue;
            }
            formats.insert(format.name());
            let at = format!("model {number} as {}", format.name());
            let by_bytes = (0..whole.bytes).step_by(whole.bytes / 200 + 1).chain([whole.bytes - 1]);
            let by_calls = (0..whole.calls).step_by(whole.calls / 200 + 1).chain([whole.calls - 1]);
            let limits =
                by_bytes.map(|bytes| (bytes, usize::MAX)).chain(by_calls.map(|calls| (usize::MAX, calls)));
            for (bytes, calls) in limits {
                let has_failed = Cell::new(false);
                let written = io::write(model, FullDisk { bytes, calls, has_failed: &has_failed }, format);
                assert!(
                    has_failed.get(),
                    "{at}: {bytes} bytes or {calls} calls are enough for what took {} and {}",
                    whole.bytes,
                    whole.calls
                );
                let error = written.expect_err(&at);
                assert_eq!((error.kind(), error.message()), (ErrorKind::Io, "the disk is full"), "{at}");
                failures += 1;
            }
        }
    }
    let missing: Vec<&str> =
        Format::ALL.into_iter().map(Format::name).filter(|name| !formats.contains(name)).collect();
    assert!(
        failures > 1000 && formats.len() >= 15,
        "{failures} failures of {formats:?}, none of {missing:?}"
    );
}

#[test]
fn a_file_that_cannot_be_written_whole_is_not_there() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out");
    for model in models() {
        for format in [Format::Json, Format::Container, Format::Vtk] {
            let mut whole = Counting::default();
            if io::write(&model, &mut whole, format).is_err() {
                continue;
            }
            for bytes in [0, 1, whole.bytes / 2, whole.bytes - 1] {
                let failed = io::replace_file(&path, |out| {
                    let has_failed = Cell::new(false);
                    let mut disk = FullDisk { bytes, calls: usize::MAX, has_failed: &has_failed };
                    io::write(&model, &mut Both(out, &mut disk), format)
                });
                assert!(failed.unwrap_err().to_string().ends_with("out: the disk is full"));
                assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
            }
        }
    }
}

/// Writes to the second, and what it takes to the first.
struct Both<'a, 'b>(&'a mut dyn Write, &'a mut FullDisk<'b>);

impl Write for Both<'_, '_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let count = self.1.write(bytes)?;
        self.0.write_all(&bytes[..count])?;
        Ok(count)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.0.flush()
    }
}

/// Large files of formats that are read in blocks, at once, or voxel by voxel.
fn large_files() -> Vec<(&'static str, Vec<u8>)> {
    let count = 60_000usize;
    let mut off = format!("OFF\n{count} {} 0\n", count - 2);
    (0..count).for_each(|i| off += &format!("{i} {} {}.5\n", i % 7, i % 11));
    (0..count - 2).for_each(|i| off += &format!("3 {i} {} {}\n", i + 1, i + 2));
    let model = io::read(off.as_bytes(), Format::Off).unwrap();
    let written = |format: Format| {
        let mut bytes = Vec::new();
        io::write(&model, &mut bytes, format).unwrap();
        bytes
    };
    let mut npy = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    let header = "{'descr': '|u1', 'fortran_order': False, 'shape': (1000, 2000), }";
    npy.extend(format!("{header:<117}\n").bytes());
    npy.extend((0..2_000_000usize).map(|i| u8::from(i % 3 == 0)));
    let mut nrrd = b"NRRD0004\ntype: uchar\ndimension: 2\nsizes: 1000 2000\nencoding: raw\n\n".to_vec();
    nrrd.extend((0..2_000_000usize).map(|i| u8::from(i % 3 == 0)));
    let formats = [
        ("a.obj", Format::Obj),
        ("a.ply", Format::Ply),
        ("a.stl", Format::Stl),
        ("a.mesh", Format::Medit),
        ("a.msh", Format::Msh),
        ("a.vtk", Format::Vtk),
        ("a.vtu", Format::VtkPolygons),
        ("a.cfc", Format::Container),
    ];
    let mut files: Vec<(&str, Vec<u8>)> =
        formats.into_iter().map(|(name, format)| (name, written(format))).collect();
    files.extend([("a.off", off.into_bytes()), ("a.npy", npy), ("a.nrrd", nrrd)]);
    files
}

#[test]
fn a_file_that_is_shortened_while_it_is_read_is_an_error_that_names_it() {
    let folder = tempfile::tempdir().unwrap();
    let errors = AtomicUsize::new(0);
    for (name, bytes) in large_files() {
        let path = folder.path().join(name);
        fs::write(&path, &bytes).unwrap();
        let whole = io::read_path(&path, None).unwrap_or_else(|error| panic!("{error}"));
        let ends = AtomicBool::new(false);
        std::thread::scope(|scope| {
            scope.spawn(|| {
                let mut length = bytes.len() as u64;
                while !ends.load(Ordering::Relaxed) {
                    // Shorter and shorter, down to nothing, then whole again.
                    length = if length < 1000 { bytes.len() as u64 } else { length / 3 };
                    let file = OpenOptions::new().write(true).open(&path).unwrap();
                    file.set_len(length).unwrap();
                    if length == bytes.len() as u64 {
                        fs::write(&path, &bytes).unwrap();
                    }
                    std::thread::yield_now();
                }
            });
            for _ in 0..20 {
                for options in [ReadOptions::new(), ReadOptions::new().strict(true)] {
                    match io::read_path_with(&path, &options) {
                        // Whole, or a prefix that is a whole file of its format, or zeros where a hole was: never
                        // more than there was.
                        Ok(model) => assert!(
                            model.vertex_count() <= whole.vertex_count() || model.structure().is_some(),
                            "{name}"
                        ),
                        Err(error) => {
                            errors.fetch_add(1, Ordering::Relaxed);
                            assert!(error.to_string().contains(name), "{name}: {error}");
                        }
                    }
                }
            }
            ends.store(true, Ordering::Relaxed);
        });
    }
    assert!(errors.load(Ordering::Relaxed) > 20, "the files were shortened in time");
}

#[test]
fn bytes_that_end_early_are_errors_of_every_reader() {
    // The same without a race: the length of the file is known, and its bytes end before.
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in large_files() {
        let path = folder.path().join(name);
        for part in [2, 3, 7] {
            fs::write(&path, &bytes[..bytes.len() - bytes.len() / part]).unwrap();
            let error: Result<Model, Error> = io::read_path_with(&path, &ReadOptions::new().strict(true));
            match error {
                Err(error) => assert!(error.to_string().contains(name), "{name}: {error}"),
                // Text of points, lines and faces without a count may be whole at every line end.
                Ok(_) => assert!(["a.obj"].contains(&name), "{name} cut by 1/{part}"),
            }
        }
    }
}
