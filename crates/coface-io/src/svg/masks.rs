//! Masks that are clips: their shapes are white or black, and nothing shines through.

use super::clip_paths::{Referring, local_url};
use super::clipping::{Clip, Region};
use super::curves::Subpath;
use super::painting::{MaskPaint, Painting};
use super::reading::{Around, Reader, Whole, fault};
use super::style::{Property, Style};
use super::transformation::Transformation;
use super::viewport::{Extent, Viewport};
use coface_algebra::Error;
use roxmltree::Node;

/// A mask while its shapes are read.
pub(super) struct Masking {
    is_by_alpha: bool,
    /// What the shapes so far let through.
    shown: usize,
    /// Whether something in it is not plain black or white.
    pub(super) is_unknown: bool,
}

impl Reader {
    /// The clip of an element that its mask makes, within that of what is around it. A mask that is not done is counted.
    ///
    /// # Errors
    /// Those of [`Self::clip_within`].
    pub(super) fn mask_within<'a, 'input>(
        &mut self,
        around: Option<usize>,
        style: &Style<'_>,
        whole: &Whole<'a, 'input>,
        referring: &Referring<'a, 'input>,
    ) -> Result<Option<usize>, Error> {
        if !style.has(Property::Mask) {
            return Ok(around);
        }
        let value = style.of(Property::Mask).unwrap_or_default();
        let target = local_url(value).and_then(|id| whole.ids.get(id)).copied();
        let target = target
            .filter(|target| target.tag_name().name() == "mask" && !self.open_clips.contains(&target.id()));
        let found = match target {
            Some(target) => self.mask(target, whole, referring)?,
            None => None,
        };
        match found {
            Some(own) => Ok(Some(self.clips.within(around, own))),
            None => {
                self.undone.masks += 1;
                Ok(around)
            }
        }
    }

    fn mask<'a, 'input>(
        &mut self,
        target: Node<'a, 'input>,
        whole: &Whole<'a, 'input>,
        referring: &Referring<'a, 'input>,
    ) -> Result<Option<usize>, Error> {
        let style = whole.sheet.style(target);
        if style.has(Property::Mask) || style.has(Property::ClipPath) {
            return Ok(None);
        }
        let is_of_box = |name: &str, otherwise: &str| {
            target.attribute(name).map_or(otherwise, str::trim) == "objectBoundingBox"
        };
        let units = [("maskUnits", "objectBoundingBox"), ("maskContentUnits", "userSpaceOnUse")];
        let units = units.map(|(name, otherwise)| is_of_box(name, otherwise));
        let key = (target.id(), referring.map.bits(), referring.viewport.bits());
        let is_kept = units == [false; 2];
        if let Some(&known) = self.known_clips.get(&key).filter(|_| is_kept) {
            return Ok(known);
        }
        self.open_clip(target)?;
        let found = self.mask_of(target, units, whole, referring);
        self.open_clips.pop();
        let found = found?;
        if is_kept {
            self.known_clips.insert(key, found);
        }
        Ok(found)
    }

    fn mask_of<'a, 'input>(
        &mut self,
        target: Node<'a, 'input>,
        [is_box_of_box, is_content_of_box]: [bool; 2],
        whole: &Whole<'a, 'input>,
        referring: &Referring<'a, 'input>,
    ) -> Result<Option<usize>, Error> {
        let Referring { map, viewport, depth, .. } = *referring;
        let mut unit = Transformation::IDENTITY;
        if is_box_of_box || is_content_of_box {
            let ([low, high], _) = self.box_of(whole, referring)?;
            let [a, d] = [high[0] - low[0], high[1] - low[1]];
            if !(a > 0.0 && d > 0.0) {
                // Of a box without an extent nothing is a part, and the mask is passed over.
                return Ok(Some(self.clips.push(Clip::All(Vec::new()))));
            }
            unit = Transformation { a, d, e: low[0], f: low[1], ..unit };
        }
        let of = |is_of_box: bool| if is_of_box { map.after(&unit) } else { map };
        let mut painting = Painting::initial();
        let mut ancestors: Vec<Node<'_, '_>> = target.ancestors().filter(Node::is_element).collect();
        ancestors.reverse();
        for ancestor in ancestors {
            painting = painting.within(&whole.sheet.style(ancestor), &|id| whole.is_paint_server(id));
        }
        let is_by_alpha = whole.sheet.style(target).of(Property::MaskType) == Some("alpha");
        let shown = self.clips.push(Clip::Any(Vec::new()));
        let before = self.masking.replace(Masking { is_by_alpha, shown, is_unknown: false });
        let around = Around::masking(of(is_content_of_box), painting, viewport, depth + 1);
        let mut done = Ok(());
        for child in target.children().filter(Node::is_element) {
            done = done.and_then(|()| self.element(child, whole, &around, None));
        }
        let masking = std::mem::replace(&mut self.masking, before);
        done?;
        let Some(masking) = masking.filter(|masking| !masking.is_unknown) else { return Ok(None) };
        let Some(frame) = frame_of(target, is_box_of_box, &viewport)? else { return Ok(Some(masking.shown)) };
        let corners = frame.map(|corner| of(is_box_of_box).point(corner));
        if !corners.as_flattened().iter().all(|x| x.is_finite()) {
            return Err(fault(target, "a transformed coordinate is not finite"));
        }
        let frame = self.clips.push(Clip::Region(Region::frame(corners)));
        Ok(Some(self.clips.within(Some(frame), masking.shown)))
    }

    /// A shape of the mask that is being read.
    pub(super) fn mask_shape(&mut self, subpaths: Vec<Subpath>, painting: Painting, clip: Option<usize>) {
        let Some(masking) = &mut self.masking else { return };
        let paint = painting.in_mask(masking.is_by_alpha);
        if matches!(paint, MaskPaint::Unknown | MaskPaint::Nothing) {
            masking.is_unknown |= paint == MaskPaint::Unknown;
            return;
        }
        let shape = self.clips.push(Clip::Region(Region::new(subpaths, painting.rule.inside())));
        let shape = self.clips.within(clip, shape);
        let next = match paint {
            MaskPaint::Hides => Clip::Without([masking.shown, shape]),
            _ => Clip::Any(vec![masking.shown, shape]),
        };
        masking.shown = self.clips.push(next);
    }
}

/// The corners of the box of a mask; none where it is of a drawing whose size is not known.
fn frame_of(
    target: Node<'_, '_>,
    is_of_box: bool,
    viewport: &Viewport,
) -> Result<Option<[[f64; 2]; 4]>, Error> {
    let mut sides = [0.0; 4];
    let names =
        [("x", Extent::Width), ("y", Extent::Height), ("width", Extent::Width), ("height", Extent::Height)];
    for (side, (name, of)) in sides.iter_mut().zip(names) {
        let otherwise = if name.len() > 1 { "120%" } else { "-10%" };
        let text = target.attribute(name).map_or(otherwise, str::trim);
        let found = match (is_of_box, text.strip_suffix('%')) {
            (true, Some(percent)) => percent.trim().parse().ok().map(|percent: f64| percent / 100.0),
            (true, None) => text.parse().ok(),
            (false, _) if target.has_attribute(name) => {
                viewport.length(target, name, of).map_err(|text| fault(target, &text))?
            }
            (false, _) => viewport.parsed(text, of),
        };
        match found.filter(|found: &f64| found.is_finite()) {
            Some(found) => *side = found,
            None => return Ok(None),
        }
    }
    let [x, y, width, height] = sides;
    let [width, height] = [width.max(0.0), height.max(0.0)];
    Ok(Some([[x, y], [x + width, y], [x + width, y + height], [x, y + height]]))
}
