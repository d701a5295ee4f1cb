//! The report as a page for browsers: tables of facts and pictures, in one file that needs no network.

use crate::{Picture, PictureStyle, Scene};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use coface_algebra::Error;
use coface_answers::text::{Emphasis, Item};
use std::fmt::Write;

const HEAD: &str = r#"<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
"#;

/// How facts and pictures are set.
const STYLE: &str = r#"<style>
:root { --paper: #ffffff; --ink: #22272d; --pale: #5c6670; --line: #d9dee4; --good: #00704f; --bad: #b00218; --odd: #8a5300; }
@media (prefers-color-scheme: dark) {
:root { --paper: #15181c; --ink: #e4e8ec; --pale: #9aa4ae; --line: #333a42; --good: #4cc79c; --bad: #ff7b87; --odd: #f0b14a; }
}
body { margin: 2rem auto; max-width: 62rem; padding: 0 1rem; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.4rem; margin: 2rem 0 0; overflow-wrap: anywhere; }
h1 small { color: var(--pale); font-weight: normal; margin-left: .6rem; }
h2 { font-size: 1.1rem; margin: 1.5rem 0 .5rem; }
table { border-collapse: collapse; width: 100%; }
th, td { border-top: 1px solid var(--line); padding: .3rem .8rem .3rem 0; text-align: left; vertical-align: top; font-weight: normal; }
th { color: var(--pale); white-space: nowrap; }
td.gloss, p.gloss { color: var(--pale); }
.good { color: var(--good); } .bad { color: var(--bad); } .odd { color: var(--odd); }
p.place { margin: 0 0 0 1.5rem; font-family: ui-monospace, monospace; font-size: .9rem; }
figure { margin: 1rem 0; }
figure svg, figure img { max-width: 100%; height: auto; border: 1px solid var(--line); border-radius: 4px; background: #ffffff; }
@media (prefers-color-scheme: dark) {
figure svg, figure img { filter: invert(1) hue-rotate(180deg); }
}
@media (max-width: 40rem) {
body { margin: 1rem auto; }
table, tbody, tr, th, td { display: block; border: 0; padding: 0; }
tr { border-top: 1px solid var(--line); padding: .3rem 0; }
}
figcaption, summary { color: var(--pale); }
pre { overflow-x: auto; font-size: .8rem; }
</style>
"#;

/// A picture on a page.
#[derive(Debug)]
pub enum Figure {
    /// SVG, as it stands.
    Svg(String),
    /// PNG as base64.
    Png(String),
}

/// With more triangles than this, a picture is PNG: SVG would be larger.
const TRIANGLES_AS_SVG: usize = 3000;
/// The size of pictures on a page, in pixels.
const SIZE: [usize; 2] = [800, 560];

impl Figure {
    /// A still picture of a scene from where it is seen first: SVG of few triangles, PNG of many.
    ///
    /// # Errors
    /// Those of [`Picture::new`] and [`Picture::png`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, read};
    /// use coface_pictures::{Scene, pages::html::Figure};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// let figure = Figure::of(&Scene::of("a triangle", &triangle)?)?;
    /// assert!(matches!(figure, Figure::Svg(text) if text.starts_with("<svg")));
    /// # Ok(()) }
    /// ```
    pub fn of(scene: &Scene) -> Result<Self, Error> {
        let style = PictureStyle { size: SIZE, ..PictureStyle::default() };
        let picture = Picture::new(scene, &style)?;
        Ok(if scene.triangles().len() <= TRIANGLES_AS_SVG {
            Self::Svg(picture.svg())
        } else {
            Self::Png(STANDARD.encode(picture.png()?))
        })
    }
}

/// A model on a page.
#[derive(Debug)]
pub struct Section {
    /// What is said.
    pub items: Vec<Item>,
    /// Pictures with their captions; they stand below the summary.
    pub figures: Vec<(Figure, String)>,
    /// The report for programs.
    pub object: String,
}

/// The page about some models.
///
/// # Examples
/// ```
/// assert!(coface_pictures::pages::html::page("A & B", &[]).contains("<title>A &amp; B</title>"));
/// ```
pub fn page(title: &str, sections: &[Section]) -> String {
    let mut page = format!("{HEAD}{STYLE}<title>{}</title>\n</head>\n<body>\n", escaped(title));
    for section in sections {
        push_section(&mut page, section);
    }
    page += "</body>\n</html>\n";
    page
}

/// A model with its style, to be read where a page cannot run its script.
pub(super) fn plain(section: &Section) -> String {
    let mut text = STYLE.to_owned();
    push_section(&mut text, section);
    text
}

fn push_section(page: &mut String, section: &Section) {
    *page += "<article>\n";
    let (head, rest) = section.items.split_at(section.items.len().min(2));
    push_items(page, head);
    for (figure, caption) in &section.figures {
        *page += "<figure>\n";
        match figure {
            Figure::Svg(text) => *page += text,
            Figure::Png(text) => {
                let _ =
                    writeln!(page, "<img alt=\"{}\" src=\"data:image/png;base64,{text}\">", escaped(caption));
            }
        }
        let _ = writeln!(page, "<figcaption>{}</figcaption>\n</figure>", escaped(caption));
    }
    push_items(page, rest);
    let _ = writeln!(
        page,
        "<details><summary>for programs</summary><pre>{}</pre></details>\n</article>",
        escaped(&section.object)
    );
}

fn push_items(page: &mut String, items: &[Item]) {
    let mut in_table = false;
    for item in items {
        let is_fact = matches!(item, Item::Fact { .. });
        if is_fact != in_table {
            page.push_str(if is_fact { "<table>\n" } else { "</table>\n" });
            in_table = is_fact;
        }
        // Writing to a string does not fail.
        let _ = match item {
            Item::Title(name, gloss) => {
                writeln!(page, "<h1>{}<small>{}</small></h1>", escaped(name), escaped(gloss))
            }
            Item::Heading(words) => writeln!(page, "<h2>{}</h2>", escaped(words)),
            Item::Blank => Ok(()),
            Item::Paragraph { indent, emphasis, words } => {
                let place = if *indent > 4 && *emphasis == Emphasis::Plain { " place" } else { "" };
                writeln!(page, "<p class=\"{}{place}\">{}</p>", class(*emphasis), escaped(words))
            }
            Item::Bullet { emphasis, words } => {
                writeln!(page, "<p class=\"{}\">{}</p>", class(*emphasis), escaped(words))
            }
            Item::Fact { label, emphasis, value, gloss } => writeln!(
                page,
                "<tr><th scope=\"row\">{}</th><td class=\"{}\">{}</td><td class=\"gloss\">{}</td></tr>",
                escaped(label),
                class(*emphasis),
                escaped(value),
                escaped(gloss)
            ),
        };
    }
    if in_table {
        page.push_str("</table>\n");
    }
}

fn class(emphasis: Emphasis) -> &'static str {
    match emphasis {
        Emphasis::Plain => "plain",
        Emphasis::Good => "good",
        Emphasis::Bad => "bad",
        Emphasis::Odd => "odd",
        Emphasis::Gloss => "gloss",
    }
}

/// Text that can stand in HTML; control characters are left out.
fn escaped(text: &str) -> String {
    let text: String = text.chars().filter(|&c| c == '\n' || !c.is_control()).collect();
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_do_not_break_the_page() {
        let items = vec![Item::Title("<script>&\u{1}".to_owned(), "OFF".to_owned())];
        let section = Section { items, figures: Vec::new(), object: "{\"a\": \"</pre>\"}".to_owned() };
        let page = page("<b>", &[section]);
        assert!(!page.contains("<script>") && !page.contains("<b>") && page.contains("&lt;/pre&gt;"));
        assert_eq!(page.matches("<h1>&lt;script&gt;&amp;<small>").count(), 1);
    }
}
