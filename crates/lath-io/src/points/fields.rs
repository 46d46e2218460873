//! One line cut into fields.

use crate::number;

/// What stands between two fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Delimiter {
    Semicolon,
    Comma,
    Tab,
    /// Any number of spaces and tabs.
    Blanks,
}

/// One field, without the blanks and quotation marks around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Field<'a> {
    /// Where it starts in the line, in bytes.
    pub(crate) offset: usize,
    pub(crate) text: &'a str,
    pub(crate) quoted: bool,
}

impl Field<'_> {
    /// The text with doubled quotation marks made single.
    pub(crate) fn unescaped(&self) -> String {
        if self.quoted { self.text.replace("\"\"", "\"") } else { self.text.to_owned() }
    }
}

impl Delimiter {
    const ALL: [Delimiter; 4] = [Delimiter::Semicolon, Delimiter::Comma, Delimiter::Tab, Delimiter::Blanks];

    fn is(self, c: char) -> bool {
        match self.character() {
            Some(character) => c == character,
            None => c.is_whitespace(),
        }
    }

    fn character(self) -> Option<char> {
        match self {
            Delimiter::Semicolon => Some(';'),
            Delimiter::Comma => Some(','),
            Delimiter::Tab => Some('\t'),
            Delimiter::Blanks => None,
        }
    }

    /// Where the next one is.
    fn find(self, text: &str) -> Option<usize> {
        match self.character() {
            Some(character) => text.find(character),
            None => text.find(char::is_whitespace),
        }
    }

    /// The delimiter that makes this line a row of numbers, or of what somebody meant as numbers: decimal commas, NaN,
    /// empty fields between numbers. `None` for titles and headers.
    pub(crate) fn of_row(line: &str) -> Option<Delimiter> {
        Delimiter::ALL.into_iter().find(|&delimiter| {
            let mut any = false;
            let mut numeric = |field: Field<'_>| {
                let is = number::parse(field.text).map_or_else(number::Refusal::is_meant_as_number, |_| true);
                any |= is;
                is || field.text.is_empty()
            };
            let all = delimiter.appears_in(line) && split(line, delimiter).all(|field| field.is_ok_and(&mut numeric));
            all && any
        })
    }

    /// The delimiter a line of words most likely has.
    pub(crate) fn of_words(line: &str) -> Delimiter {
        Delimiter::ALL.into_iter().find(|delimiter| delimiter.appears_in(line)).unwrap_or(Delimiter::Blanks)
    }

    /// The delimiters that a row of numbers and words may have, most likely first.
    pub(crate) fn candidates(row: &str) -> impl Iterator<Item = Delimiter> {
        Delimiter::ALL.into_iter().filter(move |delimiter| delimiter.appears_in(row))
    }

    /// True for a line that ends with this delimiter: its last field is empty, or it has one too many.
    pub(crate) fn ends(self, line: &str) -> bool {
        self.character().is_some_and(|character| line.trim_end_matches(' ').ends_with(character))
    }

    fn appears_in(self, line: &str) -> bool {
        self == Delimiter::Blanks || self.find(line).is_some()
    }
}

/// The fields of `line`, cut one by one: a line may have millions. One empty field behind a last delimiter is dropped.
///
/// An item is the offset of a quotation mark that is never closed, or of what follows a closing one before the next
/// delimiter; nothing comes behind it.
pub(crate) fn split(line: &str, delimiter: Delimiter) -> Fields<'_> {
    Fields { line, delimiter, at: Some(0), first: true }
}

/// See [`split`].
#[derive(Clone, Debug)]
pub(crate) struct Fields<'a> {
    line: &'a str,
    delimiter: Delimiter,
    /// Where the next field begins, blanks before it; none at the end.
    at: Option<usize>,
    first: bool,
}

impl<'a> Iterator for Fields<'a> {
    type Item = Result<Field<'a>, usize>;

    fn next(&mut self) -> Option<Self::Item> {
        let mut at = self.at.take()?;
        at += blanks(&self.line[at..], self.delimiter);
        let rest = &self.line[at..];
        if rest.is_empty() && (self.delimiter == Delimiter::Blanks || !self.first) {
            return None; // the one empty field behind a last delimiter
        }
        self.first = false;
        let Some(inner) = rest.strip_prefix('"') else {
            let length = self.delimiter.find(rest).unwrap_or(rest.len());
            self.at = rest[length..].chars().next().map(|c| at + length + c.len_utf8());
            return Some(Ok(Field { offset: at, text: rest[..length].trim_end(), quoted: false }));
        };
        let Some(length) = closing(inner) else { return Some(Err(at)) };
        let field = Field { offset: at + 1, text: &inner[..length], quoted: true };
        at += length + 2;
        let gap = blanks(&self.line[at..], self.delimiter);
        at += gap;
        match self.line[at..].chars().next() {
            None => {}
            Some(c) if self.delimiter.is(c) => self.at = Some(at + c.len_utf8()),
            Some(_) if self.delimiter == Delimiter::Blanks && gap > 0 => self.at = Some(at),
            Some(_) => return Some(Err(at)),
        }
        Some(Ok(field))
    }
}

/// The bytes of blanks at the start of `text` that are no delimiters, or all blanks where blanks are the delimiter.
fn blanks(text: &str, delimiter: Delimiter) -> usize {
    let skip = |c: char| c.is_whitespace() && (delimiter == Delimiter::Blanks || !delimiter.is(c));
    text.find(|c| !skip(c)).unwrap_or(text.len())
}

/// Where the closing quotation mark is; two together are a mark inside.
fn closing(inner: &str) -> Option<usize> {
    let mut at = 0;
    loop {
        at += inner[at..].find('"')?;
        if !inner[at + 1..].starts_with('"') {
            return Some(at);
        }
        at += 2;
    }
}

/// The line without its comment: everything from the first `#` outside quotation marks.
pub(crate) fn without_comment(line: &str) -> &str {
    if !line.contains('#') {
        return line;
    }
    let mut quoted = false;
    let start = line.bytes().position(|b| {
        quoted ^= b == b'"';
        b == b'#' && !quoted
    });
    start.map_or(line, |i| &line[..i])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(line: &str, delimiter: Delimiter) -> Vec<String> {
        let fields: Vec<_> = split(line, delimiter).collect::<Result<_, _>>().unwrap();
        for field in &fields {
            assert!(line[field.offset..].starts_with(field.text));
        }
        fields.iter().map(Field::unescaped).collect()
    }

    #[test]
    fn fields_are_cut() {
        use Delimiter::{Blanks, Comma, Semicolon, Tab};
        assert_eq!(texts(" 1 ,2,\t3", Comma), ["1", "2", "3"]);
        assert_eq!(texts("1,2,", Comma), ["1", "2"]);
        assert_eq!(texts("1,2,,", Comma), ["1", "2", ""]);
        assert_eq!(texts("1,2, ", Comma), ["1", "2"]);
        assert_eq!(texts(",x", Comma), ["", "x"]);
        assert_eq!(texts("1\t\t 3", Tab), ["1", "", "3"]);
        assert_eq!(texts("  1 \t 2  ", Blanks), ["1", "2"]);
        assert_eq!(texts("1;2 3;", Semicolon), ["1", "2 3"]);
        assert_eq!(texts("\"a, \"\"b\"\"\" , \"\",c", Comma), ["a, \"b\"", "", "c"]);
        assert_eq!(texts("\"a b\" c", Blanks), ["a b", "c"]);
    }

    #[test]
    fn stray_quotation_marks_are_found() {
        let fault = |line, delimiter| split(line, delimiter).try_for_each(|field| field.map(|_| ()));
        assert_eq!(fault("1,\"2", Delimiter::Comma), Err(2));
        assert_eq!(fault("\"1\"2,3", Delimiter::Comma), Err(3));
        assert_eq!(fault("\"1\"2", Delimiter::Blanks), Err(3));
        assert_eq!(fault("1,2\"", Delimiter::Comma), Ok(())); // only at the start of a field
    }

    #[test]
    fn rows_are_told_from_titles() {
        let rows = [
            ("1,2", Delimiter::Comma),
            ("1 2", Delimiter::Blanks),
            ("7", Delimiter::Blanks),
            ("1;2", Delimiter::Semicolon),
            ("1,5;2,5", Delimiter::Semicolon),
            ("1,5 2,5", Delimiter::Blanks),
            ("1.0, 2.0", Delimiter::Comma),
            ("1\t\t2", Delimiter::Tab),
            ("1 2\t3", Delimiter::Blanks),
            ("nan 0x10", Delimiter::Blanks),
        ];
        for (line, delimiter) in rows {
            assert_eq!(Delimiter::of_row(line), Some(delimiter), "{line}");
        }
        for title in [" RAE 2822 AIRFOIL", "x,y", ",x,y", "\"YEAR\",\"SUNACTIVITY\"", "1,a", ",,", "5\" pipe", "3D"] {
            assert_eq!(Delimiter::of_row(title), None, "{title}");
        }
    }

    #[test]
    fn comments_end_lines() {
        assert_eq!(without_comment("1 2 # three"), "1 2 ");
        assert_eq!(without_comment("\"a#b\" 2 # c"), "\"a#b\" 2 ");
        assert_eq!(without_comment("# all"), "");
        assert_eq!(without_comment("none"), "none");
    }
}
