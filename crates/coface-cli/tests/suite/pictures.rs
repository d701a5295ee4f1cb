//! The pictures of the documentation are those that its commands make.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use std::path::Path;
use std::process::Command;

/// The mean difference of the parts of pixels, of 255, that two pictures may have.
const TOLERANCE: f64 = 0.5;

fn decoded(path: &Path) -> ([u32; 2], Vec<u8>) {
    let bytes = std::io::Cursor::new(std::fs::read(path).unwrap());
    let mut reader = png::Decoder::new(bytes).read_info().unwrap();
    let mut buffer = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut buffer).unwrap();
    buffer.truncate(info.buffer_size());
    ([info.width, info.height], buffer)
}

/// The numbers of an SVG, and the text without them.
fn parts(path: &Path) -> (Vec<f64>, String) {
    let text = std::fs::read_to_string(path).unwrap();
    let is_digit = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let numbers = text.split(|c| !is_digit(c)).filter_map(|word| word.parse().ok()).collect();
    (numbers, text.split(is_digit).collect())
}

#[test]
fn pictures_are_what_their_commands_make() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir_all(folder.path().join("docs/pictures")).unwrap();
    let commands = std::fs::read_to_string(root.join("docs/pictures/commands.txt")).unwrap();
    for command in commands.lines() {
        let words: Vec<String> = command
            .split(' ')
            .map(|word| match word.starts_with("data/") || word.ends_with(".wkt") {
                // What is shipped is read where it lies.
                true => root.join(word).to_str().unwrap().to_owned(),
                false => word.to_owned(),
            })
            .collect();
        assert_eq!(words[0], "coface");
        let run = Command::new(env!("CARGO_BIN_EXE_coface"))
            .args(&words[1..])
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert!(run.status.success(), "{command}: {}", String::from_utf8_lossy(&run.stderr));
        let Some(place) = words.last().filter(|word| word.starts_with("docs/pictures/")) else { continue };
        let (made, kept) = (folder.path().join(place), root.join(place));
        assert!(std::fs::metadata(&kept).unwrap().len() < 150_000, "{place} is large");
        if place.ends_with(".png") {
            let ((size, made), (kept_size, kept)) = (decoded(&made), decoded(&kept));
            assert_eq!(size, kept_size, "{place}");
            let difference: f64 = made.iter().zip(&kept).map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
            let difference = difference / made.len() as f64;
            assert!(difference < TOLERANCE, "{place} differs by {difference}; make it again: {command}");
        } else {
            let ((made, shape), (kept, kept_shape)) = (parts(&made), parts(&kept));
            let is_near =
                made.len() == kept.len() && made.iter().zip(&kept).all(|(a, b)| (a - b).abs() < 0.2);
            assert!(shape == kept_shape && is_near, "{place} differs; make it again: {command}");
        }
    }
}
