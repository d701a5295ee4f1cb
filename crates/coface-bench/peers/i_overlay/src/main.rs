//! Peer of the tasks `overlay-intersection` and `overlay-union`: the 32-bit overlay of i_overlay.
//!
//! Usage: i-overlay-peer intersection|union FILE.raw3. Coordinates in the file are integers below 2^28. Reading is outside the
//! clock.
//!
//!     cargo build --release --manifest-path crates/coface-bench/peers/i_overlay/Cargo.toml
//!     coface-bench compare overlay-union squares_100000 --peer 'i_overlay=PATH/i-overlay-peer union {}'

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::Overlay;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::i_float::int::point::IntPoint;
use std::time::Instant;

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let bytes = std::fs::read(&arguments[2]).expect("the file can be read");
    let word = |i: usize| u32::from_le_bytes(bytes[4 * i..4 * i + 4].try_into().expect("four bytes"));
    let [arity, vertex_count, count] = [0, 1, 2].map(|i| word(i) as usize);
    let (starts, first): (Vec<usize>, usize) = if arity > 0 {
        ((0..=count).map(|ring| ring * arity).collect(), 3)
    } else {
        ((0..=count).map(|ring| word(3 + ring) as usize).collect(), 4 + count)
    };
    let coordinates = 4 * (first + starts[count]);
    let number = |i: usize| {
        let at = coordinates + 8 * i;
        f64::from_le_bytes(bytes[at..at + 8].try_into().expect("eight bytes"))
    };
    let mut regions = [Vec::new(), Vec::new()];
    for ring in starts.windows(2) {
        let vertices: Vec<usize> = (ring[0]..ring[1]).map(|i| word(first + i) as usize).collect();
        let points = vertices.iter().map(|&v| IntPoint::new(number(3 * v) as i32, number(3 * v + 1) as i32));
        regions[number(3 * vertices[0] + 2) as usize].push(points.collect::<Vec<_>>());
    }
    let rule = if arguments[1] == "union" { OverlayRule::Union } else { OverlayRule::Intersect };
    let (begin, begin_cpu) = (Instant::now(), processor_seconds());
    let shapes = Overlay::from_subj_and_clip(&regions[0], &regions[1]).overlay(rule, FillRule::NonZero);
    let (seconds, cpu_seconds) = (begin.elapsed().as_secs_f64(), processor_seconds() - begin_cpu);
    let rings: usize = shapes.iter().map(|shape| shape.len()).sum();
    let vertices: usize = shapes.iter().flatten().map(|ring| ring.len()).sum();
    let result = format!("polygons {} rings {rings} vertices {vertices}", shapes.len());
    let line = serde_json::json!({
        "seconds": seconds, "cpu_seconds": cpu_seconds, "size": vertex_count, "result": result
    });
    println!("{line}");
}

/// The processor time of all threads.
fn processor_seconds() -> f64 {
    let threads = std::fs::read_dir("/proc/self/task").expect("threads are listed");
    let nanoseconds = threads.map(|thread| {
        let path = thread.expect("a thread is listed").path().join("schedstat");
        let text = std::fs::read_to_string(path).expect("a thread tells its time");
        text.split_whitespace().next().and_then(|word| word.parse::<u64>().ok()).unwrap_or(0)
    });
    nanoseconds.sum::<u64>() as f64 * 1e-9
}
