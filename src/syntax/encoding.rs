//! Bytes of program files to text and back, for any bytes at all.
//!
//! Files are UTF-8 or Windows-1252, with or without a byte order mark, or UTF-16 with one. Invariant:
//! `decode(bytes).encode(&decode(bytes).text) == bytes`; Windows-1252 as WHATWG defines it gives
//! each of the 256 bytes a character of its own, so it can stand in for any unknown encoding.
use std::borrow::Cow;

const BOM: &[u8] = b"\xEF\xBB\xBF";

/// How the characters of a file are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Charset {
    /// UTF-8.
    Utf8,
    /// Windows-1252, the encoding of the controls' older files.
    Windows1252,
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
    for (charset, mark) in [(Charset::Utf16Le, [0xFF, 0xFE]), (Charset::Utf16Be, [0xFE, 0xFF])] {
        if let Some(text) = bytes.strip_prefix(&mark).and_then(|rest| decode_16(charset, rest)) {
            return Decoded { text, encoding: Encoding { charset, bom: true } };
        }
    }
    let (bom, rest) = bytes.strip_prefix(BOM).map_or((false, bytes), |rest| (true, rest));
    if let Ok(text) = std::str::from_utf8(rest) {
        return Decoded { text: text.to_owned(), encoding: Encoding { charset: Charset::Utf8, bom } };
    }
    // A mark before bytes that are no UTF-8 is kept as three ordinary characters.
    let (text, _) = encoding_rs::WINDOWS_1252.decode_without_bom_handling(bytes);
    Decoded { text: text.into_owned(), encoding: Encoding { charset: Charset::Windows1252, bom: false } }
}

impl Encoding {
    /// The bytes of `text` in this encoding, or the first character that it cannot write.
    pub fn encode(self, text: &str) -> Result<Cow<'_, [u8]>, char> {
        match self.charset {
            Charset::Utf8 if self.bom => Ok(Cow::Owned([BOM, text.as_bytes()].concat())),
            Charset::Utf8 => Ok(Cow::Borrowed(text.as_bytes())),
            Charset::Windows1252 => encode_1252(text),
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

fn encode_1252(text: &str) -> Result<Cow<'_, [u8]>, char> {
    let (bytes, _, replaced) = encoding_rs::WINDOWS_1252.encode(text);
    if !replaced {
        return Ok(bytes);
    }
    let mut buffer = [0; 4];
    let foreign = text.chars().find(|c| encoding_rs::WINDOWS_1252.encode(c.encode_utf8(&mut buffer)).2);
    Err(foreign.unwrap_or(char::REPLACEMENT_CHARACTER))
}
