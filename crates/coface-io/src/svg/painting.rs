//! How shapes are painted.

use super::clip_paths::local_url;
use super::elements::FillRule;
use super::style::{Property, Style};

/// How shapes are filled where nothing else is said.
#[derive(Clone, Copy)]
pub(super) struct Painting {
    pub(super) rule: FillRule,
    is_filled: bool,
    /// Whether what is filled is seen at all.
    is_opaque: bool,
    pub(super) is_visible: bool,
    color: Color,
    pub(super) has_stroke: bool,
    /// Whether something around it or of its own lets what is behind it shine through, or makes it soft.
    is_translucent: bool,
    /// How the `use` is painted that draws it, if one does.
    context: Option<Context>,
}

/// What `context-fill` and `context-stroke` mean.
#[derive(Clone, Copy)]
struct Context {
    is_filled: bool,
    color: Color,
    has_stroke: bool,
}

/// What a value of `fill` or `stroke` says.
enum Paint<'v> {
    /// A color, a paint server of this file, or what is not known.
    Stated(&'v str),
    ContextFill,
    ContextStroke,
    /// A paint server of this file that is not there, without another paint behind it: as `none`.
    Missing,
}

impl<'v> Paint<'v> {
    /// The paint of a value, where `is_server` knows the paint servers of the file by their names.
    fn of(value: &'v str, is_server: &dyn Fn(&str) -> bool) -> Self {
        let value = value.trim();
        if local_url(value).is_some_and(|name| !is_server(name)) {
            let fallback = value.split_once(')').map_or("", |(_, rest)| rest.trim());
            return if fallback.is_empty() { Self::Missing } else { Self::of(fallback, is_server) };
        }
        match value {
            "context-fill" => Self::ContextFill,
            "context-stroke" => Self::ContextStroke,
            _ => Self::Stated(value),
        }
    }
}

/// How many of the paints that an element states itself are paint servers that are not there.
pub(super) fn missing_paints(style: &Style<'_>, is_server: &dyn Fn(&str) -> bool) -> usize {
    let is_missing = |property: &Property| {
        style.of(*property).is_some_and(|value| matches!(Paint::of(value, is_server), Paint::Missing))
    };
    [Property::Fill, Property::Stroke].iter().filter(|property| is_missing(property)).count()
}

/// What shapes are filled with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Color {
    White,
    Black,
    /// Another color that hides what is behind it.
    Other,
    /// A gradient, a pattern, or what is not known.
    Unknown,
}

impl Color {
    fn of(paint: &str) -> Self {
        let paint: String = paint.chars().filter(|c| !c.is_whitespace()).collect();
        let paint = paint.to_ascii_lowercase();
        let is_hex = |text: &str| text.chars().all(|c| c.is_ascii_hexdigit());
        match paint.as_str() {
            "white" | "#fff" | "#ffffff" | "rgb(255,255,255)" | "rgb(100%,100%,100%)" => Self::White,
            "black" | "#000" | "#000000" | "rgb(0,0,0)" | "rgb(0%,0%,0%)" => Self::Black,
            text => match text.strip_prefix('#') {
                Some(digits) if is_hex(digits) && matches!(digits.len(), 3 | 6) => Self::Other,
                None if !text.is_empty() && text.chars().all(|c| c.is_ascii_alphabetic()) => match text {
                    "currentcolor" => Self::Unknown,
                    _ => Self::Other,
                },
                None if text.starts_with("rgb(") && !text.contains('/') => Self::Other,
                _ => Self::Unknown,
            },
        }
    }
}

/// Whether a paint leaves nothing to be seen: `none`, `transparent`, or a color without opacity.
fn is_clear(paint: &str) -> bool {
    let paint = paint.trim().to_ascii_lowercase();
    if let Some(digits) = paint.strip_prefix('#') {
        let alpha = match digits.len() {
            4 => digits.get(3..),
            8 => digits.get(6..),
            _ => None,
        };
        return alpha.is_some_and(|alpha| alpha.chars().all(|digit| digit == '0'));
    }
    let Some((name, rest)) = paint.split_once('(') else {
        return matches!(&paint[..], "none" | "transparent");
    };
    let numbers = rest.strip_suffix(')').filter(|_| matches!(name, "rgb" | "rgba" | "hsl" | "hsla"));
    let alpha = numbers.and_then(|numbers| match numbers.split_once('/') {
        Some((_, alpha)) => Some(alpha),
        None => numbers.split(',').nth(3),
    });
    alpha.is_some_and(|alpha| alpha.trim().trim_end_matches('%').parse().is_ok_and(|alpha: f64| alpha <= 0.0))
}

/// What a shape in a mask does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MaskPaint {
    Shows,
    Hides,
    Nothing,
    /// Neither: it is grey, or has an outline.
    Unknown,
}

impl Painting {
    /// That of the outermost element.
    pub(super) fn initial() -> Self {
        Self {
            rule: FillRule::Nonzero,
            is_filled: true,
            is_opaque: true,
            is_visible: true,
            color: Color::Black,
            has_stroke: false,
            is_translucent: false,
            context: None,
        }
    }

    /// That of what a `use` draws that is painted so.
    pub(super) fn used(self) -> Self {
        let Self { is_filled, color, has_stroke, .. } = self;
        Self { context: Some(Context { is_filled, color, has_stroke }), ..self }
    }

    /// What a shape does in a mask, by its lightness or by its alpha.
    pub(super) fn in_mask(self, is_by_alpha: bool) -> MaskPaint {
        match self.color {
            _ if self.has_stroke => MaskPaint::Unknown,
            _ if !self.fills() => MaskPaint::Nothing,
            _ if self.is_translucent => MaskPaint::Unknown,
            Color::White => MaskPaint::Shows,
            Color::Unknown => MaskPaint::Unknown,
            Color::Black | Color::Other if is_by_alpha => MaskPaint::Shows,
            Color::Black => MaskPaint::Hides,
            Color::Other => MaskPaint::Unknown,
        }
    }

    /// That of an element in another, where `is_server` knows the paint servers of the file. `context-fill` where there is no context is `none`.
    pub(super) fn within(self, style: &Style<'_>, is_server: &dyn Fn(&str) -> bool) -> Self {
        let is_inherited = |value: &str| matches!(value, "inherit" | "unset");
        let own = |property: Property| style.of(property).filter(|value| !is_inherited(value));
        let paint = |property: Property| own(property).map(|value| Paint::of(value, is_server));
        let (is_filled, color) = match (paint(Property::Fill), self.context) {
            (None, _) => (self.is_filled, self.color),
            (Some(Paint::Stated(paint)), _) => (!is_clear(paint), Color::of(paint)),
            (Some(Paint::ContextFill), Some(context)) => (context.is_filled, context.color),
            (Some(Paint::ContextStroke), Some(context)) => (context.has_stroke, Color::Unknown),
            (Some(Paint::Missing), _) | (Some(_), None) => (false, Color::Unknown),
        };
        let has_stroke = match (paint(Property::Stroke), self.context) {
            (None, _) => self.has_stroke,
            (Some(Paint::Stated(paint)), _) => !matches!(paint, "none" | "transparent" | "initial"),
            (Some(Paint::ContextFill), Some(context)) => context.is_filled,
            (Some(Paint::ContextStroke), Some(context)) => context.has_stroke,
            (Some(Paint::Missing), _) | (Some(_), None) => false,
        };
        Self {
            rule: match own(Property::FillRule) {
                Some("evenodd") => FillRule::EvenOdd,
                Some("nonzero" | "initial") => FillRule::Nonzero,
                _ => self.rule,
            },
            is_filled,
            is_opaque: own(Property::FillOpacity).map_or(self.is_opaque, |opacity| {
                opacity.trim_end_matches('%').trim().parse().map_or(true, |opacity: f64| opacity > 0.0)
            }),
            is_visible: match own(Property::Visibility) {
                Some("hidden" | "collapse") => false,
                Some("visible" | "initial") => true,
                _ => self.is_visible,
            },
            color,
            has_stroke,
            is_translucent: self.is_translucent
                || style.has(Property::Filter)
                || [Property::Opacity, Property::FillOpacity].into_iter().any(|property| {
                    own(property).is_some_and(|opacity| !matches!(opacity, "1" | "1.0" | "100%" | "initial"))
                }),
            context: self.context,
        }
    }

    pub(super) fn fills(self) -> bool {
        self.is_filled && self.is_opaque
    }
}
