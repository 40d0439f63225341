//! The time at which a run starts.
//!
//! Invariant: a clock holds a date that exists; it never asks the computer.
use std::fmt;

/// A date and a time of day, without a time zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Clock {
    /// Year, four digits.
    pub year: u16,
    /// Month, 1 to 12.
    pub month: u8,
    /// Day of the month, from 1.
    pub day: u8,
    /// Hour, 0 to 23.
    pub hour: u8,
    /// Minute, 0 to 59.
    pub minute: u8,
    /// Second, 0 to 59.
    pub second: u8,
}

impl Clock {
    /// The time of a scene that gives none.
    pub const DEFAULT: Self = Self { year: 2000, month: 1, day: 1, hour: 0, minute: 0, second: 0 };

    /// Reads `2015-07-03`, `2015-07-03T14:05`, `2015-07-03T14:05:09`, with a blank instead of the T and with a
    /// Z at the end, too.
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim();
        let text = text.strip_suffix('Z').unwrap_or(text);
        let (date, time) = text.split_once(['T', ' ']).unwrap_or((text, "00:00"));
        let mut date = date.split('-').map(digits);
        let (year, month, day) = (date.next()??, date.next()??, date.next()??);
        let mut time = time.split(':').map(digits);
        let (hour, minute) = (time.next()??, time.next()??);
        let second = time.next().unwrap_or(Some(0))?;
        let extra = date.next().is_some() || time.next().is_some();
        let sound = !extra && year <= 9999 && (1..=month_days(year, month)).contains(&day);
        if !sound || hour > 23 || minute > 59 || second > 59 {
            return None;
        }
        let byte = |number: u16| u8::try_from(number).ok();
        let (month, day, hour) = (byte(month)?, byte(day)?, byte(hour)?);
        Some(Self { year, month, day, hour, minute: byte(minute)?, second: byte(second)? })
    }
}

fn digits(text: &str) -> Option<u16> {
    text.bytes().all(|b| b.is_ascii_digit()).then(|| text.parse().ok()).flatten()
}

/// The days of a month; 0 for one that does not exist.
fn month_days(year: u16, month: u16) -> u16 {
    // Of the years divisible by 25, those divisible by 4 end a century; 16 leaves every fourth of them.
    let leap = year.is_multiple_of(4) && (!year.is_multiple_of(25) || year.is_multiple_of(16));
    match month {
        1 | 3 | 5 | 7 | 8 | 10 | 12 => 31,
        4 | 6 | 9 | 11 => 30,
        2 => 28 + u16::from(leap),
        _ => 0,
    }
}

impl fmt::Display for Clock {
    /// `2015-07-03T14:05:09`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { year, month, day, hour, minute, second } = self;
        write!(f, "{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}")
    }
}
