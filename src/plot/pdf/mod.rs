//! PDF files: pages drawn with vectors and with the letters of the built-in font, which goes into the file.
//!
//! Lengths are in points, 1/72 in, from a page's upper left corner, y down. Nothing is of the clock: a file written twice is
//! the same.

mod font;
mod page;
mod stream;

pub use page::{Letters, Page};

use pdf_writer::{Finish, Rect, Ref, TextStr};
use stream::{FONT, stream_of};

/// One mm \[pt\].
pub const MM: f64 = 72.0 / 25.4;

/// A file in the making.
#[derive(Debug, Default)]
pub struct Pdf {
    /// What readers show as the document's name.
    pub title: String,
    /// Who wrote it; may be empty.
    pub author: String,
    /// The program that made it.
    pub creator: String,
    /// Its language, as `en`.
    pub language: String,
    /// From the first.
    pub pages: Vec<Page>,
    /// Headings in order, each with its page, counted from 0, and how far down it stands: a reader's list of contents.
    pub headings: Vec<(String, usize, f64)>,
}

/// Hands out numbers of objects.
struct Numbers(i32);

impl Numbers {
    fn next(&mut self) -> Ref {
        self.0 += 1;
        Ref::new(self.0)
    }
}

impl Pdf {
    /// The whole file.
    pub fn bytes(self) -> Vec<u8> {
        let mut numbers = Numbers(0);
        let mut file = pdf_writer::Pdf::new();
        let (catalog, tree, font, info) = (numbers.next(), numbers.next(), numbers.next(), numbers.next());
        let ids: Vec<Ref> = self.pages.iter().map(|_| numbers.next()).collect();
        let heights: Vec<f64> = self.pages.iter().map(Page::height).collect();
        file.pages(tree).kids(ids.iter().copied()).count(ids.len() as i32);
        for (page, &id) in self.pages.into_iter().zip(&ids) {
            let (size, content, stream) = (page.size(), page.finish(), numbers.next());
            file.page(id)
                .parent(tree)
                .media_box(Rect::new(0.0, 0.0, size.0 as f32, size.1 as f32))
                .contents(stream)
                .resources()
                .fonts()
                .pair(FONT, font);
            stream_of(&mut file, stream, &content);
        }
        font::embed(&mut file, font, &mut || numbers.next());
        let mut about = file.document_info(info);
        about.title(TextStr(&self.title)).creator(TextStr(&self.creator));
        if !self.author.is_empty() {
            about.author(TextStr(&self.author));
        }
        about.finish();

        let outline = (!self.headings.is_empty()).then(|| numbers.next());
        let items: Vec<Ref> = self.headings.iter().map(|_| numbers.next()).collect();
        for (i, (text, page, down)) in self.headings.iter().enumerate() {
            let mut item = file.outline_item(items[i]);
            item.title(TextStr(text)).parent(outline.expect("there are headings"));
            if i > 0 {
                item.prev(items[i - 1]);
            }
            if let Some(&next) = items.get(i + 1) {
                item.next(next);
            }
            item.dest().page(ids[*page]).xyz(0.0, (heights[*page] - down) as f32, None);
        }
        if let (Some(outline), Some(&first), Some(&last)) = (outline, items.first(), items.last()) {
            file.outline(outline).first(first).last(last).count(items.len() as i32);
        }
        let mut root = file.catalog(catalog);
        root.pages(tree).lang(TextStr(&self.language)).viewer_preferences().display_doc_title(true);
        if let Some(outline) = outline {
            root.outlines(outline);
        }
        root.finish();
        file.finish()
    }
}

/// How wide a line of text is in a font of this size \[pt\].
pub fn text_width(text: &str, size: f64) -> f64 {
    size * crate::plot::font::width(text)
}
