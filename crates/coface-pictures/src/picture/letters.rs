//! Letters as strokes, for pictures that have no fonts.

/// The strokes of a letter on a grid of 5 columns, lines from 0 (the lowest descender) to 8 (the height of capitals); the baseline is 2, and 6 the
/// height of small letters. Each digit pair is a column and a line, blanks separate strokes.
fn glyph(letter: char) -> &'static str {
    match letter {
        ' ' => "",
        'A' => "022842 1434",
        'B' => "02083847463505 3544433202",
        'C' => "4738180703123243",
        'D' => "02082846442202",
        'E' => "48080242 0535",
        'F' => "480802 0535",
        'G' => "47381807031232434525",
        'H' => "0208 4248 0545",
        'I' => "1838 2822 1232",
        'J' => "4843321203",
        'K' => "0208 480542",
        'L' => "080242",
        'M' => "0208254842",
        'N' => "02084248",
        'O' => "180703123243473818",
        'P' => "02083847463505",
        'Q' => "180703123243473818 2442",
        'R' => "02083847463505 2542",
        'S' => "473818070615354443321203",
        'T' => "0848 2822",
        'U' => "080312324348",
        'V' => "082248",
        'W' => "0812253248",
        'X' => "0842 0248",
        'Y' => "082548 2522",
        'Z' => "08480242",
        'a' => "16364542 441403123243",
        'b' => "0802 0516364543321203",
        'c' => "4536160503123243",
        'd' => "4842 4536160503123243",
        'e' => "04444536160503123243",
        'f' => "38281712 0636",
        'g' => "46413010 4536160503123243",
        'h' => "0802 0516364542",
        'i' => "2622 2728",
        'j' => "262110 2728",
        'k' => "0802 460442",
        'l' => "182822 1232",
        'm' => "0602 05162522 25364542",
        'n' => "0602 0516364542",
        'o' => "160503123243453616",
        'p' => "0600 0516364543321203",
        'q' => "4640 4536160503123243",
        'r' => "0602 05163645",
        's' => "45361605143443321203",
        't' => "18132232 0636",
        'u' => "060312324346 4642",
        'v' => "062246",
        'w' => "0612243246",
        'x' => "0642 0246",
        'y' => "0622 4610",
        'z' => "06460242",
        '0' => "180703123243473818 1337",
        '1' => "072822 1232",
        '2' => "07183847460242",
        '3' => "07183847463525 354443321203",
        '4' => "32380444",
        '5' => "480805354443321203",
        '6' => "38180603123243443505",
        '7' => "084822",
        '8' => "15060718384746351504031232434435",
        '9' => "12324447381807061545",
        '.' => "2223",
        ',' => "2311",
        ':' => "2223 2526",
        ';' => "2311 2526",
        '-' => "0545",
        '+' => "0545 2327",
        '=' => "0444 0646",
        '/' => "0248",
        '(' => "38261432",
        ')' => "18263412",
        '[' => "38181232",
        ']' => "18383212",
        '{' => "38282615242232",
        '}' => "18282635242212",
        '<' => "470543",
        '>' => "074503",
        '_' => "0141",
        '*' => "2327 0644 0446",
        '^' => "062846",
        '\'' => "2826",
        '"' => "1816 3836",
        '#' => "1218 3238 0444 0646",
        '%' => "0248 0718 3243",
        '!' => "2825 2322",
        '?' => "07183847362524 2322",
        '|' => "2820",
        '$' => "473818070615354443321203 2820",
        '&' => "42071828370403122244",
        '@' => "421203071838474434 343626152434",
        '\\' => "0842",
        '`' => "1827",
        '~' => "04153445",
        '\u{207b}' => "1737",
        '\u{b9}' => "172824",
        '\u{b2}' => "1728371434",
        '\u{b3}' => "183826352414",
        '\u{2212}' => "0444",
        '\u{2295}' => "163645433212030516 0444 2622",
        '\u{2202}' => "172838464432120304153544",
        '\u{2245}' => "06173647 0444 0242",
        '\u{2192}' => "0444 364432",
        '\u{d7}' => "0642 0246",
        '\u{2217}' => "2327 0644 0446",
        // Of what has no strokes here, a box.
        _ => "0802424808",
    }
}

/// The strokes of an accent, the letters that have it, and these without it.
const ACCENTS: [(&str, &str, &str); 7] = [
    ("1827", "\u{c0}\u{c8}\u{cc}\u{d2}\u{d9}\u{e0}\u{e8}\u{ec}\u{f2}\u{f9}", "AEIOUaeiou"),
    ("2738", "\u{c1}\u{c9}\u{cd}\u{d3}\u{da}\u{dd}\u{e1}\u{e9}\u{ed}\u{f3}\u{fa}\u{fd}", "AEIOUYaeiouy"),
    ("172837", "\u{c2}\u{ca}\u{ce}\u{d4}\u{db}\u{e2}\u{ea}\u{ee}\u{f4}\u{fb}", "AEIOUaeiou"),
    ("07183748", "\u{c3}\u{d1}\u{d5}\u{e3}\u{f1}\u{f5}", "ANOano"),
    ("1718 3738", "\u{c4}\u{cb}\u{cf}\u{d6}\u{dc}\u{e4}\u{eb}\u{ef}\u{f6}\u{fc}\u{ff}", "AEIOUaeiouy"),
    ("1728372617", "\u{c5}\u{e5}", "Aa"),
    ("222110", "\u{c7}\u{e7}", "Cc"),
];

/// A letter of Latin-1 without its accent, and the strokes of that.
pub(super) fn without_accent(letter: char) -> (char, &'static str) {
    let found = ACCENTS.iter().find_map(|&(accent, letters, plain)| {
        let place = letters.chars().position(|other| other == letter)?;
        Some((plain.chars().nth(place)?, accent))
    });
    found.unwrap_or((letter, ""))
}

/// From a letter to the next, for a size of 1.
const ADVANCE: f64 = 0.6;
/// A step of the grid, for a size of 1.
const STEP: f64 = 0.72 / 6.0;

/// The width of a text of size 1.
pub(super) fn width(text: &str) -> f64 {
    ADVANCE * text.chars().count() as f64
}

/// The strokes of a text of size 1 that begins at 0, second coordinates going up from the baseline.
pub(super) fn strokes(text: &str) -> Vec<Vec<[f64; 2]>> {
    let mut all = Vec::new();
    for (place, letter) in text.chars().enumerate() {
        let left = ADVANCE * place as f64 + 0.06;
        let (plain, accent) = without_accent(letter);
        for stroke in glyph(plain).split(' ').chain(accent.split(' ')).filter(|stroke| !stroke.is_empty()) {
            let digits: Vec<f64> = stroke.bytes().map(|digit| f64::from(digit - b'0')).collect();
            let points = digits.chunks_exact(2).map(|pair| {
                // Columns from 0 to 4.
                [left + 0.115 * pair[0], STEP * (pair[1] - 2.0)]
            });
            all.push(points.collect());
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_stroke_is_pairs_of_digits_on_the_grid() {
        let more = [
            '\u{4e2d}', '\u{2212}', '\u{2295}', '\u{2202}', '\u{2245}', '\u{207b}', '\u{b9}', '\u{b2}',
            '\u{b3}',
        ];
        let glyphs = (' '..='~').chain(more).map(|letter| (letter, glyph(letter)));
        for (letter, glyph) in glyphs.chain(ACCENTS.map(|(accent, ..)| ('\'', accent))) {
            for stroke in glyph.split(' ').filter(|stroke| !stroke.is_empty()) {
                assert!(stroke.len().is_multiple_of(2) && stroke.len() >= 4, "{letter} {stroke}");
                for pair in stroke.as_bytes().chunks_exact(2) {
                    assert!((b'0'..=b'4').contains(&pair[0]), "{letter} {stroke}");
                    assert!((b'0'..=b'8').contains(&pair[1]), "{letter} {stroke}");
                }
            }
        }
    }

    #[test]
    fn no_two_letters_look_the_same() {
        let letters = ('!'..='~').filter(|&letter| letter != '|');
        let mut glyphs: Vec<&str> = letters.map(glyph).collect();
        glyphs.sort_unstable();
        glyphs.dedup();
        assert_eq!(glyphs.len(), 93);
    }

    #[test]
    fn letters_with_accents_are_those_without_and_the_accent() {
        for (_, letters, plain) in ACCENTS {
            assert_eq!(letters.chars().count(), plain.chars().count());
            assert!(plain.is_ascii());
        }
        assert_eq!(without_accent('\u{d6}'), ('O', "1718 3738"));
        assert_eq!(without_accent('x'), ('x', ""));
        assert_eq!(strokes("\u{d6}").len(), strokes("O").len() + 2);
        // What is not known stays a box.
        assert_eq!(strokes("\u{4e2d}").len(), 1);
    }
}
