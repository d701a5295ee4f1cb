//! The interactive page of a scene: one file that needs no network.

use super::html::{Section, plain};
use crate::SceneDocument;
use coface_answers::answer::to_json;

/// The page without a scene. It is made from the sources in `viewer/`.
const PAGE: &str = include_str!("../../page/viewer.html");

/// What stands in the page where the scene belongs.
const PLACE: &str = r#"<script type="application/json" id="scene">null</script>"#;

/// What stands in the page where the facts belong that are read without a script.
const STILL: &str = r#"<noscript id="still"></noscript>"#;

/// The page with a scene in it, and with a report and still pictures for browsers that run no script.
///
/// # Examples
/// ```
/// use coface_io::{Format, read};
/// use coface_pictures::{Scene, pages::viewer::page_of};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
/// let page = page_of(&Scene::of("a triangle", &triangle)?.document(), None);
/// assert!(page.starts_with("<!doctype html>") && page.contains("a triangle"));
/// # Ok(()) }
/// ```
pub fn page_of(scene: &SceneDocument, still: Option<&Section>) -> String {
    // No text in the scene can end the element that it stands in, nor begin a comment there. Outside of strings JSON has no such sign.
    let text = to_json(scene).replace('<', "\\u003c");
    let page =
        PAGE.replacen(PLACE, &format!(r#"<script type="application/json" id="scene">{text}</script>"#), 1);
    match still {
        Some(section) => {
            page.replacen(STILL, &format!("<noscript>{SCROLLING}{}</noscript>", plain(section)), 1)
        }
        None => page,
    }
}

/// Without a script the facts have the window for themselves.
const SCROLLING: &str =
    "<style>#window, #panel { display: none } body { display: block; height: auto; overflow: auto }</style>";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Scene;
    use coface_answers::text::Item;
    use coface_io::{Format, read};

    #[test]
    fn the_page_has_a_place_for_the_scene() {
        assert_eq!((PAGE.matches(PLACE).count(), PAGE.matches(STILL).count()), (1, 1));
        let point = read(&b"v 0 0 0\np 1\n"[..], Format::Obj).unwrap();
        let page = page_of(&Scene::of("</script>", &point).unwrap().document(), None);
        assert!(page.contains(r#""title":"\u003c/script>""#));
    }
    #[test]
    fn the_page_can_be_read_without_a_script() {
        let point = read(&b"v 0 0 0\np 1\n"[..], Format::Obj).unwrap();
        let items = vec![Item::Title("</noscript><b>".to_owned(), "OBJ".to_owned())];
        let still = Section { items, figures: Vec::new(), object: "{}".to_owned() };
        let page = page_of(&Scene::of("point", &point).unwrap().document(), Some(&still));
        assert!(page.contains("&lt;/noscript&gt;&lt;b&gt;") && !page.contains("</noscript><b>"));
    }
}
