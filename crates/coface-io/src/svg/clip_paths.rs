//! Clip paths of elements: what `clip-path` names, and the shapes of `clipPath`.

use super::clip_shapes::BasicShape;
use super::clipping::{Clip, Region};
use super::curves::{Pen, Subpath};
use super::elements::{self, FillRule};
use super::painting::Painting;
use super::reading::{Around, Reader, Whole, fault, line_of};
use super::style::{Property, Style};
use super::transformation::Transformation;
use super::viewport::{Extent, Viewport};
use coface_algebra::{Error, ErrorKind};
use roxmltree::{Node, NodeId};

/// Clip paths in clip paths.
const DEEPEST: usize = 32;

/// A clip path where it is used: the element, its map, and the box that lengths are of.
pub(super) type ClipKey = (NodeId, [u64; 6], [Option<u64>; 3]);

/// What refers to a clip path.
#[derive(Clone, Copy)]
pub(super) struct Referring<'a, 'input> {
    pub(super) node: Node<'a, 'input>,
    /// The `use` that names it, if one does.
    pub(super) user: Option<Node<'a, 'input>>,
    /// From its own coordinates to those of the drawing.
    pub(super) map: Transformation,
    pub(super) viewport: Viewport,
    /// In how many elements it is.
    pub(super) depth: usize,
    /// How it is painted.
    pub(super) painting: Painting,
}

/// What a shape in a clip path has of the elements around it.
#[derive(Clone, Copy)]
struct Inherited {
    rule: FillRule,
    is_visible: bool,
    viewport: Viewport,
}

impl Inherited {
    fn within(self, style: &Style<'_>) -> Self {
        Self {
            rule: match style.of(Property::ClipRule) {
                Some("evenodd") => FillRule::EvenOdd,
                Some("nonzero" | "initial") => FillRule::Nonzero,
                _ => self.rule,
            },
            is_visible: match style.of(Property::Visibility) {
                Some("hidden" | "collapse") => false,
                Some("visible" | "initial") => true,
                _ => self.is_visible,
            },
            viewport: self.viewport.within(style.of(Property::FontSize)),
        }
    }
}

/// What a child of a clip path is.
enum Child {
    Shape(usize),
    Nothing,
    /// Text, whose shape is not known.
    Unknown,
}

impl Reader {
    /// The clip of an element within that of what is around it. A clip path that is not done is counted.
    ///
    /// # Errors
    /// As a drawing with its shapes; `TooLarge` for clip paths that are nested too deep, or drawn too often.
    pub(super) fn clip_within<'a, 'input>(
        &mut self,
        around: Option<usize>,
        style: &Style<'_>,
        whole: &Whole<'a, 'input>,
        referring: &Referring<'a, 'input>,
    ) -> Result<Option<usize>, Error> {
        if !style.has(Property::ClipPath) {
            return Ok(around);
        }
        match self.named_clip(style.of(Property::ClipPath).unwrap_or_default(), whole, referring)? {
            Some(own) => Ok(Some(self.clips.within(around, own))),
            None => {
                self.undone.clip_paths += 1;
                Ok(around)
            }
        }
    }

    /// The clip that a value of `clip-path` names; `None` if it is none of this file, contains itself or is of text.
    fn named_clip<'a, 'input>(
        &mut self,
        value: &str,
        whole: &Whole<'a, 'input>,
        referring: &Referring<'a, 'input>,
    ) -> Result<Option<usize>, Error> {
        if let Some(shape) = BasicShape::parse(value).filter(|_| !value.starts_with("url")) {
            return self.basic_shape(&shape, whole, referring);
        }
        let target = local_url(value).and_then(|id| whole.ids.get(id)).copied();
        let Some(target) = target.filter(|target| target.tag_name().name() == "clipPath") else {
            return Ok(None);
        };
        if self.open_clips.contains(&target.id()) {
            return Ok(None);
        }
        let style = whole.sheet.style(target);
        let is_of_box = target.attribute("clipPathUnits").map(str::trim) == Some("objectBoundingBox");
        let key = (target.id(), referring.map.bits(), referring.viewport.bits());
        // What is in units of a box is another thing for each box.
        let is_kept = !is_of_box && !style.has(Property::ClipPath);
        if let Some(&known) = self.known_clips.get(&key).filter(|_| is_kept) {
            return Ok(known);
        }
        self.open_clip(target)?;
        let found = self.clip_path(target, &style, is_of_box, whole, referring);
        self.open_clips.pop();
        let found = found?;
        if is_kept {
            self.known_clips.insert(key, found);
        }
        Ok(found)
    }

    /// Notes that a clip path or a mask is being read.
    ///
    /// # Errors
    /// `TooLarge` if too many are read in each other, or they are read too often.
    pub(super) fn open_clip(&mut self, target: Node<'_, '_>) -> Result<(), Error> {
        if self.open_clips.len() >= DEEPEST {
            let message = format!("clip paths and masks are nested deeper than {DEEPEST}");
            return Err(Error::new(ErrorKind::TooLarge, message)
                .at_line(line_of(target))
                .with_cure("nest them less"));
        }
        // Corners take more room than their text.
        self.copies_left = self.copies_left.checked_sub(2 * target.range().len()).ok_or_else(|| {
            let message = "clip paths and masks make more copies of shapes than are drawn";
            Error::new(ErrorKind::TooLarge, message)
                .at_line(line_of(target))
                .with_cure("clip groups instead of single shapes")
        })?;
        self.open_clips.push(target.id());
        Ok(())
    }

    fn clip_path<'a, 'input>(
        &mut self,
        target: Node<'a, 'input>,
        style: &Style<'_>,
        is_of_box: bool,
        whole: &Whole<'a, 'input>,
        referring: &Referring<'a, 'input>,
    ) -> Result<Option<usize>, Error> {
        let mut map = referring.map.after(&transform_of(target)?);
        if is_of_box {
            let ([low, high], _) = self.box_of(whole, referring)?;
            let [width, height] = [high[0] - low[0], high[1] - low[1]];
            if !(width > 0.0 && height > 0.0) {
                // Of a box without an extent nothing is a part, and the clip path is passed over.
                return Ok(Some(self.clips.push(Clip::All(Vec::new()))));
            }
            let unit =
                Transformation { a: width, d: height, e: low[0], f: low[1], ..Transformation::IDENTITY };
            map = map.after(&unit);
        }
        let mut inherited =
            Inherited { rule: FillRule::Nonzero, is_visible: true, viewport: referring.viewport };
        let mut ancestors: Vec<Node<'_, '_>> = target.ancestors().filter(Node::is_element).collect();
        ancestors.reverse();
        for ancestor in ancestors {
            inherited = inherited.within(&whole.sheet.style(ancestor));
        }
        let mut shapes = Vec::new();
        for child in target.children().filter(Node::is_element) {
            let within = Referring { node: child, user: None, map, ..*referring };
            match self.clip_shape(whole, &within, inherited)? {
                Child::Shape(shape) => shapes.push(shape),
                Child::Nothing => {}
                Child::Unknown => return Ok(None),
            }
        }
        let shapes = self.clips.push(Clip::Any(shapes));
        self.clip_within(Some(shapes), style, whole, referring)
    }

    /// A shape of a clip path, or a `use` of one.
    fn clip_shape<'a, 'input>(
        &mut self,
        whole: &Whole<'a, 'input>,
        within: &Referring<'a, 'input>,
        inherited: Inherited,
    ) -> Result<Child, Error> {
        let node = within.node;
        let name = node.tag_name().name();
        let is_shape =
            matches!(name, "path" | "polygon" | "polyline" | "line" | "circle" | "ellipse" | "rect");
        if !is_shape && !matches!(name, "use" | "text") {
            return Ok(Child::Nothing);
        }
        let style = whole.sheet.style(node);
        let inherited = inherited.within(&style);
        // A `use` may be hidden and what it names not.
        if style.of(Property::Display) == Some("none") || !inherited.is_visible && name != "use" {
            return Ok(Child::Nothing);
        }
        if name == "text" {
            return Ok(Child::Unknown);
        }
        self.undone.note(&style, false);
        let Inherited { rule, viewport, .. } = inherited;
        let mut map = within.map.after(&transform_of(node)?);
        let shape = if name == "use" {
            map = map.after(&shift_of(node, &viewport)?);
            let Some(target) = target_of(node, whole).filter(|target| target.tag_name().name() != "use")
            else {
                return Ok(Child::Nothing);
            };
            let size = target.range().len();
            self.copies_left = self.copies_left.checked_sub(size).ok_or_else(|| too_many_copies(node))?;
            let inner = Referring { node: target, user: Some(node), map, viewport, ..*within };
            match self.clip_shape(whole, &inner, inherited)? {
                Child::Shape(shape) => shape,
                other => return Ok(other),
            }
        } else {
            let mut pen = Pen::new(map, self.curves);
            elements::draw(node, &viewport, &mut pen).map_err(|text| fault(node, &text))?;
            if !pen.subpaths.iter().all(Subpath::is_finite) {
                return Err(fault(node, "a transformed coordinate is not finite"));
            }
            self.clips.push(Clip::Region(Region::new(pen.subpaths, rule.inside())))
        };
        let referring = Referring { map, viewport, ..*within };
        let clip = self.clip_within(Some(shape), &style, whole, &referring)?;
        Ok(clip.map_or(Child::Nothing, Child::Shape))
    }

    /// A basic shape in the box around an element; `None` if it is not known, or its box is that of outlines.
    fn basic_shape<'a, 'input>(
        &mut self,
        shape: &BasicShape<'_>,
        whole: &Whole<'a, 'input>,
        referring: &Referring<'a, 'input>,
    ) -> Result<Option<usize>, Error> {
        let ([low, high], has_outlines) = self.box_of(whole, referring)?;
        let size = [high[0] - low[0], high[1] - low[1]];
        if has_outlines && shape.has_strokes || !size.iter().all(|side| *side >= 0.0 && side.is_finite()) {
            return Ok(None);
        }
        let moved = Transformation { e: low[0], f: low[1], ..Transformation::IDENTITY };
        let mut pen = Pen::new(referring.map.after(&moved), self.curves);
        let Some(rule) = shape.draw(&referring.viewport, size, &mut pen) else { return Ok(None) };
        if !pen.subpaths.iter().all(Subpath::is_finite) {
            return Err(fault(referring.node, "a transformed coordinate is not finite"));
        }
        Ok(Some(self.clips.push(Clip::Region(Region::new(pen.subpaths, rule.inside())))))
    }

    /// The box around all that an element draws, in its own coordinates, whether it is seen or not, and whether some of it has outlines.
    pub(super) fn box_of<'a, 'input>(
        &mut self,
        whole: &Whole<'a, 'input>,
        referring: &Referring<'a, 'input>,
    ) -> Result<([[f64; 2]; 2], bool), Error> {
        let mut measuring = Self::measuring(self.copies_left);
        let around = Around::measured(referring.viewport, referring.painting);
        measuring.element(referring.node, whole, &around, referring.user)?;
        self.copies_left = measuring.copies_left;
        Ok((measuring.bounds, measuring.has_outlines))
    }
}

/// The name in `url(#name)`, with or without quotes.
pub(super) fn local_url(value: &str) -> Option<&str> {
    let (inner, _) = value.trim().strip_prefix("url(")?.split_once(')')?;
    let inner = inner.trim();
    let bare = ['"', '\''].into_iter().find_map(|mark| inner.strip_prefix(mark)?.strip_suffix(mark));
    bare.unwrap_or(inner).trim().strip_prefix('#')
}

/// The map in the attribute `transform`.
pub(super) fn transform_of(node: Node<'_, '_>) -> Result<Transformation, Error> {
    let text = node.attribute("transform").unwrap_or_default();
    Transformation::parse(text).map_err(|text| fault(node, &text))
}

/// Where a `use` puts what it names.
pub(super) fn shift_of(node: Node<'_, '_>, viewport: &Viewport) -> Result<Transformation, Error> {
    let at = |name: &str, of: Extent| {
        viewport.length(node, name, of).map(Option::unwrap_or_default).map_err(|text| fault(node, &text))
    };
    Ok(Transformation { e: at("x", Extent::Width)?, f: at("y", Extent::Height)?, ..Transformation::IDENTITY })
}

/// What a `use` names in this file.
pub(super) fn named_by<'a, 'input>(
    node: Node<'_, '_>,
    whole: &Whole<'a, 'input>,
) -> Option<Node<'a, 'input>> {
    let link = node.attributes().find(|attribute| attribute.name() == "href")?;
    whole.ids.get(link.value().trim().strip_prefix('#')?).copied()
}

/// What a `use` names. What contains itself is nothing.
fn target_of<'a, 'input>(node: Node<'_, '_>, whole: &Whole<'a, 'input>) -> Option<Node<'a, 'input>> {
    named_by(node, whole).filter(|&target| node.ancestors().all(|around| around != target))
}

/// More copies than are drawn.
pub(super) fn too_many_copies(node: Node<'_, '_>) -> Error {
    let message = "<use> makes more copies of copies than are drawn";
    Error::new(ErrorKind::TooLarge, message).at_line(line_of(node)).with_cure("draw them as paths")
}
