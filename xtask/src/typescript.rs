//! `cargo xtask types`: the types of the answers for the viewer, in TypeScript, made of `docs/answers.schema.json`.

use crate::root;
use serde_json::{Map, Value};
use std::fmt::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Writes the types with `--write`; else says whether they are those of the schema.
pub(crate) fn types(words: &[String]) -> ExitCode {
    let is_writing = match words {
        [] => false,
        [word] if word == "--write" => true,
        _ => {
            eprintln!("usage: cargo xtask types [--write]");
            return ExitCode::from(2);
        }
    };
    let outcome = made().and_then(|made| match is_writing {
        true => std::fs::write(held(), made).map_err(|error| format!("{}: {error}", held().display())),
        false if is_held(&made) => Ok(()),
        false => {
            Err(format!("{}: not the types of the schema; run cargo xtask types --write", held().display()))
        }
    });
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

/// The file that has the types.
fn held() -> PathBuf {
    root().join("viewer/src/scene/answers.ts")
}

fn is_held(made: &str) -> bool {
    std::fs::read_to_string(held()).is_ok_and(|held| held == made)
}

/// The types as the schema has them.
fn made() -> Result<String, String> {
    let path = root().join("docs/answers.schema.json");
    let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let schema: Value =
        serde_json::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))?;
    typescript(&schema)
}

/// A module of TypeScript with one type for each definition of a schema.
fn typescript(schema: &Value) -> Result<String, String> {
    let mut text = "/**\n * The answers of the verbs: what the program prints with --json.\n *\n * \
                    Made of docs/answers.schema.json by `cargo xtask types --write`.\n */\n"
        .to_owned();
    let definitions = schema["$defs"].as_object().ok_or("the schema has no $defs")?;
    for (name, definition) in definitions {
        text.push('\n');
        text += &comment(definition, "");
        let in_place = |fault: String| format!("{name}: {fault}");
        // Writing to a string does not fail.
        let _ = match definition["properties"].as_object() {
            Some(properties) => {
                let body = fields(properties, definition).map_err(in_place)?;
                writeln!(text, "export interface {name} {{\n{body}}}")
            }
            None => writeln!(text, "export type {name} = {};", type_of(definition).map_err(in_place)?),
        };
    }
    Ok(text)
}

/// The fields of an interface, a line each.
fn fields(properties: &Map<String, Value>, definition: &Value) -> Result<String, String> {
    let required: Vec<&str> =
        definition["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    let mut text = String::new();
    for (key, property) in properties {
        text += &comment(property, "  ");
        let mark = if required.contains(&key.as_str()) { "" } else { "?" };
        let of = type_of(property).map_err(|fault| format!("{key}: {fault}"))?;
        text += &format!("  {key}{mark}: {of};\n");
    }
    Ok(text)
}

/// The description as a comment.
fn comment(definition: &Value, indent: &str) -> String {
    let Some(words) = definition["description"].as_str() else { return String::new() };
    let words = words.replace("*/", "* /");
    match words.lines().count() {
        0 | 1 => format!("{indent}/** {words} */\n"),
        _ => {
            let lines: String =
                words.lines().map(|line| format!("{indent} * {line}").trim_end().to_owned() + "\n").collect();
            format!("{indent}/**\n{lines}{indent} */\n")
        }
    }
}

/// The type of a schema, on one line.
fn type_of(schema: &Value) -> Result<String, String> {
    if let Some(place) = schema["$ref"].as_str() {
        return Ok(place.rsplit('/').next().unwrap_or(place).to_owned());
    }
    if *schema == Value::Bool(true) {
        return Ok("unknown".to_owned());
    }
    if let Some(value) = schema.get("const") {
        return Ok(value.to_string());
    }
    if let Some(values) = schema["enum"].as_array() {
        return Ok(values.iter().map(Value::to_string).collect::<Vec<_>>().join(" | "));
    }
    if let Some(choices) = schema["anyOf"].as_array().or(schema["oneOf"].as_array()) {
        let types = choices.iter().map(type_of).collect::<Result<Vec<_>, _>>()?;
        return Ok(types.join(" | "));
    }
    let names: Vec<&str> = match &schema["type"] {
        Value::String(name) => vec![name],
        Value::Array(names) => names.iter().filter_map(Value::as_str).collect(),
        _ => return Err(format!("{schema} has no type that is known here")),
    };
    let types = names.iter().map(|name| type_of_name(name, schema)).collect::<Result<Vec<_>, _>>()?;
    Ok(types.join(" | "))
}

fn type_of_name(name: &str, schema: &Value) -> Result<String, String> {
    Ok(match name {
        "integer" | "number" => "number".to_owned(),
        "string" | "boolean" | "null" => name.to_owned(),
        "array" => match (schema["prefixItems"].as_array(), schema.get("items")) {
            (Some(items), _) => {
                let types = items.iter().map(type_of).collect::<Result<Vec<_>, _>>()?;
                format!("[{}]", types.join(", "))
            }
            (None, Some(item)) => {
                let item = type_of(item)?;
                let bounds = [&schema["minItems"], &schema["maxItems"]].map(Value::as_u64);
                match bounds {
                    [Some(least), Some(most)] if least == most && most <= 4 => {
                        format!("[{}]", vec![item; usize::try_from(most).unwrap_or_default()].join(", "))
                    }
                    _ if item.contains(' ') && !item.starts_with('[') => format!("({item})[]"),
                    _ => format!("{item}[]"),
                }
            }
            (None, None) => return Err("an array without items".to_owned()),
        },
        "object" => match (schema["properties"].as_object(), schema.get("additionalProperties")) {
            (Some(properties), _) => {
                let body = fields(properties, schema)?;
                format!("{{ {} }}", body.split_whitespace().collect::<Vec<_>>().join(" "))
            }
            (None, Some(values)) => format!("Record<string, {}>", type_of(values)?),
            (None, None) => return Err("an object without properties".to_owned()),
        },
        other => return Err(format!("the type {other} is not known here")),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn the_types_of_the_viewer_are_those_of_the_schema() {
        let made = made().expect("the schema is in the repository");
        assert!(is_held(&made), "viewer/src/scene/answers.ts is not up to date: cargo xtask types --write");
    }

    #[test]
    fn schemas_become_types() {
        for (schema, expected) in [
            (json!({"type": ["integer", "null"]}), "number | null"),
            (json!({"type": "array", "items": {"type": "string"}}), "string[]"),
            (json!({"type": "array", "items": {"type": ["number", "null"]}}), "(number | null)[]"),
            (
                json!({"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}),
                "[number, number]",
            ),
            (
                json!({"type": "array", "prefixItems": [{"type": "number"}, {"$ref": "#/$defs/A"}]}),
                "[number, A]",
            ),
            (json!({"anyOf": [{"$ref": "#/$defs/A"}, {"type": "null"}]}), "A | null"),
            (json!({"oneOf": [{"const": "a"}, {"const": "b"}]}), "\"a\" | \"b\""),
            (
                json!({"type": "object", "additionalProperties": {"type": "integer"}}),
                "Record<string, number>",
            ),
        ] {
            assert_eq!(type_of(&schema).expect("a type"), expected);
        }
        assert!(type_of(&json!({"type": "date"})).is_err());
        let module = typescript(&json!({"$defs": {"Point": {
            "description": "A point.",
            "properties": {"x": {"type": "number", "description": "To the right."}, "name": {"type": "string"}},
            "required": ["x"], "type": "object",
        }}}));
        let expected = "/** A point. */\nexport interface Point {\n  name?: string;\n  /** To the right. */\n  x: number;\n}\n";
        assert!(module.expect("a module").ends_with(expected));
    }
}
