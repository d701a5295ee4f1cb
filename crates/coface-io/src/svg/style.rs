//! The properties of elements: attributes, style sheets and styles, in the order of CSS.

use roxmltree::{Document, Node};
use std::collections::HashMap;

/// A property that decides what is drawn, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Property {
    Fill,
    FillRule,
    FillOpacity,
    Display,
    Visibility,
    FontSize,
    ClipPath,
    ClipRule,
    Mask,
    MaskType,
    Opacity,
    Stroke,
    Filter,
    Overflow,
    /// A shape or its place that a style says: `transform`, `d`, `r`, `width`, .. An attribute of these names is read elsewhere.
    Geometry,
}

const COUNT: usize = Property::Geometry as usize + 1;

impl Property {
    /// As an attribute.
    fn of_attribute(name: &str) -> Option<Self> {
        Some(match name {
            "fill" => Self::Fill,
            "fill-rule" => Self::FillRule,
            "fill-opacity" => Self::FillOpacity,
            "display" => Self::Display,
            "visibility" => Self::Visibility,
            "font-size" => Self::FontSize,
            "clip-path" => Self::ClipPath,
            "clip-rule" => Self::ClipRule,
            "mask" => Self::Mask,
            "mask-type" => Self::MaskType,
            "opacity" => Self::Opacity,
            "stroke" => Self::Stroke,
            "filter" => Self::Filter,
            "overflow" => Self::Overflow,
            _ => return None,
        })
    }

    /// In a style or a sheet.
    fn of_style(name: &str) -> Option<Self> {
        let name = name.to_ascii_lowercase();
        let of_geometry = match name.as_str() {
            "transform" | "translate" | "rotate" | "scale" | "d" | "x" | "y" | "cx" | "cy" | "r" | "rx"
            | "ry" | "width" | "height" => Some(Self::Geometry),
            _ => None,
        };
        Self::of_attribute(&name).or(of_geometry)
    }
}

/// The values of an element.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Style<'a> {
    values: [Option<&'a str>; COUNT],
}

impl<'a> Style<'a> {
    pub(super) fn of(&self, property: Property) -> Option<&'a str> {
        self.values[property as usize]
    }

    /// Whether the element has a value other than `none`.
    pub(super) fn has(&self, property: Property) -> bool {
        self.of(property).is_some_and(|value| !matches!(value, "none" | "initial" | "unset"))
    }
}

struct Declaration {
    property: Property,
    value: String,
    is_important: bool,
}

/// What one element must be: `rect.a#b`.
#[derive(Debug, Default, PartialEq)]
struct Compound {
    element: Option<String>,
    ids: Vec<String>,
    classes: Vec<String>,
}

impl Compound {
    fn matches(&self, node: Node<'_, '_>) -> bool {
        self.element.as_ref().is_none_or(|name| node.tag_name().name() == name)
            && self.ids.iter().all(|id| node.attribute("id") == Some(id))
            && self.classes.iter().all(|class| classes(node).any(|other| other == class))
    }
}

fn classes<'a>(node: Node<'a, '_>) -> impl Iterator<Item = &'a str> {
    node.attribute("class").unwrap_or_default().split_ascii_whitespace()
}

struct Rule {
    /// The element, its parent or an ancestor, and so on outwards; whether each is the parent of the one before.
    compounds: Vec<(Compound, bool)>,
    specificity: [usize; 3],
    /// The block of its declarations.
    block: usize,
}

impl Rule {
    fn matches(&self, node: Node<'_, '_>) -> bool {
        let mut here = vec![node];
        for (i, (compound, is_parent)) in self.compounds.iter().enumerate() {
            if i > 0 {
                here = match is_parent {
                    true => here.iter().filter_map(Node::parent_element).collect(),
                    // The ancestors of the innermost are those of all.
                    false => here[0].ancestors().skip(1).filter(Node::is_element).collect(),
                };
            }
            here.retain(|node| compound.matches(*node));
            if here.is_empty() {
                return false;
            }
        }
        true
    }
}

/// The style sheets of a drawing.
#[derive(Default)]
pub(super) struct Sheet {
    rules: Vec<Rule>,
    blocks: Vec<Vec<Declaration>>,
    /// The rules whose last part has this identifier, else this class, else this element, else none of them.
    by_key: HashMap<String, Vec<usize>>,
    /// How many rules and sheets that may decide what is drawn are not read.
    pub(super) unread: usize,
}

/// Selectors that nothing matches in a drawing that is not touched.
const NEVER: [&str; 6] = [":hover", ":focus", ":active", ":visited", ":link", "::"];

impl Sheet {
    pub(super) fn of(document: &Document<'_>) -> Self {
        let mut sheet = Self::default();
        for node in document.root().descendants() {
            let is_other = node.pi().is_some_and(|pi| pi.target == "xml-stylesheet");
            sheet.unread += usize::from(is_other);
            let is_css =
                node.attribute("type").is_none_or(|kind| kind.trim() == "text/css" || kind.is_empty());
            let is_print = node.attribute("media").is_some_and(|media| media.trim() == "print");
            if node.tag_name().name() == "style" && is_css && !is_print {
                let text: String = node.children().filter_map(|child| child.text()).collect();
                sheet.read(&without_comments(&text));
            }
        }
        sheet
    }

    /// Adds the rules of a text without comments.
    fn read(&mut self, text: &str) {
        let mut rest = text;
        while let Some(open) = rest.find(['{', ';']) {
            let selectors = rest[..open].trim().trim_start_matches('}').trim_start();
            let is_statement = rest.as_bytes()[open] == b';';
            rest = &rest[open + 1..];
            if is_statement {
                self.unread += usize::from(selectors.starts_with("@import"));
                continue;
            }
            let end = end_of_block(rest);
            let block = &rest[..end];
            rest = rest.get(end + 1..).unwrap_or_default();
            if selectors.starts_with('@') {
                let is_silent = ["@font-face", "@keyframes", "@-", "@page", "@media print"];
                let matters = block.split(['{', '}', ';']).any(|part| !declarations(part).is_empty());
                let is_silent = is_silent.iter().any(|start| selectors.starts_with(start));
                self.unread += usize::from(matters && !is_silent);
                continue;
            }
            let declared = declarations(block);
            if declared.is_empty() {
                continue;
            }
            for selector in selectors.split(',') {
                match compounds(selector) {
                    Some(compounds) => self.push(compounds),
                    None => self.unread += usize::from(!NEVER.iter().any(|part| selector.contains(part))),
                }
            }
            self.blocks.push(declared);
        }
    }

    fn push(&mut self, compounds: Vec<(Compound, bool)>) {
        let mut specificity = [0; 3];
        for (compound, _) in &compounds {
            specificity[0] += compound.ids.len();
            specificity[1] += compound.classes.len();
            specificity[2] += usize::from(compound.element.is_some());
        }
        let last = &compounds[0].0;
        let key = match (last.ids.first(), last.classes.first(), &last.element) {
            (Some(id), _, _) => format!("#{id}"),
            (None, Some(class), _) => format!(".{class}"),
            (None, None, Some(element)) => element.clone(),
            (None, None, None) => String::new(),
        };
        self.by_key.entry(key).or_default().push(self.rules.len());
        self.rules.push(Rule { compounds, specificity, block: self.blocks.len() });
    }

    /// The values of an element: an attribute comes behind a sheet, that behind a style, and all behind what is important. Of two sheets' the
    /// more specific one counts, or the later one.
    pub(super) fn style<'a>(&'a self, node: Node<'a, '_>) -> Style<'a> {
        let mut style = Style::default();
        // What each value is ranked by.
        let mut ranks = [(false, 0, [0; 3], 0); COUNT];
        let mut set = |property: Property, value: &'a str, rank| {
            let at = property as usize;
            if !value.is_empty() && (style.values[at].is_none() || rank >= ranks[at]) {
                (style.values[at], ranks[at]) = (Some(value), rank);
            }
        };
        for attribute in node.attributes() {
            if let Some(property) = Property::of_attribute(attribute.name())
                && attribute.namespace().is_none()
            {
                set(
                    property,
                    node.attribute(attribute.name()).unwrap_or_default().trim(),
                    (false, 0, [0; 3], 0),
                );
            }
        }
        if !self.rules.is_empty() {
            let id = node.attribute("id").map(|id| format!("#{id}"));
            let keys = classes(node).map(|class| format!(".{class}")).chain(id);
            for key in keys.chain([node.tag_name().name().to_owned(), String::new()]) {
                for &number in self.by_key.get(&key).into_iter().flatten() {
                    let rule = &self.rules[number];
                    if rule.matches(node) {
                        for declared in &self.blocks[rule.block] {
                            let rank = (declared.is_important, 1, rule.specificity, number);
                            set(declared.property, &declared.value, rank);
                        }
                    }
                }
            }
        }
        for declaration in node.attribute("style").unwrap_or_default().split(';') {
            if let Some((property, value, is_important)) = declaration_of(declaration) {
                set(property, value, (is_important, 2, [0; 3], 0));
            }
        }
        style
    }
}

fn without_comments(text: &str) -> String {
    let mut kept = String::new();
    let mut rest = text;
    while let Some((before, behind)) = rest.split_once("/*") {
        kept.push_str(before);
        kept.push(' ');
        rest = behind.split_once("*/").map_or("", |(_, behind)| behind);
    }
    kept.push_str(rest);
    kept.replace("<!--", " ").replace("-->", " ")
}

/// Where the block ends whose brace is open.
fn end_of_block(text: &str) -> usize {
    let mut depth = 1usize;
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'{' => depth += 1,
            b'}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at;
        }
    }
    text.len()
}

fn declarations(block: &str) -> Vec<Declaration> {
    let parts = block.split(';').filter_map(declaration_of);
    parts
        .filter(|(_, value, _)| !value.is_empty())
        .map(|(property, value, is_important)| Declaration {
            property,
            value: value.to_owned(),
            is_important,
        })
        .collect()
}

/// A property, its value, and whether it is important.
fn declaration_of(text: &str) -> Option<(Property, &str, bool)> {
    let (name, value) = text.split_once(':')?;
    let property = Property::of_style(name.trim())?;
    let value = value.trim();
    let plain = value.rsplit_once('!').filter(|(_, word)| word.trim().eq_ignore_ascii_case("important"));
    Some(plain.map_or((property, value, false), |(plain, _)| (property, plain.trim_end(), true)))
}

/// The parts of a selector from the last one outwards; `None` for one that is not read.
fn compounds(selector: &str) -> Option<Vec<(Compound, bool)>> {
    let spaced = selector.replace('>', " > ");
    let mut parts = Vec::new();
    let mut is_parent = false;
    for word in spaced.split_ascii_whitespace().rev() {
        if word == ">" {
            if parts.is_empty() || std::mem::replace(&mut is_parent, true) {
                return None;
            }
            continue;
        }
        parts.push((compound(word)?, std::mem::take(&mut is_parent)));
    }
    (!parts.is_empty() && !is_parent).then_some(parts)
}

fn compound(word: &str) -> Option<Compound> {
    let mut compound = Compound::default();
    let is_name = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_') || !c.is_ascii();
    let mut rest = word;
    if let Some(behind) = rest.strip_prefix('*') {
        rest = behind;
    } else {
        let (name, behind) = rest.split_at(rest.find(|c| !is_name(c)).unwrap_or(rest.len()));
        compound.element = Some(name.to_owned()).filter(|name| !name.is_empty());
        rest = behind;
    }
    while let Some(mark) = rest.chars().next() {
        let behind = &rest[mark.len_utf8()..];
        let (name, others) = behind.split_at(behind.find(|c| !is_name(c)).unwrap_or(behind.len()));
        match mark {
            _ if name.is_empty() => return None,
            '.' => compound.classes.push(name.to_owned()),
            '#' => compound.ids.push(name.to_owned()),
            _ => return None,
        }
        rest = others;
    }
    Some(compound)
}
