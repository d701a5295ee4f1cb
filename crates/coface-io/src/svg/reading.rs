//! From a stream to a model.

use super::clip_paths::{ClipKey, Referring, named_by, shift_of, too_many_copies, transform_of};
use super::clipping::{Clip, Clips, Part, Region, Seen, too_many};
use super::curves::{Curves, FilledPath, Pen, Subpath};
use super::elements::{self, FillRule};
use super::masks::Masking;
use super::painting::{Painting, missing_paints};
use super::style::{Property, Sheet};
use super::transformation::Transformation;
use super::undone::Undone;
use super::viewport::Viewport;
use crate::drawing::{Drawing, Place};
use crate::yin::{NO_BOUNDS, check_tolerance, default_tolerance, flattening_remark};
use crate::{CellData, GroupKind, Model};
use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use roxmltree::{Document, Node, NodeId, ParsingOptions};
use std::collections::HashMap;
use std::io::Read;

/// The longest file that is read.
const LONGEST: u64 = 1 << 30;
/// Elements in elements; the parser itself allows more.
const DEEPEST: usize = 256;
const CURE: &str = "the file must be SVG, as drawing programs write it";

/// Reads the lines and rings of a drawing: see [what becomes of what](crate::svg). Curves become chords that are within a
/// thousandth of the size of the drawing, the diagonal of its bounding box; a remark says the length.
///
/// # Errors
/// As [`read_flattened`].
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = r#"<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0h2v2h-2z"/><line x2="1" y2="1"/></svg>"#;
/// let model = coface_io::svg::read(text.as_bytes())?;
/// assert_eq!(model.lines().list(0), [0, 1, 2, 3, 0]);
/// assert_eq!(model.lines().len(), 2);
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_with(input, None)
}

/// The same with curves replaced by chords that are within a tolerance of them, in the unit of the user after all
/// transformations.
///
/// # Errors
/// [`ErrorKind::Parse`] with the line for what is no XML or no SVG, or has a value that is none; [`ErrorKind::InvalidInput`] if the
/// tolerance is not positive; [`ErrorKind::TooLarge`] beyond 2^30 bytes, 2^32 - 2 corners, a million chords of a curve,
/// 256 elements or 32 clip paths in each other, or where shapes and their clips cross too often; [`ErrorKind::Io`] if the stream fails.
///
/// # Complexity
/// $O(n \log n)$ for n corners, chords included, to find equal ones, and for each shape on the rim of a clip the overlay of
/// both; memory is the file and the model.
///
/// # References
/// W3C, *Scalable Vector Graphics (SVG) 2* (2018), chapters 8 to 10; W3C, *CSS Masking Module Level 1* (2021), sections 5 to 8.
///
/// # Examples
/// A circle of radius 1 as a polygon that is within 0.01 of it.
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = r#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="1"/></svg>"#;
/// let model = coface_io::svg::read_flattened(text.as_bytes(), 0.01)?;
/// assert_eq!((model.lines().len(), model.vertex_count()), (1, 23));
/// assert_eq!(coface_io::svg::read(text.as_bytes())?.remarks().len(), 1);
/// # Ok(()) }
/// ```
pub fn read_flattened(input: impl Read, tolerance: f64) -> Result<Model, Error> {
    check_tolerance(tolerance)?;
    read_with(input, Some(tolerance))
}

pub(crate) fn read_with(input: impl Read, tolerance: Option<f64>) -> Result<Model, Error> {
    let text = text_of(input)?;
    let mut kept = Reader::new(Curves::Kept);
    kept.read(&text)?;
    let curve_count = if tolerance.is_none() { kept.curve_count } else { 0 };
    let tolerance = tolerance.unwrap_or_else(|| default_tolerance(kept.bounds));
    let mut reader = Reader::new(Curves::Chords(tolerance));
    reader.takes_outlines = !kept.has_filled;
    drop(kept);
    reader.read(&text)?;
    let Reader { drawing, fill_rules, passed_over, undone, outline_count, .. } = reader;
    let mut model = drawing.finish()?;
    if curve_count > 0 {
        model.remarks.push(flattening_remark(curve_count, tolerance));
    }
    model.remarks.extend(outlines_remark(outline_count));
    model.remarks.extend(undone.remarks());
    if passed_over > 0 {
        let what = if passed_over == 1 { "element is" } else { "elements are" };
        let message = format!(
            "{passed_over} {what} no lines or shapes and passed over: text, images or copies from other files"
        );
        model.remarks.push(Remark::new(RemarkCode::ElementsLeftOut, message).at(passed_over, []));
    }
    if model.data_named("ring", GroupKind::Lines).is_none() {
        return Ok(model);
    }
    model.with_data(CellData::integers("fill_rule", GroupKind::Lines, 1, fill_rules)?)
}

/// The shapes of a drawing with their curves.
pub(super) struct ShapePaths {
    pub(super) filled: Vec<FilledPath>,
    /// Shapes that are drawn as outlines only.
    pub(super) outlines: Vec<FilledPath>,
    /// How many other elements are passed over.
    pub(super) passed_over: usize,
    /// Whether there are no filled ones, not even such as are clipped away.
    pub(super) is_outline: bool,
    /// What they are seen through.
    pub(super) clips: Clips,
    /// What is not done.
    pub(super) undone: Undone,
}

/// That so many outlines are shapes.
pub(super) fn outlines_remark(count: usize) -> Option<Remark> {
    let what = if count == 1 { "closed outline is" } else { "closed outlines are" };
    let message = format!("nothing is filled: {count} {what} taken for the boundary of filled shapes");
    (count > 0).then(|| Remark::new(RemarkCode::DrawingAssumption, message).at(count, []))
}

/// The shapes of a drawing with their curves.
pub(super) fn read_paths(input: impl Read) -> Result<ShapePaths, Error> {
    let mut reader = Reader::new(Curves::Kept);
    reader.read(&text_of(input)?)?;
    let Reader { paths, outlines, passed_over, undone, clips, has_filled, .. } = reader;
    Ok(ShapePaths { filled: paths, outlines, passed_over, is_outline: !has_filled, clips, undone })
}

/// The whole stream, which must be text.
fn text_of(input: impl Read) -> Result<String, Error> {
    let mut bytes = Vec::new();
    let mut input = input.take(LONGEST + 1);
    loop {
        let start = bytes.len();
        input.by_ref().take(1 << 20).read_to_end(&mut bytes)?;
        if bytes.len() == start {
            break;
        }
        if let Some(at) = memchr::memchr(0, &bytes[start..]) {
            return Err(Error::parse("a zero byte stands in the text")
                .at_byte((start + at) as u64)
                .with_cure(CURE));
        }
    }
    if bytes.len() as u64 > LONGEST {
        return Err(
            Error::new(ErrorKind::TooLarge, "the file is longer than 2^30 bytes").with_cure("divide it")
        );
    }
    String::from_utf8(bytes).map_err(|error| {
        Error::parse("the text is not UTF-8")
            .at_byte(error.utf8_error().valid_up_to() as u64)
            .with_cure("save it as UTF-8")
    })
}

pub(super) fn line_of(node: Node<'_, '_>) -> u64 {
    u64::from(node.document().text_pos_at(node.range().start).row)
}

/// What is wrong with an element.
pub(super) fn fault(node: Node<'_, '_>, text: &str) -> Error {
    Error::parse(format!("<{}>: {}", shortened(node.tag_name().name()), shortened(text)))
        .at_line(line_of(node))
        .with_cure(CURE)
}

/// A text from the file, safe and short enough for an error message.
fn shortened(text: &str) -> String {
    let start: String = text.chars().take(120).collect();
    let dots = if start.len() < text.len() { "..." } else { "" };
    let safe: String = start.chars().map(|c| if c.is_control() { '?' } else { c }).collect();
    format!("{safe}{dots}")
}

/// What holds around an element.
#[derive(Clone, Copy)]
pub(super) struct Around {
    map: Transformation,
    painting: Painting,
    viewport: Viewport,
    depth: usize,
    /// Whether it is drawn by a `use`.
    is_copy: bool,
    /// What it is seen through.
    clip: Option<usize>,
    /// Whether its own transformation is left out, so that it is in its own coordinates.
    is_in_place: bool,
}

impl Around {
    fn new(viewport: Viewport) -> Self {
        Self {
            map: Transformation::IDENTITY,
            painting: Painting::initial(),
            viewport,
            depth: 0,
            is_copy: false,
            clip: None,
            is_in_place: false,
        }
    }

    /// What holds around the shapes of a mask.
    pub(super) fn masking(map: Transformation, painting: Painting, viewport: Viewport, depth: usize) -> Self {
        Self { map, painting, depth, ..Self::new(viewport) }
    }

    /// What holds around an element whose extent in its own coordinates is asked for.
    pub(super) fn measured(viewport: Viewport, painting: Painting) -> Self {
        Self { depth: 1, is_in_place: true, painting, ..Self::new(viewport) }
    }
}

/// What all elements have in common.
pub(super) struct Whole<'a, 'input> {
    /// The elements that others can name.
    pub(super) ids: HashMap<&'a str, Node<'a, 'input>>,
    pub(super) sheet: Sheet,
}

impl Whole<'_, '_> {
    /// Whether an element of this name paints others.
    pub(super) fn is_paint_server(&self, id: &str) -> bool {
        self.ids.get(id).is_some_and(|node| {
            let name = node.tag_name().name();
            matches!(
                name,
                "linearGradient" | "radialGradient" | "meshgradient" | "pattern" | "hatch" | "solidcolor"
            )
        })
    }
}

/// The text of all copies together may be so many times as long as the file, and this long in any file: copies of copies can be many.
const COPIES_OF_FILE: usize = 64;
const FEW_COPIES: usize = 1 << 20;
/// Clipping may make so many corners for each byte of the file, and so many in any file: a shape may cross its clip as often as there are pairs of their sides.
const CUTS_OF_FILE: usize = 16;
const FEW_CUTS: usize = 1 << 20;

pub(super) struct Reader {
    pub(super) curves: Curves,
    /// What is drawn, unless curves are kept.
    drawing: Drawing,
    /// What is drawn, if they are.
    paths: Vec<FilledPath>,
    outlines: Vec<FilledPath>,
    /// The rule of each line that the drawing keeps.
    fill_rules: Vec<i64>,
    passed_over: usize,
    /// How many bytes of text may still be drawn as copies.
    pub(super) copies_left: usize,
    /// How many corners clipping may still make.
    cuts_left: usize,
    /// Where the lines of the file end.
    line_ends: Vec<usize>,
    /// The number of shapes with curves, and the box around all that is drawn, if curves are kept.
    curve_count: usize,
    pub(super) bounds: [[f64; 2]; 2],
    /// Whether a shape is filled, if only one that is not seen.
    has_filled: bool,
    /// Whether only the box is asked for, of all that is drawn, be it seen or not.
    is_measuring: bool,
    /// Whether something of that has an outline.
    pub(super) has_outlines: bool,
    /// Whether nothing is filled and closed outlines are rings, and how many shapes are.
    takes_outlines: bool,
    outline_count: usize,
    pub(super) clips: Clips,
    /// The clip paths that have been read, by where they are used, and those that are being read.
    pub(super) known_clips: HashMap<ClipKey, Option<usize>>,
    pub(super) open_clips: Vec<NodeId>,
    /// The `use` elements that are being drawn.
    open_uses: Vec<NodeId>,
    /// The mask that is being read: its shapes are not drawn.
    pub(super) masking: Option<Masking>,
    pub(super) undone: Undone,
}

impl Reader {
    fn new(curves: Curves) -> Self {
        Self {
            curves,
            drawing: Drawing::default(),
            paths: Vec::new(),
            outlines: Vec::new(),
            fill_rules: Vec::new(),
            passed_over: 0,
            copies_left: 0,
            cuts_left: 0,
            line_ends: Vec::new(),
            curve_count: 0,
            bounds: NO_BOUNDS,
            has_filled: false,
            is_measuring: false,
            has_outlines: false,
            takes_outlines: false,
            outline_count: 0,
            clips: Clips::default(),
            known_clips: HashMap::new(),
            open_clips: Vec::new(),
            open_uses: Vec::new(),
            masking: None,
            undone: Undone::default(),
        }
    }

    /// One that finds the box around what elements draw.
    pub(super) fn measuring(copies_left: usize) -> Self {
        Self { is_measuring: true, copies_left, ..Self::new(Curves::Kept) }
    }

    fn read(&mut self, text: &str) -> Result<(), Error> {
        let options = ParsingOptions { allow_dtd: true, nodes_limit: u32::MAX, ..ParsingOptions::default() };
        let document = Document::parse_with_options(text, options).map_err(|error| {
            Error::parse(shortened(&error.to_string())).at_line(u64::from(error.pos().row)).with_cure(CURE)
        })?;
        let root = document.root_element();
        if root.tag_name().name() != "svg" {
            let message =
                format!("the outermost element is <{}>, not <svg>", shortened(root.tag_name().name()));
            return Err(Error::parse(message).at_line(line_of(root)).with_cure(CURE));
        }
        let mut ids = HashMap::new();
        for node in document.descendants() {
            if let Some(id) = node.attribute("id") {
                ids.entry(id).or_insert(node);
            }
        }
        let whole = Whole { ids, sheet: Sheet::of(&document) };
        self.undone.rules = whole.sheet.unread;
        let letters = whole.sheet.style(root).of(Property::FontSize);
        self.copies_left = FEW_COPIES.max(COPIES_OF_FILE * text.len());
        self.line_ends = memchr::memchr_iter(b'\n', text.as_bytes()).collect();
        self.cuts_left = FEW_CUTS.max(CUTS_OF_FILE * text.len());
        let viewport = Viewport::of_root(root, letters).map_err(|text| fault(root, &text))?;
        let around = Around::new(viewport);
        self.element(root, &whole, &around, None)
    }

    /// Draws an element with all that is in it; `user` is the `use` that names it, if one does.
    pub(super) fn element<'a, 'input>(
        &mut self,
        node: Node<'a, 'input>,
        whole: &Whole<'a, 'input>,
        around: &Around,
        user: Option<Node<'a, 'input>>,
    ) -> Result<(), Error> {
        let Around { map, painting, viewport, depth, is_copy, clip, is_in_place } = *around;
        if depth > DEEPEST {
            let message = format!("elements are nested deeper than {DEEPEST}");
            return Err(Error::new(ErrorKind::TooLarge, message)
                .at_line(line_of(node))
                .with_cure("nest them less"));
        }
        if is_copy {
            // Its tag, with all its attributes.
            let end = node.first_child().map_or(node.range().end, |child| child.range().start);
            let size = end - node.range().start;
            self.copies_left = self.copies_left.checked_sub(size).ok_or_else(|| too_many_copies(node))?;
        }
        let name = node.tag_name().name();
        // A symbol is drawn where it is used.
        let is_symbol = name == "symbol" && user.is_some();
        let is_definition = elements::is_definition(name) && !is_symbol;
        if is_definition {
            return Ok(());
        }
        let style = whole.sheet.style(node);
        if style.of(Property::Display) == Some("none") {
            return Ok(());
        }
        let is_server = |id: &str| whole.is_paint_server(id);
        let painting = painting.within(&style, &is_server);
        if matches!(name, "text" | "image" | "foreignObject") {
            match &mut self.masking {
                Some(masking) => masking.is_unknown |= painting.is_visible,
                None => self.passed_over += usize::from(painting.is_visible),
            }
            return Ok(());
        }
        self.undone.note(&style, depth == 0);
        self.undone.paints += missing_paints(&style, &is_server);
        let viewport = viewport.within(style.of(Property::FontSize));
        let mut map = if is_in_place { map } else { map.after(&transform_of(node)?) };
        if name == "use" && !is_in_place {
            map = map.after(&shift_of(node, &viewport)?);
        }
        let clip = match self.is_measuring {
            true => None,
            false => {
                let referring = Referring { node, user, map, viewport, depth, painting };
                let clip = self.clip_within(clip, &style, whole, &referring)?;
                self.mask_within(clip, &style, whole, &referring)?
            }
        };
        self.shape(node, &viewport, map, painting, clip)?;
        let mut within =
            Around { map, painting, viewport, depth: depth + 1, is_copy, clip, is_in_place: false };
        if name == "use" {
            let Some(target) = named_by(node, whole) else {
                self.passed_over += 1;
                return Ok(());
            };
            // What is drawn by the uses around it is in all of them.
            let users =
                self.open_uses.iter().filter_map(|&user| node.document().get_node(user)).chain([node]);
            if users.into_iter().any(|user| user.ancestors().any(|around| around == target)) {
                self.undone.circles += 1;
                return Ok(());
            }
            self.open_uses.push(node.id());
            let within = Around { is_copy: true, painting: painting.used(), ..within };
            let drawn = self.element(target, whole, &within, Some(node));
            self.open_uses.pop();
            return drawn;
        }
        if is_symbol || name == "svg" && depth > 0 {
            let inner = viewport.inner(node, user).map_err(|text| fault(node, &text))?;
            let Some(inner) = inner else { return Ok(()) };
            (within.map, within.viewport) = (map.after(&inner.map), inner.viewport);
            let is_open = matches!(style.of(Property::Overflow), Some("visible" | "auto"));
            if let Some([low, high]) = inner.clip.filter(|_| !is_open && !self.is_measuring) {
                let corners =
                    [low, [high[0], low[1]], high, [low[0], high[1]]].map(|corner| map.point(corner));
                if !corners.as_flattened().iter().all(|x| x.is_finite()) {
                    return Err(fault(node, "a transformed coordinate is not finite"));
                }
                let frame = self.clips.push(Clip::Region(Region::frame(corners)));
                within.clip = Some(self.clips.within(clip, frame));
            }
        }
        for child in node.children().filter(Node::is_element) {
            self.element(child, whole, &within, None)?;
        }
        Ok(())
    }

    /// Draws what an element is itself, as far as it is seen.
    fn shape(
        &mut self,
        node: Node<'_, '_>,
        viewport: &Viewport,
        map: Transformation,
        painting: Painting,
        clip: Option<usize>,
    ) -> Result<(), Error> {
        let name = node.tag_name().name();
        let mut pen = Pen::new(map, self.curves);
        elements::draw(node, viewport, &mut pen).map_err(|text| fault(node, &text))?;
        let subpaths = pen.subpaths;
        if !subpaths.iter().all(Subpath::is_finite) {
            return Err(fault(node, "a transformed coordinate is not finite"));
        }
        if self.is_measuring {
            self.has_outlines |= painting.has_stroke && !subpaths.is_empty();
            subpaths.iter().for_each(|subpath| subpath.extend(&mut self.bounds));
            return Ok(());
        }
        if subpaths.is_empty() || !painting.is_visible {
            return Ok(());
        }
        if self.masking.is_some() {
            self.mask_shape(subpaths, painting, clip);
            return Ok(());
        }
        // A line has no inside.
        let is_filled = painting.fills() && name != "line" && subpaths.iter().any(Subpath::may_fill);
        self.has_filled |= is_filled;
        let part = match clip {
            None => None,
            Some(clip) => {
                let points: Vec<[f64; 2]> = subpaths.iter().flat_map(Subpath::controls).copied().collect();
                match self.clips.seen(clip, &points) {
                    Seen::All => None,
                    Seen::Nothing => return Ok(()),
                    Seen::Part(part) => Some((clip, part)),
                }
            }
        };
        if self.curves != Curves::Kept {
            self.drawing.begin_feature(node.attribute("id").map(str::to_owned));
            let part = part.as_ref().map(|(_, part)| part);
            self.subpaths(&subpaths, painting.rule, is_filled, node, part)
                .map_err(|error| error.at_line(line_of(node)))?;
            self.drawing.begin_feature(None);
            return Ok(());
        }
        self.measure(&subpaths, part.as_ref());
        let path = FilledPath {
            line: 1 + self.line_ends.partition_point(|&end| end < node.range().start) as u64,
            element: shortened(name),
            name: node.attribute("id").filter(|id| !id.is_empty()).map(str::to_owned),
            rule: painting.rule.inside(),
            is_exterior: node.attribute("data-unbounded") == Some("true"),
            subpaths,
            clip: part.map(|(clip, _)| clip),
        };
        match (name == "line", is_filled) {
            (true, _) => self.passed_over += 1,
            (false, true) => self.paths.push(path),
            (false, false) => self.outlines.push(path),
        }
        Ok(())
    }

    /// Notes the curves and the extent of a shape, of which a part may be seen through a clip.
    fn measure(&mut self, subpaths: &[Subpath], part: Option<&(usize, Part)>) {
        let has_curves = |subpaths: &[Subpath]| subpaths.iter().any(|subpath| !subpath.cubics.is_empty());
        let is_curved =
            |&region: &usize| self.clips.region(region).is_some_and(|region| has_curves(&region.subpaths));
        let is_clipped_so = part.is_some_and(|(_, part)| part.regions.iter().any(is_curved));
        self.curve_count += usize::from(has_curves(subpaths) || is_clipped_so);
        let mut bounds = NO_BOUNDS;
        subpaths.iter().for_each(|subpath| subpath.extend(&mut bounds));
        if let Some((clip, _)) = part {
            let [low, high] = self.clips.bounds(*clip);
            let [own_low, own_high] = bounds;
            bounds = [
                [0, 1].map(|axis| own_low[axis].max(low[axis])),
                [0, 1].map(|axis| own_high[axis].min(high[axis])),
            ];
        }
        if (0..2).all(|axis| bounds[0][axis] <= bounds[1][axis]) {
            let ([own_low, own_high], [low, high]) = (self.bounds, bounds);
            self.bounds = [
                [0, 1].map(|axis| own_low[axis].min(low[axis])),
                [0, 1].map(|axis| own_high[axis].max(high[axis])),
            ];
        }
    }

    /// Notes that clipping made so many corners.
    fn cut(&mut self, corners: usize) -> Result<(), Error> {
        let left = self.cuts_left.checked_sub(corners);
        self.cuts_left = left.ok_or_else(|| too_many(Error::new(ErrorKind::TooLarge, "")))?;
        Ok(())
    }

    /// What is filled is the rings of one polygon, and so is what comes back where nothing is filled; all else is lines. Of what is clipped each connected part is a polygon.
    fn subpaths(
        &mut self,
        subpaths: &[Subpath],
        rule: FillRule,
        is_filled: bool,
        node: Node<'_, '_>,
        part: Option<&Part>,
    ) -> Result<(), Error> {
        let element = node.tag_name().name();
        let name = || format!("a part of <{element}> in line {}", line_of(node));
        let is_outline = self.takes_outlines;
        let is_ring = |subpath: &&Subpath| match is_filled {
            true => subpath.may_fill(),
            false => is_outline && subpath.comes_back(element),
        };
        let whole = |subpath: &Subpath| {
            let first = subpath.corners.first().filter(|_| subpath.is_closed);
            subpath.corners.iter().chain(first).copied().collect::<Vec<[f64; 2]>>()
        };
        let rings: Vec<Vec<[f64; 2]>> = subpaths.iter().filter(is_ring).map(whole).collect();
        self.outline_count += usize::from(!is_filled && !rings.is_empty());
        let (polygons, number) = match (part, rule) {
            (Some(part), _) => {
                let polygons = self.clips.clipped_rings(part, &rings, rule.inside(), self.cuts_left)?;
                self.cut(polygons.iter().flatten().map(Vec::len).sum())?;
                (polygons, 0)
            }
            (None, FillRule::Nonzero) => (vec![rings], 0),
            (None, FillRule::EvenOdd) => (vec![rings], 1),
        };
        for rings in polygons {
            self.drawing.begin_path();
            for ring in rings {
                // What is clipped is closed.
                let first = ring.first().filter(|_| part.is_some());
                for &[x, y] in ring.iter().chain(first) {
                    self.drawing.corner(Place { x, y, z: None });
                }
                if self.drawing.end_ring(name) {
                    self.fill_rules.push(number);
                }
            }
        }
        for subpath in subpaths.iter().filter(|subpath| !is_ring(subpath)) {
            let line = whole(subpath);
            let pieces = match part {
                Some(part) => {
                    let pieces = self.clips.clipped_line(part, line, self.cuts_left)?;
                    self.cut(pieces.iter().map(Vec::len).sum())?;
                    pieces
                }
                None => vec![line],
            };
            for piece in pieces {
                for [x, y] in piece {
                    self.drawing.corner(Place { x, y, z: None });
                }
                if self.drawing.end_line(name) {
                    self.fill_rules.push(-1);
                }
            }
        }
        Ok(())
    }
}
