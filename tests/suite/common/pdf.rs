//! The words on the pages of a PDF file of ours, read back: pressed streams, letters by a map to Unicode.

use std::collections::HashMap;

/// The text of each page, its lines as they were drawn.
pub fn pages(file: &[u8]) -> Vec<String> {
    let streams: Vec<Vec<u8>> = streams(file);
    let map = streams.iter().find_map(|stream| letters(stream)).expect("a map of letters");
    // Pages begin by turning the plane over: y goes down.
    let drawn = streams.iter().filter(|stream| stream.starts_with(b"1 0 0 -1 0 "));
    drawn.map(|stream| words(stream, &map)).collect()
}

fn find(bytes: &[u8], what: &[u8]) -> Option<usize> {
    bytes.windows(what.len()).position(|part| part == what)
}

/// Every stream of the file, unpressed.
fn streams(file: &[u8]) -> Vec<Vec<u8>> {
    let (mut found, mut rest) = (Vec::new(), file);
    while let Some(start) = find(rest, b"stream\n") {
        rest = &rest[start + 7..];
        let end = find(rest, b"endstream").expect("an end");
        found.push(miniz_oxide::inflate::decompress_to_vec_zlib(&rest[..end]).expect("pressed"));
        rest = &rest[end + 9..];
    }
    found
}

/// `<0024> <0041>` of each letter.
fn letters(stream: &[u8]) -> Option<HashMap<u16, char>> {
    let text = std::str::from_utf8(stream).ok().filter(|text| text.contains("beginbfchar"))?;
    let pair = |line: &str| {
        let (glyph, letter) = line.strip_prefix('<')?.strip_suffix('>')?.split_once("> <")?;
        let letter = u16::from_str_radix(letter, 16).ok()?;
        Some((u16::from_str_radix(glyph, 16).ok()?, char::from_u32(u32::from(letter))?))
    };
    let body = &text[text.find("beginbfchar")?..];
    Some(body.lines().filter_map(pair).collect())
}

/// A line for each text that is shown.
fn words(stream: &[u8], map: &HashMap<u16, char>) -> String {
    let (mut text, mut at) = (String::new(), 0);
    while let Some(begin) = find(&stream[at..], b"BT\n") {
        at += begin + 2;
        let end = at + find(&stream[at..], b"\nET").expect("an end");
        for glyph in strings(&stream[at..end]).chunks_exact(2) {
            text.push(map.get(&u16::from_be_bytes([glyph[0], glyph[1]])).copied().unwrap_or('?'));
        }
        text.push('\n');
        at = end;
    }
    text
}

/// The bytes of all strings, literal or hexadecimal.
fn strings(shown: &[u8]) -> Vec<u8> {
    let (mut bytes, mut i) = (Vec::new(), 0);
    while i < shown.len() {
        match shown[i] {
            b'<' => {
                let end = i + find(&shown[i..], b">").expect("an end");
                let digits = std::str::from_utf8(&shown[i + 1..end]).expect("digits");
                bytes.extend((0..digits.len() / 2).map(|j| u8::from_str_radix(&digits[2 * j..2 * j + 2], 16).unwrap()));
                i = end;
            }
            b'(' => i = literal(shown, i + 1, &mut bytes),
            _ => {}
        }
        i += 1;
    }
    bytes
}

/// Bytes up to the bracket that closes, and where that is; brackets inside are in pairs or escaped.
fn literal(shown: &[u8], mut i: usize, bytes: &mut Vec<u8>) -> usize {
    let mut open = 1;
    loop {
        match shown[i] {
            b'\\' if shown[i + 1].is_ascii_digit() => {
                let octal = std::str::from_utf8(&shown[i + 1..i + 4]).expect("digits");
                bytes.push(u8::from_str_radix(octal, 8).expect("octal"));
                i += 3;
            }
            b'\\' => {
                i += 1;
                let named = [(b'n', b'\n'), (b'r', b'\r'), (b't', b'\t'), (b'b', 8), (b'f', 12)];
                bytes.push(named.iter().find(|(name, _)| *name == shown[i]).map_or(shown[i], |(_, byte)| *byte));
            }
            b')' if open == 1 => return i,
            byte => {
                open += i32::from(byte == b'(') - i32::from(byte == b')');
                bytes.push(byte);
            }
        }
        i += 1;
    }
}
