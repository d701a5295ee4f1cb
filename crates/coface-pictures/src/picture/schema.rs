//! Polygons whose sides are glued by letters.

use super::flat::{Anchor, FlatPicture, Step};
use super::formula::Formula;
use super::palette::{Color, LIGHT, color_of_many};
use coface_algebra::{Error, ErrorKind};
use coface_answers::PolygonSchema;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The radius of a polygon, the room around it for letters, and the room below it for its word.
const RADIUS: f64 = 190.0;
const MARGIN: f64 = 60.0;
const FOOT: f64 = 34.0;
/// So many polygons are drawn at most, and so many sides of one.
const MOST_POLYGONS: usize = 30;
const MOST_SIDES: usize = 400;
/// Words of more letters do not stand below their polygon, and more corners than this have no names.
const MOST_LETTERS: usize = 16;
const MOST_NAMED: usize = 32;
/// Sides that are arcs have so many chords.
const CHORDS: usize = 48;

/// Polygons with their letters: sides that are glued have one color and arrows that agree, sides that are not glued are dark. Corners that are
/// glued to one point have one name. Sides run counterclockwise; the first is at the bottom.
///
/// # Errors
/// [`ErrorKind::TooLarge`] for more than 30 polygons, or more than 400 sides of one; [`ErrorKind::InvalidInput`] without any.
///
/// # Complexity
/// Near linear in the sides.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_pictures::schema_picture;
/// let torus = "a b a^-1 b^-1".parse()?;
/// let svg = schema_picture("a torus", &[torus])?.svg(None)?;
/// assert_eq!(svg.matches("stroke-linecap").count(), 4, "a line for each side");
/// assert!(svg.contains(">torus</text>"));
/// # Ok(()) }
/// ```
pub fn schema_picture(title: &str, schemas: &[PolygonSchema]) -> Result<FlatPicture, Error> {
    if schemas.is_empty() {
        return Err(Error::invalid("there is no polygon to draw").with_cure("give a surface, or a word"));
    }
    if schemas.len() > MOST_POLYGONS {
        let message = format!("{} polygons are more than the {MOST_POLYGONS} that are drawn", schemas.len());
        return Err(Error::new(ErrorKind::TooLarge, message).with_cure("draw components one by one"));
    }
    if let Some(schema) = schemas.iter().find(|schema| schema.sides().len() > MOST_SIDES) {
        let message = format!("{} sides are more than the {MOST_SIDES} that are drawn", schema.sides().len());
        return Err(Error::new(ErrorKind::TooLarge, message).with_cure("draw a polygon of fewer sides"));
    }
    let columns = (1..).find(|n| n * n >= schemas.len()).unwrap_or(1);
    let rows = schemas.len().div_ceil(columns);
    let cell = [2.0 * (RADIUS + MARGIN), 2.0 * (RADIUS + MARGIN) + FOOT];
    let size = [columns as f64 * cell[0], rows as f64 * cell[1]];
    let mut picture = FlatPicture::new(title, size, LIGHT.background);
    for (place, schema) in schemas.iter().enumerate() {
        let corner = [(place % columns) as f64 * cell[0], (place / columns) as f64 * cell[1]];
        let polygon = Polygon { schema, middle: [corner[0] + 0.5 * cell[0], corner[1] + RADIUS + MARGIN] };
        polygon.draw(&mut picture);
    }
    Ok(picture)
}

struct Polygon<'s> {
    schema: &'s PolygonSchema,
    middle: [f64; 2],
}

impl Polygon<'_> {
    fn count(&self) -> usize {
        self.schema.sides().len()
    }

    /// The angle of corner i, counterclockwise from the right; the middle of the first side is at the bottom.
    fn angle(&self, corner: f64) -> f64 {
        let count = self.count() as f64;
        -FRAC_PI_2 - PI / count + TAU * corner / count
    }

    fn at(&self, angle: f64, radius: f64) -> [f64; 2] {
        [self.middle[0] + radius * angle.cos(), self.middle[1] - radius * angle.sin()]
    }

    /// The points of a side from its first corner to its second: a segment, or an arc where the polygon would have no area.
    fn points(&self, side: usize) -> Vec<[f64; 2]> {
        let chords = if self.count() < 3 { CHORDS } else { 1 };
        let point = |i: usize| self.at(self.angle(side as f64 + i as f64 / chords as f64), RADIUS);
        (0..=chords).map(point).collect()
    }

    fn draw(&self, picture: &mut FlatPicture) {
        let outline = (0..self.count()).flat_map(|side| {
            let mut points = self.points(side);
            points.pop();
            points
        });
        let mut path: Vec<Step> = outline.map(Step::Line).collect();
        if let Some(Step::Line(first)) = path.first().copied() {
            path[0] = Step::Move(first);
        }
        path.push(Step::Close);
        picture.begin_group(&self.schema.to_string());
        picture.fill(path, LIGHT.surface, 0.5);
        let mut uses = vec![0usize; self.schema.names().len()];
        self.schema.sides().iter().for_each(|&side| uses[side.unsigned_abs() as usize - 1] += 1);
        // Letters that are glued have colors one after the other.
        let mut next = 0;
        let colors: Vec<Color> = uses
            .iter()
            .map(|&uses| {
                if uses < 2 {
                    return LIGHT.ink;
                }
                next += 1;
                color_of_many(next - 1)
            })
            .collect();
        for (side, &letter) in self.schema.sides().iter().enumerate() {
            self.draw_side(picture, side, letter, colors[letter.unsigned_abs() as usize - 1]);
        }
        self.draw_corners(picture);
        self.draw_words(picture);
    }

    /// The size of letters that have room at their sides.
    fn letter_size(&self) -> f64 {
        (0.62 * TAU * RADIUS / self.count() as f64).clamp(5.0, 24.0)
    }

    fn draw_side(&self, picture: &mut FlatPicture, side: usize, letter: i32, ink: Color) {
        let name = &self.schema.names()[letter.unsigned_abs() as usize - 1];
        let exponent = if letter < 0 { "-1" } else { "" };
        picture.begin_group(&format!("side {side}: {name}{}", if letter < 0 { "^-1" } else { "" }));
        let points = self.points(side);
        let mut path: Vec<Step> = points.iter().copied().map(Step::Line).collect();
        path[0] = Step::Move(points[0]);
        picture.line(path, ink, 3.0, 1.0);
        // The arrow is in the middle, along the letter.
        let angle = self.angle(side as f64 + 0.5);
        let half = points.len() / 2;
        let middle = if points.len() == 2 {
            [0, 1].map(|i| f64::midpoint(points[0][i], points[1][i]))
        } else {
            points[half]
        };
        let forward = if letter > 0 { 1.0 } else { -1.0 };
        let along = [-forward * angle.sin(), -forward * angle.cos()];
        let length = (0.4 * TAU * RADIUS / self.count() as f64).min(18.0);
        let corner = |ahead: f64, aside: f64| {
            [
                middle[0] + length * (ahead * along[0] - aside * along[1]),
                middle[1] + length * (ahead * along[1] + aside * along[0]),
            ]
        };
        let [tip, left, right] = [corner(0.55, 0.0), corner(-0.45, 0.42), corner(-0.45, -0.42)];
        picture.fill(vec![Step::Move(tip), Step::Line(left), Step::Line(right), Step::Close], ink, 1.0);
        let size = self.letter_size();
        let reach = (middle[0] - self.middle[0]).hypot(middle[1] - self.middle[1]);
        let [x, y] = self.at(angle, reach + 8.0 + 0.9 * size);
        picture.formula([x, y + 0.3 * size], Anchor::Middle, size, ink, letter_formula(name, exponent));
    }

    fn draw_corners(&self, picture: &mut FlatPicture) {
        let classes = self.schema.corner_classes();
        let count = classes.iter().max().map_or(0, |most| most + 1);
        picture.begin_group("corners");
        for (corner, class) in classes.iter().enumerate() {
            let angle = self.angle(corner as f64);
            picture.disk(self.at(angle, RADIUS), 4.5, LIGHT.ink, None);
            if self.count() <= MOST_NAMED {
                let [x, y] = self.at(angle, RADIUS - 22.0);
                let index = if count > 1 { (class + 1).to_string() } else { String::new() };
                let name = Formula::default().italic("P").scripts(&index, "");
                picture.formula([x, y + 5.0], Anchor::Middle, 15.0, LIGHT.ink, name);
            }
        }
    }

    /// The surface in the middle, and the word below.
    fn draw_words(&self, picture: &mut FlatPicture) {
        let classes = self.schema.corner_classes().iter().max().map_or(0, |most| most + 1);
        let name =
            self.schema.surface().map_or_else(|| "not a surface".to_owned(), |surface| surface.to_string());
        let [x, y] = self.middle;
        // Long names in two lines.
        let (first, second) = match name.find(" with ").or_else(|| name.find(" and ")) {
            Some(place) => name.split_at(place),
            None => (&name[..], ""),
        };
        picture.begin_group("surface");
        picture.text([x, y - 4.0], Anchor::Middle, 16.0, LIGHT.ink, first);
        if !second.is_empty() {
            picture.text([x, y + 14.0], Anchor::Middle, 13.0, LIGHT.ink, second.trim());
        }
        let corners = if classes == 1 { "all corners are one point" } else { "corners are glued to" };
        let below = if second.is_empty() { y + 16.0 } else { y + 34.0 };
        let words = if classes == 1 { corners.to_owned() } else { format!("{corners} {classes} points") };
        picture.text([x, below], Anchor::Middle, 12.0, LIGHT.edge, words);
        if self.count() > MOST_LETTERS {
            return;
        }
        let mut word = Formula::default();
        for (place, &side) in self.schema.sides().iter().enumerate() {
            let name = &self.schema.names()[side.unsigned_abs() as usize - 1];
            let spaced = if place > 0 { word.space(0.22) } else { word };
            word = with_letter(spaced, name, if side < 0 { "-1" } else { "" });
        }
        let foot = y + RADIUS + MARGIN + 0.5 * FOOT;
        picture.formula([x, foot], Anchor::Middle, 20.0, LIGHT.ink, word);
    }
}

/// A letter with its digits as an index.
fn letter_formula(name: &str, exponent: &str) -> Formula {
    with_letter(Formula::default(), name, exponent)
}

fn with_letter(formula: Formula, name: &str, exponent: &str) -> Formula {
    let digits = name.find(|c: char| c.is_ascii_digit()).unwrap_or(name.len());
    formula.italic(&name[..digits]).scripts(&name[digits..], exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn svg(words: &[&str]) -> String {
        let schemas: Vec<PolygonSchema> = words.iter().map(|word| word.parse().unwrap()).collect();
        schema_picture("polygons", &schemas).unwrap().svg(None).unwrap()
    }

    /// The colors of the sides, in their order.
    fn side_colors(svg: &str) -> Vec<&str> {
        let sides = svg.lines().filter(|line| line.contains("stroke-linecap"));
        sides.filter_map(|line| line.split("stroke=\"").nth(1)?.get(..7)).collect()
    }

    #[test]
    fn each_pair_has_a_color_and_each_side_a_line_an_arrow_and_a_letter() {
        let torus = svg(&["a b a^-1 b^-1"]);
        let colors = side_colors(&torus);
        assert_eq!(colors.len(), 4);
        assert!(colors[0] == colors[2] && colors[1] == colors[3] && colors[0] != colors[1]);
        assert_eq!(torus.matches("<circle").count(), 4);
        // Letters of the sides, those of the word below, and the names of the corners.
        assert_eq!(torus.matches("font-style=\"italic\">a</tspan>").count(), 4);
        assert_eq!(torus.matches("font-style=\"italic\">P</tspan>").count(), 4);
        assert!(torus.contains(">torus</text>") && torus.contains("all corners are one point"));
    }

    #[test]
    fn arrows_of_glued_sides_agree_with_their_letters() {
        // The first side of a torus is at the bottom and runs to the right; the third at the top runs to the left, its letter to the right.
        let torus = svg(&["a b a^-1 b^-1"]);
        let heads: Vec<Vec<f64>> = torus
            .lines()
            .filter(|line| line.contains("evenodd") && line.matches('L').count() == 2)
            .map(|line| {
                let data = line.split(" d=\"").nth(1).unwrap().trim_end_matches("Z\"/>");
                data.split(['M', 'L', ' ']).filter_map(|number| number.parse().ok()).collect()
            })
            .collect();
        assert_eq!(heads.len(), 4);
        let points_right = |head: &[f64]| head[0] > head[2] + 5.0 && head[0] > head[4] + 5.0;
        let points_up = |head: &[f64]| head[1] < head[3] - 5.0 && head[1] < head[5] - 5.0;
        assert!(points_right(&heads[0]) && points_right(&heads[2]));
        assert!(points_up(&heads[1]) && points_up(&heads[3]));
    }

    #[test]
    fn corners_of_one_class_have_one_name() {
        let plane = svg(&["a b a b"]);
        assert_eq!((plane.matches(">1</tspan>").count(), plane.matches(">2</tspan>").count()), (2, 2));
        assert!(plane.contains("projective plane") && plane.contains("corners are glued to 2 points"));
    }

    #[test]
    fn all_sorts_of_polygons_are_drawn() {
        for (word, sides) in
            [("a", 1), ("a a^-1", 2), ("a a", 2), ("a a a", 3), ("a1 b1 a1^-1 b1^-1 e1 d1 e1^-1", 7)]
        {
            let svg = svg(&[word]);
            assert_eq!(side_colors(&svg).len(), sides, "{word}");
            assert!(!svg.contains("NaN"), "{word}");
        }
        let many = svg(&["a b a^-1 b^-1", "c c", "s s^-1"]);
        assert_eq!(side_colors(&many).len(), 8);
        // Twelve pairs have twelve colors.
        let letters = "abcdefghijkl".chars().map(|c| format!("{c}{c}")).collect::<String>();
        let twelve = svg(&[&letters]);
        let mut colors = side_colors(&twelve);
        colors.sort_unstable();
        colors.dedup();
        assert_eq!(colors.len(), 12);
    }

    #[test]
    fn too_much_is_refused() {
        assert!(schema_picture("none", &[]).is_err());
        let long: PolygonSchema = "a^401".parse().unwrap();
        assert_eq!(schema_picture("long", &[long]).unwrap_err().kind(), ErrorKind::TooLarge);
        let many = vec!["a a".parse().unwrap(); 31];
        assert_eq!(schema_picture("many", &many).unwrap_err().kind(), ErrorKind::TooLarge);
    }
}
