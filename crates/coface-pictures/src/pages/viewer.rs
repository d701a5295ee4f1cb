//! The interactive page of a scene: one file that needs no network.

use crate::SceneDocument;
use coface_answers::answer::to_json;

/// The page without a scene. It is made from the sources in `viewer/`.
const PAGE: &str = include_str!("../../page/viewer.html");

/// What stands in the page where the scene belongs.
const PLACE: &str = r#"<script type="application/json" id="scene">null</script>"#;

/// The page with a scene in it.
///
/// # Examples
/// ```
/// use coface_io::{Format, read};
/// use coface_pictures::{Scene, pages::viewer::page_of};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
/// let page = page_of(&Scene::of("a triangle", &triangle)?.document());
/// assert!(page.starts_with("<!doctype html>") && page.contains("a triangle"));
/// # Ok(()) }
/// ```
pub fn page_of(scene: &SceneDocument) -> String {
    // No text in the scene can end the element that it stands in, nor begin a comment there. Outside of strings JSON has no such sign.
    let text = to_json(scene).replace('<', "\\u003c");
    PAGE.replacen(PLACE, &format!(r#"<script type="application/json" id="scene">{text}</script>"#), 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Scene;
    use coface_io::{Format, read};

    #[test]
    fn the_page_has_a_place_for_the_scene() {
        assert_eq!(PAGE.matches(PLACE).count(), 1);
        let point = read(&b"v 0 0 0\np 1\n"[..], Format::Obj).unwrap();
        let page = page_of(&Scene::of("</script>", &point).unwrap().document());
        assert!(page.contains(r#""title":"\u003c/script>""#));
    }
}
