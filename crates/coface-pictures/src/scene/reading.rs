//! JSON read into types, where a fault begins with its place: `generators[1][0].chain[2][0] is "x", not a number`.

use serde::de::{self, Deserialize, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::fmt::{self, Display};
use std::marker::PhantomData;

/// What is written at a place: lists and objects are passed over.
#[derive(Clone)]
pub(super) enum Found {
    Null,
    Boolean(bool),
    Whole(i128),
    Real(f64),
    Text(String),
    List,
    Object,
}

impl Display for Found {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Null => formatter.write_str("null"),
            Self::Boolean(value) => value.fmt(formatter),
            Self::Whole(value) => value.fmt(formatter),
            Self::Real(value) => write!(formatter, "{value:?}"),
            Self::Text(text) => write!(formatter, "{:?}", text.chars().take(40).collect::<String>()),
            Self::List => formatter.write_str("a list"),
            Self::Object => formatter.write_str("an object"),
        }
    }
}

impl Found {
    pub(super) fn fault<E: de::Error>(&self, wanted: &str) -> E {
        E::custom(format_args!(" is {self}, not {wanted}"))
    }
}

/// Puts a place in front of the fault of what stands there.
pub(super) fn within<E: de::Error>(place: impl Display, fault: &impl Display) -> E {
    let fault = fault.to_string();
    let separator = if fault.starts_with(['.', '[', ' ']) { "" } else { ": " };
    E::custom(format_args!("{place}{separator}{fault}"))
}

/// The methods of a visitor for what is neither a list nor an object: they call `other`.
macro_rules! scalars {
    () => {
        fn expecting(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
            formatter.write_str("JSON")
        }
        fn visit_unit<E: serde::de::Error>(self) -> Result<Self::Value, E> {
            Self::other(self, &$crate::scene::reading::Found::Null)
        }
        fn visit_bool<E: serde::de::Error>(self, value: bool) -> Result<Self::Value, E> {
            Self::other(self, &$crate::scene::reading::Found::Boolean(value))
        }
        fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<Self::Value, E> {
            Self::other(self, &$crate::scene::reading::Found::Whole(value.into()))
        }
        fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<Self::Value, E> {
            Self::other(self, &$crate::scene::reading::Found::Whole(value.into()))
        }
        fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<Self::Value, E> {
            Self::other(self, &$crate::scene::reading::Found::Real(value))
        }
        fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Self::Value, E> {
            Self::other(self, &$crate::scene::reading::Found::Text(text.to_owned()))
        }
    };
}
pub(super) use scalars;

struct FoundVisitor;

impl FoundVisitor {
    #[expect(clippy::unnecessary_wraps, reason = "the macro calls others that refuse")]
    fn other<E: de::Error>(_: Self, found: &Found) -> Result<Found, E> {
        Ok(found.clone())
    }
}

impl<'de> Visitor<'de> for FoundVisitor {
    type Value = Found;
    scalars!();
    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Found, A::Error> {
        skip_list(&mut list).map(|()| Found::List)
    }
    fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<Found, A::Error> {
        skip_object(&mut object).map(|()| Found::Object)
    }
}

impl<'de> Deserialize<'de> for Found {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        source.deserialize_any(FoundVisitor)
    }
}

pub(super) fn skip_list<'de, A: SeqAccess<'de>>(list: &mut A) -> Result<(), A::Error> {
    while list.next_element::<IgnoredAny>()?.is_some() {}
    Ok(())
}

fn skip_object<'de, A: MapAccess<'de>>(object: &mut A) -> Result<(), A::Error> {
    while object.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
    Ok(())
}

/// Reads the rest of a list, whose first entry has this number.
pub(super) fn entries_from<'de, A: SeqAccess<'de>, T: Deserialize<'de>>(
    list: &mut A,
    found: &mut Vec<T>,
) -> Result<(), A::Error> {
    loop {
        match list.next_element() {
            Ok(Some(entry)) => found.push(entry),
            Ok(None) => return Ok(()),
            Err(fault) => return Err(within(format_args!("[{}]", found.len()), &fault)),
        }
    }
}

/// A list, or something else such as a count, which some verbs have at the same key.
pub(super) struct Entries<T>(Option<Vec<T>>);

impl<T> Default for Entries<T> {
    fn default() -> Self {
        Self(None)
    }
}

impl<T> Entries<T> {
    /// The list; none if something else stands there.
    pub(super) fn given(&self) -> Option<&[T]> {
        self.0.as_deref()
    }

    /// The list; empty if something else stands there.
    pub(super) fn list(&self) -> &[T] {
        self.given().unwrap_or_default()
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Entries<T> {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        source.deserialize_any(ListVisitor { wanted: None, entry: PhantomData }).map(Self)
    }
}

/// Reads a list; where something else stands, that is a fault if it says what is wanted.
pub(super) struct ListVisitor<T> {
    pub(super) wanted: Option<&'static str>,
    pub(super) entry: PhantomData<T>,
}

impl<T> ListVisitor<T> {
    fn other<E: de::Error>(self, found: &Found) -> Result<Option<Vec<T>>, E> {
        self.wanted.map_or(Ok(None), |wanted| Err(found.fault(wanted)))
    }
}

impl<'de, T: Deserialize<'de>> Visitor<'de> for ListVisitor<T> {
    type Value = Option<Vec<T>>;
    scalars!();
    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Option<Vec<T>>, A::Error> {
        let mut found = Vec::with_capacity(list.size_hint().unwrap_or(0).min(1 << 20));
        entries_from(&mut list, &mut found)?;
        Ok(Some(found))
    }
    fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<Option<Vec<T>>, A::Error> {
        skip_object(&mut object)?;
        self.other(&Found::Object)
    }
}

/// A struct with the keys of an object that are `needed`, and those that `may` be there: these are empty where there is none, or null.
/// Other keys are passed over, as verbs say more than is drawn. Without needed keys anything that is no object is an empty one.
macro_rules! keyed {
    (
        $(#[$about:meta])* struct $name:ident {
            needed: { $($(#[$needed_about:meta])* $needed:ident: $needed_type:ty,)* }
            may: { $($(#[$may_about:meta])* $may:ident: $may_type:ty,)* }
        }
    ) => {
        $(#[$about])*
        pub(super) struct $name {
            $($(#[$needed_about])* pub(super) $needed: $needed_type,)*
            $($(#[$may_about])* pub(super) $may: $may_type,)*
        }

        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
                use $crate::scene::reading::{Found, scalars, skip_list, within};
                #[derive(Default)]
                struct Read {
                    $($needed: Option<$needed_type>,)*
                    $($may: Option<$may_type>,)*
                }
                impl Read {
                    fn finish<E: serde::de::Error>(self) -> Result<$name, E> {
                        Ok($name {
                            $($needed: self.$needed.ok_or_else(|| {
                                E::custom(concat!(" has no \"", stringify!($needed), "\""))
                            })?,)*
                            $($may: self.$may.unwrap_or_default(),)*
                        })
                    }
                    fn other<E: serde::de::Error>(self, _: &Found) -> Result<$name, E> {
                        self.finish()
                    }
                }
                impl<'de> serde::de::Visitor<'de> for Read {
                    type Value = $name;
                    scalars!();
                    fn visit_seq<A: serde::de::SeqAccess<'de>>(self, mut list: A) -> Result<$name, A::Error> {
                        skip_list(&mut list)?;
                        self.finish()
                    }
                    fn visit_map<A: serde::de::MapAccess<'de>>(mut self, mut object: A) -> Result<$name, A::Error> {
                        while let Some(key) = object.next_key::<String>()? {
                            match key.as_str() {
                                $(stringify!($needed) => self.$needed = Some(object.next_value()
                                    .map_err(|fault| within(concat!(".", stringify!($needed)), &fault))?),)*
                                $(stringify!($may) => self.$may = object.next_value()
                                    .map_err(|fault| within(concat!(".", stringify!($may)), &fault))?,)*
                                _ => {
                                    object.next_value::<serde::de::IgnoredAny>()?;
                                }
                            }
                        }
                        self.finish()
                    }
                }
                source.deserialize_any(Read::default())
            }
        }
    };
}
pub(super) use keyed;
