//! The interactive page of a scene: one file that needs no network.

use serde_json::Value;

/// The page without a scene. It is made from the sources in `viewer/`.
const PAGE: &str = include_str!("../../page/viewer.html");

/// What stands in the page where the scene belongs.
const PLACE: &str = r#"<script type="application/json" id="scene">null</script>"#;

/// The page with a scene in it, the JSON of a `coface_pictures::Scene`.
///
/// # Examples
/// ```
/// let page = coface_pictures::pages::viewer::page_of(&serde_json::json!({"title": "a cube"}));
/// assert!(page.starts_with("<!doctype html>") && page.contains("a cube"));
/// ```
pub fn page_of(scene: &Value) -> String {
    // No text in the scene can end the element that it stands in, nor begin a comment there. Outside of strings JSON has no such sign.
    let text = scene.to_string().replace('<', "\\u003c");
    PAGE.replacen(PLACE, &format!(r#"<script type="application/json" id="scene">{text}</script>"#), 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn the_page_has_a_place_for_the_scene() {
        assert_eq!(PAGE.matches(PLACE).count(), 1);
        let page = page_of(&json!({"title": "</script>"}));
        assert!(page.contains(r#"{"title":"\u003c/script>"}"#));
    }
}
