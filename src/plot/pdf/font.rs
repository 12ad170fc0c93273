//! The built-in font inside of a PDF file, its letters by the numbers of their glyphs.

use super::stream::{FONT, LEVEL, stream_of};
use crate::plot::font;
use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap};
use pdf_writer::{Content, Filter, Finish, Name, Rect, Ref, Str};

const NAME: Name = Name(b"STMPFL+DejaVuSans");
const SYSTEM: SystemInfo = SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };
/// Units of a font in a PDF file over its em.
const EM: f64 = 1000.0;

/// Shows a text, two bytes for each letter. Letters that follow each other as the font has it go together; accents that are
/// letters of their own are moved to where they belong.
pub(super) fn show(text: &str, content: &mut Content) {
    let mut line = content.show_positioned();
    let mut items = line.items();
    let (mut together, mut end) = (Vec::new(), 0.0);
    for (letter, glyph, at) in font::placed(text) {
        if at != end {
            items.show(Str(&together)).adjust((EM * (end - at)) as f32);
            together.clear();
        }
        together.extend(glyph.0.to_be_bytes());
        end = at + font::glyph(letter).1;
    }
    items.show(Str(&together));
}

/// Writes the font as object `id`, what it consists of as the `next` ones.
pub(super) fn embed(file: &mut pdf_writer::Pdf, id: Ref, next: &mut dyn FnMut() -> Ref) {
    let (cid, descriptor, unicode, data) = (next(), next(), next(), next());
    file.type0_font(id)
        .base_font(NAME)
        .encoding_predefined(Name(b"Identity-H"))
        .descendant_font(cid)
        .to_unicode(unicode);

    let mut letters = file.cid_font(cid);
    letters.subtype(CidFontType::Type2).base_font(NAME).system_info(SYSTEM).font_descriptor(descriptor);
    letters.cid_to_gid_map_predefined(Name(b"Identity"));
    letters.widths().consecutive(0, font::advances().map(|em| (EM * em) as f32));
    letters.finish();

    let (extent, ascent, descent) = font::extent();
    let [left, bottom, right, top] = extent.map(|em| (EM * em) as f32);
    file.font_descriptor(descriptor)
        .name(NAME)
        .flags(FontFlags::SYMBOLIC)
        .bbox(Rect::new(left, bottom, right, top))
        .italic_angle(0.0)
        .ascent((EM * ascent) as f32)
        .descent((EM * descent) as f32)
        .cap_height(729.0)
        .stem_v(80.0)
        .font_file2(data);

    let mut map = UnicodeCmap::new(FONT, SYSTEM);
    font::letters().for_each(|(letter, glyph)| map.pair(glyph.0, letter));
    stream_of(file, unicode, map.finish().as_slice());

    let pressed = compress_to_vec_zlib(font::DATA, LEVEL);
    file.stream(data, &pressed).filter(Filter::FlateDecode).pair(Name(b"Length1"), font::DATA.len() as i32);
}
