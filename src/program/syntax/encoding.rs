//! Bytes of program files to text and back, for any bytes at all.
//!
//! Files are UTF-8, with or without a byte order mark, UTF-16 with one, GBK, or of one of the Windows code pages; which
//! one is guessed from the bytes. Invariant: `decode(bytes).encode(&decode(bytes).text) == bytes`; Windows-1252 as
//! WHATWG defines it gives each of the 256 bytes a character of its own, so it can stand in for any unknown encoding.
use std::borrow::Cow;

const BOM: &[u8] = b"\xEF\xBB\xBF";

/// How the characters of a file are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Charset {
    /// UTF-8.
    Utf8,
    /// Windows-1252, the encoding of the controls' older files.
    Windows1252,
    /// Windows-1250: Slovenian, Czech, Polish, Hungarian.
    Windows1250,
    /// Windows-1251: Cyrillic.
    Windows1251,
    /// GBK, and GB 2312 as a part of it: Chinese.
    Gbk,
    /// UTF-16, the lower byte of a unit first: what editors on a PC write as "Unicode".
    Utf16Le,
    /// UTF-16, the higher byte first.
    Utf16Be,
}

/// A file's encoding, remembered so that it can be written back byte by byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Encoding {
    /// The character set.
    pub charset: Charset,
    /// Whether a byte order mark begins the file; it is no part of the text.
    pub bom: bool,
}

/// The text of a file and what is needed to write it back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decoded {
    /// The text, without a byte order mark.
    pub text: String,
    /// The file's encoding.
    pub encoding: Encoding,
}

/// Reads a file's bytes; never fails.
pub fn decode(bytes: &[u8]) -> Decoded {
    decode_owned(bytes.to_vec())
}

/// Reads a file's bytes without a second copy of those that are UTF-8; never fails.
pub fn decode_owned(mut bytes: Vec<u8>) -> Decoded {
    for (charset, mark) in [(Charset::Utf16Le, [0xFF, 0xFE]), (Charset::Utf16Be, [0xFE, 0xFF])] {
        if let Some(text) = bytes.strip_prefix(&mark).and_then(|rest| decode_16(charset, rest)) {
            return Decoded { text, encoding: Encoding { charset, bom: true } };
        }
    }
    let bom = bytes.starts_with(BOM);
    if bom && std::str::from_utf8(bytes.get(BOM.len()..).unwrap_or_default()).is_ok() {
        bytes.drain(..BOM.len());
    }
    // A mark before bytes that are no UTF-8 is kept as three ordinary characters.
    match String::from_utf8(bytes) {
        Ok(text) => Decoded { text, encoding: Encoding { charset: Charset::Utf8, bom } },
        Err(error) => decode_page(error.as_bytes()),
    }
}

/// Reads bytes of the code page that they look like, if they can be written back with it.
fn decode_page(bytes: &[u8]) -> Decoded {
    let guessed = guess(bytes);
    for charset in [guessed, Charset::Windows1252] {
        let encoding = Encoding { charset, bom: false };
        let Some(page) = charset.page() else { continue };
        let (text, _) = page.decode_without_bom_handling(bytes);
        if charset == Charset::Windows1252 || encoding.encode(&text).is_ok_and(|again| again == bytes) {
            return Decoded { text: text.into_owned(), encoding };
        }
    }
    // Never reached: the last of them reads everything.
    let (text, _) = encoding_rs::WINDOWS_1252.decode_without_bom_handling(bytes);
    Decoded { text: text.into_owned(), encoding: Encoding { charset: Charset::Windows1252, bom: false } }
}

/// The code page that bytes look like, from their runs of bytes that are no ASCII.
fn guess(bytes: &[u8]) -> Charset {
    let (mut runs, mut paired, mut long, mut high, mut cyrillic, mut central) = (0, 0, 0, 0, 0, 0);
    let mut at = 0;
    while let Some(rest) = bytes.get(at..).filter(|rest| !rest.is_empty()) {
        let length = rest.iter().take_while(|byte| !byte.is_ascii()).count();
        if length == 0 {
            at += rest.iter().take_while(|byte| byte.is_ascii()).count();
            continue;
        }
        let run = rest.get(..length).unwrap_or_default();
        runs += 1;
        high += length;
        cyrillic += run.iter().filter(|byte| matches!(byte, 0xC0..=0xFF | 0xA8 | 0xB8)).count();
        let pair = |pair: &[u8]| matches!(pair, [0xA1..=0xF7, 0xA1..=0xFE]);
        paired += usize::from(length % 2 == 0 && run.chunks(2).all(pair));
        long += usize::from(length >= 4);
        let before = at.checked_sub(1).and_then(|at| bytes.get(at)).is_some_and(u8::is_ascii_alphabetic);
        let after = rest.get(length).is_some_and(u8::is_ascii_alphabetic);
        central += run.iter().filter(|byte| is_central(**byte, before, after)).count();
        at += length;
    }
    // Chinese comes in runs of pairs; letters with accents come singly, and Cyrillic ones have no lower bytes.
    if runs > 0 && paired == runs && 2 * long >= runs && cyrillic < high {
        Charset::Gbk
    } else if 2 * long >= runs && 20 * cyrillic >= 19 * high {
        Charset::Windows1251
    } else if central > 0 {
        Charset::Windows1250
    } else {
        Charset::Windows1252
    }
}

/// Whether a byte is a letter of Central Europe where it is: the same byte is a mark, or is at ends of words,
/// in the West (`È`, `£`, `¥`, `¹`, `³`, `Ø`).
fn is_central(byte: u8, before: bool, after: bool) -> bool {
    match byte {
        // Č, and ĽŁĄąľł in a word.
        0xC8 => after,
        0xA3 | 0xA5 | 0xB3 | 0xB9 | 0xBC | 0xBE => before || after,
        // Š, Ś, Ť, Ž, Ź in words; the West has Š and Ž hardly ever.
        0x8C | 0x8D | 0x8F | 0x9C | 0x9D | 0x9F | 0x8A | 0x8E | 0x9A | 0x9E => before || after,
        _ => false,
    }
}

/// Reads a file's bytes as of a character set; nothing if they could not be written back with it.
pub fn decode_as(bytes: &[u8], charset: Charset) -> Option<Decoded> {
    let bom = bytes.starts_with(BOM);
    let text = match charset {
        Charset::Utf8 if bom => std::str::from_utf8(bytes.get(BOM.len()..)?).ok()?.to_owned(),
        Charset::Utf8 => std::str::from_utf8(bytes).ok()?.to_owned(),
        Charset::Utf16Le | Charset::Utf16Be => decode_16(charset, bytes.get(2..)?)?,
        page => page.page()?.decode_without_bom_handling(bytes).0.into_owned(),
    };
    let encoding = Encoding {
        charset,
        bom: matches!(charset, Charset::Utf16Le | Charset::Utf16Be) || (charset == Charset::Utf8 && bom),
    };
    let again = encoding.encode(&text).is_ok_and(|again| again == bytes);
    again.then_some(Decoded { text, encoding })
}

impl Charset {
    /// All of them, with the names by which people ask for them.
    pub const NAMES: [(&'static str, Self); 7] = [
        ("utf-8", Self::Utf8),
        ("windows-1252", Self::Windows1252),
        ("windows-1250", Self::Windows1250),
        ("windows-1251", Self::Windows1251),
        ("gbk", Self::Gbk),
        ("utf-16le", Self::Utf16Le),
        ("utf-16be", Self::Utf16Be),
    ];

    /// The one of that name.
    pub fn named(name: &str) -> Option<Self> {
        Self::NAMES.iter().find(|(own, _)| own.eq_ignore_ascii_case(name)).map(|(_, charset)| *charset)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, own)| *own == self).map_or("", |(name, _)| name)
    }

    /// The code page, if it is one.
    fn page(self) -> Option<&'static encoding_rs::Encoding> {
        match self {
            Self::Windows1252 => Some(encoding_rs::WINDOWS_1252),
            Self::Windows1250 => Some(encoding_rs::WINDOWS_1250),
            Self::Windows1251 => Some(encoding_rs::WINDOWS_1251),
            Self::Gbk => Some(encoding_rs::GBK),
            Self::Utf8 | Self::Utf16Le | Self::Utf16Be => None,
        }
    }
}

impl Encoding {
    /// The code pages in which a text has the same bytes as in this one, this one left out.
    pub fn alike<'t>(self, text: &'t str) -> impl Iterator<Item = Self> + 't {
        let pages = [Charset::Windows1250, Charset::Windows1252, Charset::Windows1251];
        let own = self.charset.page();
        let same = move |other: &Self| {
            let mut buffer = [0; 4];
            other.charset != self.charset
                && own.zip(other.charset.page()).is_some_and(|(own, other)| {
                    text.chars().filter(|c| !c.is_ascii()).all(|c| {
                        let c = c.encode_utf8(&mut buffer);
                        let (one, two) = (own.encode(c), other.encode(c));
                        !one.2 && !two.2 && one.0 == two.0
                    })
                })
        };
        pages.map(|charset| Self { charset, bom: false }).into_iter().filter(same)
    }

    /// The bytes of `text` in this encoding, or the first character that it cannot write.
    pub fn encode(self, text: &str) -> Result<Cow<'_, [u8]>, char> {
        match self.charset {
            Charset::Utf8 if self.bom => Ok(Cow::Owned([BOM, text.as_bytes()].concat())),
            Charset::Utf8 => Ok(Cow::Borrowed(text.as_bytes())),
            charset @ (Charset::Windows1252 | Charset::Windows1250 | Charset::Windows1251 | Charset::Gbk) => {
                encode_page(charset.page().unwrap_or(encoding_rs::WINDOWS_1252), text)
            }
            Charset::Utf16Le | Charset::Utf16Be => Ok(Cow::Owned(encode_16(self.charset, text))),
        }
    }
}

/// The text, unless a unit is cut in two or half of a pair is missing.
fn decode_16(charset: Charset, bytes: &[u8]) -> Option<String> {
    let (units, []) = bytes.as_chunks::<2>() else { return None };
    let unit = |pair: &[u8; 2]| match charset {
        Charset::Utf16Be => u16::from_be_bytes(*pair),
        _ => u16::from_le_bytes(*pair),
    };
    char::decode_utf16(units.iter().map(unit)).collect::<Result<_, _>>().ok()
}

fn encode_16(charset: Charset, text: &str) -> Vec<u8> {
    let bytes = |unit: u16| match charset {
        Charset::Utf16Be => unit.to_be_bytes(),
        _ => unit.to_le_bytes(),
    };
    std::iter::once(0xFEFF).chain(text.encode_utf16()).flat_map(bytes).collect()
}

fn encode_page<'t>(page: &'static encoding_rs::Encoding, text: &'t str) -> Result<Cow<'t, [u8]>, char> {
    let (bytes, _, replaced) = page.encode(text);
    if !replaced {
        return Ok(bytes);
    }
    let mut buffer = [0; 4];
    let foreign = text.chars().find(|c| page.encode(c.encode_utf8(&mut buffer)).2);
    Err(foreign.unwrap_or(char::REPLACEMENT_CHARACTER))
}
