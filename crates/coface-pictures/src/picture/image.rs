//! Images of two axes: grey values as pixels.

use super::flat::{Anchor, FlatPicture};
use super::matrix::rectangle;
use super::palette::LIGHT;
use coface_algebra::{Error, ErrorKind};

/// The longer side of an image, the room around it, and that at its right for the bar of grey values.
const SIDE: f64 = 640.0;
const MARGIN: f64 = 30.0;
const TOP: f64 = 46.0;
const RIGHT: f64 = 110.0;
const BAR: f64 = 16.0;
/// An image of more pixels a side is drawn by means of squares of them.
const MOST_PIXELS: usize = 1024;

/// An image of grey values, row after row from the top: the least value is black, the greatest white, beside a bar that says which they are. Pixels without
/// a finite value are left out. Of an image of more than 1024 pixels a side the means of squares of pixels are drawn.
///
/// # Errors
/// [`ErrorKind::Shape`] unless there is a value for each pixel, and at least one pixel.
///
/// # Complexity
/// Linear in the pixels.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_pictures::image_picture;
/// let picture = image_picture("two rows of three", [2, 3], &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0])?;
/// let svg = picture.svg(None)?;
/// assert!(svg.contains("<image ") && svg.contains(">2 x 3</text>"));
/// assert!(image_picture("too few", [2, 3], &[0.0]).is_err());
/// # Ok(()) }
/// ```
pub fn image_picture(title: &str, [rows, columns]: [usize; 2], values: &[f64]) -> Result<FlatPicture, Error> {
    if rows == 0 || columns == 0 || rows.checked_mul(columns) != Some(values.len()) {
        let message = format!("{} values are no {rows} rows of {columns} pixels", values.len());
        return Err(Error::new(ErrorKind::Shape, message).with_cure("give a value for each pixel"));
    }
    let bin = rows.max(columns).div_ceil(MOST_PIXELS);
    let bins = [rows.div_ceil(bin), columns.div_ceil(bin)];
    let means = means(values, columns, bin, bins);
    let finite = || means.iter().copied().filter(|value| value.is_finite());
    let (low, high) = finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
    let grey = |value: &f64| {
        if !value.is_finite() {
            return None;
        }
        // Half of each, so that a difference is not beyond the range of numbers.
        let share = if low < high { (0.5 * value - 0.5 * low) / (0.5 * high - 0.5 * low) } else { 0.5 };
        Some((255.0 * share).round().clamp(0.0, 255.0) as u8)
    };
    let scale = SIDE / rows.max(columns) as f64;
    let sides = [scale * columns as f64, scale * rows as f64];
    let size = [MARGIN + sides[0] + RIGHT, (TOP + sides[1] + MARGIN).max(TOP + 120.0)];
    let mut picture = FlatPicture::new(title, size, LIGHT.background);
    picture.text([MARGIN, 22.0], Anchor::Start, 15.0, LIGHT.ink, title);
    picture.text([MARGIN, 38.0], Anchor::Start, 12.0, LIGHT.edge, format!("{rows} x {columns}"));
    let whole = [scale * (bin * bins[1]) as f64, scale * (bin * bins[0]) as f64];
    picture.image([MARGIN, TOP], whole, bins[1], means.iter().map(grey).collect());
    picture.stroke(rectangle([MARGIN, TOP], sides).to_vec(), LIGHT.edge, 1.0);
    if low <= high {
        draw_bar(&mut picture, [MARGIN + sides[0] + 18.0, TOP], sides[1].min(200.0), [low, high]);
    }
    Ok(picture)
}

/// The means of squares of pixels, of those that have a finite value.
fn means(values: &[f64], columns: usize, bin: usize, bins: [usize; 2]) -> Vec<f64> {
    if bin == 1 {
        return values.to_vec();
    }
    let mut sums = vec![(0.0, 0.0); bins[0] * bins[1]];
    for (row, line) in values.chunks_exact(columns).enumerate() {
        for (column, &value) in line.iter().enumerate().filter(|(_, value)| value.is_finite()) {
            let (sum, count) = &mut sums[(row / bin) * bins[1] + column / bin];
            *sum += value;
            *count += 1.0;
        }
    }
    sums.into_iter().map(|(sum, count)| sum / count).collect()
}

/// Grey values from the greatest to the least, with their numbers.
fn draw_bar(picture: &mut FlatPicture, corner: [f64; 2], height: f64, [low, high]: [f64; 2]) {
    let greys = if low < high { (0..=255).rev().map(Some).collect() } else { vec![Some(127)] };
    picture.image(corner, [BAR, height], 1, greys);
    picture.stroke(rectangle(corner, [BAR, height]).to_vec(), LIGHT.edge, 1.0);
    let mut ends = vec![(corner[1] + 10.0, high)];
    if low < high {
        ends.push((corner[1] + height, low));
    }
    for (y, value) in ends {
        let words = short(value);
        picture.text([corner[0] + BAR + 6.0, y], Anchor::Start, 12.0, LIGHT.ink, words);
    }
}

/// A number with five digits that matter at most.
fn short(value: f64) -> String {
    let exact = value.to_string();
    if exact.len() <= 8 {
        return exact;
    }
    if (1e-3..1e6).contains(&value.abs()) {
        let digits = 4 - value.abs().log10().floor().clamp(-3.0, 4.0) as i32;
        return format!("{value:.*}", digits.max(0) as usize);
    }
    format!("{value:.3e}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_images_are_means_and_small_ones_are_whole() {
        let values: Vec<f64> = (0..1500).map(f64::from).collect();
        let found = means(&values, 1500, 2, [1, 750]);
        assert_eq!((found.len(), found[0], found[749]), (750, 0.5, 1498.5));
        assert!(image_picture("long", [1, 1500], &values).is_ok());
        let holes = means(&[1.0, f64::NAN, f64::NAN, f64::NAN], 4, 2, [1, 2]);
        assert!(holes[0] == 1.0 && holes[1].is_nan());
    }

    #[test]
    fn values_are_short_words() {
        assert_eq!([0.5, 12.0, 1234.56789, 1e300].map(short), ["0.5", "12", "1234.6", "1.000e300"]);
    }

    #[test]
    fn any_values_have_a_picture() {
        for values in [[f64::NAN; 4], [3.0; 4], [f64::MIN, f64::MAX, 0.0, f64::INFINITY]] {
            assert!(image_picture("odd", [2, 2], &values).unwrap().svg(None).is_ok());
        }
        assert!(image_picture("none", [0, 3], &[]).is_err());
    }

    #[cfg(feature = "png")]
    #[test]
    fn pixels_are_where_they_belong() {
        let picture = image_picture("four", [2, 2], &[0.0, 1.0, 2.0, 4.0]).unwrap();
        let [width, height] = picture.size().map(|side| side as usize);
        let bytes = picture.png([width, height]).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
        let mut buffer = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut buffer).unwrap();
        let at = |row: f64, column: f64| {
            let [y, x] = [TOP + SIDE * row / 2.0, MARGIN + SIDE * column / 2.0].map(|place| place as usize);
            buffer[3 * (y * width + x)]
        };
        assert_eq!([at(0.5, 0.5), at(0.5, 1.5), at(1.5, 0.5), at(1.5, 1.5)], [0, 64, 128, 255]);
    }
}
