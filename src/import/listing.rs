//! What a DXF file names in its ENTITIES section, line by line: kinds, layers, handles and places in the file.
//!
//! The dxf crate drops entities that it does not know and stops at one that it cannot read; this listing says what
//! was there.

use super::ImportError;
use std::fmt;

/// More of a file is no drawing of a few tools \[bytes\].
const LARGEST: usize = 50_000_000;

/// An entity as the file names it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Listed {
    /// LINE, ARC, ...
    pub kind: String,
    pub layer: String,
    /// Hexadecimal, as CAD programs show it; empty in old files.
    pub handle: String,
    /// Line of the file, from 1.
    pub line: usize,
    /// Drawn on a sheet of paper, not in the model.
    pub on_paper: bool,
    /// Its first point, in drawing units: where a circle's centre, a text or a block is.
    pub at: [f64; 2],
}

impl fmt::Display for Listed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, layer, handle, line, .. } = self;
        let handle = if handle.is_empty() { String::new() } else { format!(" #{handle}") };
        write!(f, "{kind}{handle} of layer \"{layer}\" (line {line} of the file)")
    }
}

/// The file's text: UTF-8, or the Windows code page of older files.
pub(super) fn decode(bytes: &[u8]) -> Result<String, ImportError> {
    let text_help = "save the drawing as DXF in text form (ASCII), version R12 or later";
    if bytes.len() > LARGEST {
        let what = format!("the file is larger than {} MB", LARGEST / 1_000_000);
        return Err(ImportError::new(what, "save the tools' layers only"));
    }
    if bytes.starts_with(b"AutoCAD Binary DXF") {
        return Err(ImportError::new("the file is a binary DXF", text_help));
    }
    if bytes.starts_with(b"AC10") {
        return Err(ImportError::new("the file is a DWG, not a DXF", text_help));
    }
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text.trim_start_matches('\u{feff}').to_owned(),
        Err(_) => encoding_rs::WINDOWS_1252.decode(bytes).0.into_owned(),
    };
    Ok(text)
}

/// The entities of the model and of paper sheets; vertices and ends of sequences are parts of others.
pub(super) fn entities(text: &str) -> Result<Vec<Listed>, ImportError> {
    let mut found: Vec<Listed> = Vec::new();
    let (mut section, mut opens, mut is_dxf) = (String::new(), false, false);
    let mut lines = text.lines().map(str::trim).enumerate();
    while let Some((i, code)) = lines.next() {
        let Some((_, value)) = lines.next() else { break };
        let Ok(code) = code.parse::<i32>() else {
            let what = match is_dxf {
                true => format!("the file is damaged: line {} has to be a group code, and is \"{}\"", i + 1, cut(code)),
                false => "the file is not a DXF drawing: it does not begin with a section".to_owned(),
            };
            return Err(ImportError::new(what, "save it as DXF in text form (ASCII) again").at(i + 1));
        };
        is_dxf |= code == 0 && value == "SECTION";
        match (code, value) {
            (0, "SECTION") => opens = true,
            (2, name) if opens => (section, opens) = (name.to_owned(), false),
            (0, "ENDSEC") => section.clear(),
            (0, kind) if section == "ENTITIES" => {
                let kind = kind.to_owned();
                found.push(Listed { kind, layer: "0".to_owned(), line: i + 2, ..Listed::default() });
            }
            _ if section == "ENTITIES" => {
                if let Some(last) = found.last_mut() {
                    match code {
                        5 => last.handle = value.to_owned(),
                        8 => last.layer = value.to_owned(),
                        10 | 20 => last.at[usize::from(code == 20)] = value.parse().unwrap_or(0.0),
                        67 => last.on_paper = value == "1",
                        _ => {}
                    }
                }
            }
            _ => {}
        }
    }
    if !is_dxf {
        let what = "the file is not a DXF drawing: it has no section";
        return Err(ImportError::new(what, "give a DXF file in text form (ASCII)"));
    }
    Ok(found)
}

/// A quotation that stays short.
fn cut(text: &str) -> String {
    text.chars().take(40).collect()
}
