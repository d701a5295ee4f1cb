//! The whole book as one page that needs no network, and the check of all links.

use super::{Chapter, Task, formulas, keep, source};
use crate::root;
use pulldown_cmark::{CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, html};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};

/// Where the page is, in the repository.
const PAGE: &str = "docs/book.html";

/// The most bytes that the page may have.
const MOST: usize = 6_000_000;

/// How the page looks, by day and by night.
const STYLE: &str = "body{margin:0;font:16px/1.55 system-ui,sans-serif;color:#1c2430;background:#fff}\
nav{position:fixed;inset:0 auto 0 0;width:17rem;overflow:auto;padding:1rem;box-sizing:border-box;border-right:1px solid #d5dae1;font-size:14px}\
nav a{display:block;padding:.15rem 0}main{margin-left:17rem;padding:1rem 2.5rem 6rem;max-width:52rem}\
a{color:#0b5cad;text-decoration:none}a:hover{text-decoration:underline}pre{background:#f4f6f9;padding:.7rem .9rem;overflow:auto;font-size:13.5px;line-height:1.4}\
code{font-family:ui-monospace,monospace;font-size:.92em}table{border-collapse:collapse;display:block;overflow:auto}td,th{border:1px solid #d5dae1;padding:.3rem .6rem;vertical-align:top;text-align:left}\
img{max-width:100%;background:#fff}h1{margin-top:4rem;border-top:3px solid #0b5cad;padding-top:1rem}.m{font-family:serif;white-space:nowrap}.d{display:block;margin:1rem 2rem}\
@media(max-width:900px){nav{position:static;width:auto}main{margin:0;padding:1rem}}\
@media(prefers-color-scheme:dark){body{background:#14181e;color:#dde3ea}pre{background:#1e242c}a{color:#7db7f0}td,th,nav{border-color:#39424e}}\
@media print{nav{display:none}main{margin:0;max-width:none}}";

/// Sets the formulas with KaTeX where the page can load it; else they stay as the text that they are.
const SCRIPT: &str = "document.addEventListener('DOMContentLoaded',function(){if(typeof katex==='undefined')return;\
document.querySelectorAll('[data-tex]').forEach(function(e){katex.render(e.dataset.tex,e,{throwOnError:false,displayMode:e.className==='m d'})})})";

/// Writes the page, and returns the links that lead nowhere.
pub(super) fn page(chapters: &[Chapter], task: Task) -> Vec<String> {
    let mut faults = Vec::new();
    let names: BTreeSet<&str> = chapters.iter().map(|chapter| chapter.name.as_str()).collect();
    let anchors: BTreeMap<&str, BTreeMap<String, String>> =
        chapters.iter().map(|chapter| (chapter.name.as_str(), headings(&chapter.text))).collect();
    let mut body = String::new();
    let mut contents = String::new();
    for chapter in chapters {
        let indent = "&nbsp;&nbsp;&nbsp;".repeat(chapter.depth);
        contents.push_str(&format!("<a href=\"#{}\">{indent}{}</a>\n", chapter.name, chapter.title));
        let events = events(chapter, &names, &anchors, &mut faults);
        html::push_html(&mut body, events.into_iter());
    }
    let unnamed = fs::read_dir(source()).into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path()));
    for path in unnamed.filter(|path| path.extension().is_some_and(|extension| extension == "md")) {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if stem != "SUMMARY" && !names.contains(stem.as_str()) {
            faults.push(format!("SUMMARY.md does not name {stem}.md"));
        }
    }
    let katex = "https://cdn.jsdelivr.net/npm/katex@0.16.22/dist/katex.min";
    let text = format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">\
         <title>The coface book</title><style>{STYLE}</style>\n<link rel=\"stylesheet\" href=\"{katex}.css\" crossorigin=\"anonymous\">\
         <script defer src=\"{katex}.js\" crossorigin=\"anonymous\"></script><script>{SCRIPT}</script></head>\n\
         <body><nav><b>The coface book</b>\n{contents}</nav>\n<main>\n{body}</main></body></html>\n"
    );
    if text.len() > MOST {
        faults.push(format!("{PAGE} would have {} bytes, more than {MOST}", text.len()));
    }
    faults.extend(keep(&root().join(PAGE), &text, task != Task::Check));
    faults
}

fn parser(text: &str) -> Parser<'_> {
    Parser::new_ext(text, Options::ENABLE_TABLES | Options::ENABLE_MATH | Options::ENABLE_FOOTNOTES)
}

/// The headings of a text, by their names in links.
pub(super) fn headings(text: &str) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    let mut heading: Option<String> = None;
    for event in parser(text) {
        match event {
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::End(TagEnd::Heading(_)) => found.extend(heading.take().map(|said| (slug(&said), said))),
            Event::Text(said) | Event::Code(said) => {
                if let Some(heading) = &mut heading {
                    heading.push_str(&said);
                }
            }
            _ => {}
        }
    }
    found
}

/// The name of a heading in links, as mdBook makes it.
fn slug(heading: &str) -> String {
    let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect::<String>().to_lowercase()
}

/// The events of a chapter with links, pictures, headings and formulas as the one page has them.
fn events<'a>(
    chapter: &'a Chapter,
    names: &BTreeSet<&str>,
    anchors: &BTreeMap<&str, BTreeMap<String, String>>,
    faults: &mut Vec<String>,
) -> Vec<Event<'a>> {
    let mut out: Vec<Event<'a>> = Vec::new();
    let mut heading: Option<(usize, HeadingLevel, String)> = None;
    for event in parser(&chapter.text) {
        match event {
            Event::Start(Tag::Heading { level, .. }) => {
                heading = Some((out.len(), level, String::new()));
                out.push(Event::Html(CowStr::from("")));
            }
            Event::End(TagEnd::Heading(level)) => {
                if let Some((at, level, said)) = heading.take() {
                    let id = match level {
                        HeadingLevel::H1 => chapter.name.clone(),
                        _ => format!("{}-{}", chapter.name, slug(&said)),
                    };
                    out[at] = Event::Html(format!("<{level} id=\"{id}\">").into());
                }
                out.push(Event::Html(format!("</{level}>\n").into()));
            }
            Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
                let dest_url = match target(&dest_url, chapter, names, anchors) {
                    Ok(target) => target.into(),
                    Err(why) => {
                        faults.push(format!("{}.md: the link {dest_url:?} is dead: {why}", chapter.name));
                        dest_url
                    }
                };
                out.push(Event::Start(Tag::Link { link_type, dest_url, title, id }));
            }
            Event::Start(Tag::Image { link_type, dest_url, title, id }) => {
                let dest_url = match inlined(&dest_url) {
                    Ok(target) => target.into(),
                    Err(why) => {
                        faults
                            .push(format!("{}.md: the picture {dest_url:?} is missing: {why}", chapter.name));
                        dest_url
                    }
                };
                out.push(Event::Start(Tag::Image { link_type, dest_url, title, id }));
            }
            Event::InlineMath(tex) => out.push(formula(&tex, "m")),
            Event::DisplayMath(tex) => out.push(formula(&tex, "m d")),
            event => {
                if let (Some((_, _, heading)), Event::Text(said) | Event::Code(said)) = (&mut heading, &event)
                {
                    heading.push_str(said);
                }
                out.push(event);
            }
        }
    }
    out
}

fn formula(tex: &str, class: &str) -> Event<'static> {
    let escaped = tex.replace('&', "&amp;").replace('"', "&quot;").replace('<', "&lt;");
    Event::InlineHtml(
        format!("<span class=\"{class}\" data-tex=\"{escaped}\">{}</span>", formulas::readable(tex)).into(),
    )
}

/// Where a link of a chapter leads on the one page.
fn target(
    link: &str,
    chapter: &Chapter,
    names: &BTreeSet<&str>,
    anchors: &BTreeMap<&str, BTreeMap<String, String>>,
) -> Result<String, String> {
    if link.starts_with("https://") || link.starts_with("mailto:") {
        return Ok(link.to_owned());
    }
    let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
    let name = if file.is_empty() { chapter.name.as_str() } else { file.trim_end_matches(".md") };
    if (file.is_empty() || file.ends_with(".md")) && names.contains(name) {
        if anchor.is_empty() {
            return Ok(format!("#{name}"));
        }
        return match anchors.get(name) {
            Some(found) if found.contains_key(anchor) => Ok(format!("#{name}-{anchor}")),
            _ => Err(format!("{name}.md has no heading of that name")),
        };
    }
    let path = plain(&source().join(file));
    if !path.exists() {
        return Err("there is no such file".to_owned());
    }
    let inside = path.strip_prefix(root().join("docs")).map(|rest| rest.display().to_string());
    inside.or_else(|_| {
        let rest = path.strip_prefix(root()).map_err(|_| "it leads out of the repository".to_owned())?;
        Ok(format!("../{}", rest.display()))
    })
}

/// The path without `..`.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        if part == Component::ParentDir {
            plain.pop();
        } else {
            plain.push(part);
        }
    }
    plain
}

/// A picture as a link that holds it.
fn inlined(link: &str) -> Result<String, String> {
    let bytes = fs::read(plain(&source().join(link))).map_err(|error| error.to_string())?;
    let kind = if link.ends_with(".svg") { "svg+xml" } else { "png" };
    Ok(format!("data:image/{kind};base64,{}", base64(&bytes)))
}

fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for chunk in bytes.chunks(3) {
        let word = (0..3).fold(0_u32, |word, i| word << 8 | u32::from(chunk.get(i).copied().unwrap_or(0)));
        for i in 0..4 {
            let letter = LETTERS[(word >> (18 - 6 * i)) as usize & 63];
            text.push(if i <= chunk.len() { char::from(letter) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{base64, slug};

    #[test]
    fn bytes_are_written_as_in_rfc_4648() {
        assert_eq!(base64(b"foobar"), "Zm9vYmFy");
        assert_eq!(base64(b"fo"), "Zm8=");
        assert_eq!(base64(b"f"), "Zg==");
    }

    #[test]
    fn headings_have_the_names_that_links_use() {
        assert_eq!(slug("Step 1: the dual mesh"), "step-1-the-dual-mesh");
    }
}
