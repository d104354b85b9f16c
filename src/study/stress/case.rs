//! One case, and what is said of it: data in the catalogue, a verdict when what came out is compared with what is known.

pub use super::measured::{Measured, Ran, Unit};

/// A stiff or extreme case.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// `family/what`
    pub name: &'static str,
    pub asks: &'static str,
    pub expects: &'static str,
    /// The closed form, the bound, or the source.
    pub because: &'static str,
    /// Errors: the message with which it was refused.
    pub run: fn() -> Result<Ran, String>,
    pub recorded: Recorded,
}

/// What is known of a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recorded {
    pub in_f64: Known,
    pub in_f32: Option<Known>,
}

/// What is known of a case in one precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Known {
    /// The error is within what a careful computation leaves.
    Holds { within: f64 },
    /// It is beyond that, but at most so large.
    Degrades { within: f64, most: f64 },
    /// There is no answer, and the message contains this.
    Refused { saying: &'static str },
}

pub const fn holds(within: f64) -> Recorded {
    Recorded {
        in_f64: Known::Holds { within },
        in_f32: None,
    }
}

pub const fn degrades(within: f64, most: f64) -> Recorded {
    Recorded {
        in_f64: Known::Degrades { within, most },
        in_f32: None,
    }
}

pub const fn refused(saying: &'static str) -> Recorded {
    Recorded {
        in_f64: Known::Refused { saying },
        in_f32: None,
    }
}

impl Recorded {
    pub const fn f32_holds(self, within: f64) -> Self {
        let in_f32 = Some(Known::Holds { within });
        Recorded { in_f32, ..self }
    }

    pub const fn f32_degrades(self, within: f64, most: f64) -> Self {
        let in_f32 = Some(Known::Degrades { within, most });
        Recorded { in_f32, ..self }
    }
}

/// What is said of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    Holds,
    Degrades,
    Refused,
    /// What is to be refused was taken.
    Taken,
}

impl Verdict {
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::Degrades => "degrades",
            Verdict::Refused => "refused",
            Verdict::Taken => "taken",
        }
    }
}

/// A verdict, and whether it is worse than the one recorded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Judged {
    pub verdict: Verdict,
    pub fell_short: bool,
}

impl Known {
    /// The verdict on what came out, or on the message that came instead.
    pub fn judge(&self, came: Result<&Measured, &str>) -> Judged {
        let (verdict, fell_short) = match (*self, came) {
            (Known::Refused { saying }, Err(message)) => {
                (Verdict::Refused, !message.contains(saying))
            }
            (Known::Refused { .. }, Ok(_)) => (Verdict::Taken, true),
            (_, Err(_)) => (Verdict::Refused, true),
            (Known::Holds { within }, Ok(measured)) if measured.error <= within => {
                (Verdict::Holds, false)
            }
            (Known::Holds { .. }, Ok(_)) => (Verdict::Degrades, true),
            (Known::Degrades { within, .. }, Ok(measured)) if measured.error <= within => {
                (Verdict::Holds, false)
            }
            // What is not a number is within nothing.
            (Known::Degrades { most, .. }, Ok(measured)) => (
                Verdict::Degrades,
                measured.error.is_nan() || measured.error > most,
            ),
        };
        Judged {
            verdict,
            fell_short,
        }
    }
}

/// A case that has run, with its verdicts.
#[derive(Clone, Debug)]
pub struct Report {
    pub case: Case,
    pub ran: Result<Ran, String>,
    pub in_f64: Judged,
    /// None where the case has nothing to say in f32, or was refused.
    pub in_f32: Option<Judged>,
}

impl Case {
    /// What stands before the slash.
    pub fn family(&self) -> &'static str {
        self.name
            .split_once('/')
            .map_or(self.name, |(family, _)| family)
    }

    pub fn report(&self) -> Report {
        let ran = (self.run)();
        let came = ran.as_ref().map(|ran| &ran.in_f64);
        let in_f64 = self.recorded.in_f64.judge(came.map_err(String::as_str));
        let in_f32 = match (&ran, self.recorded.in_f32) {
            (Ok(ran), Some(known)) => {
                let missing = "it said nothing in f32";
                Some(known.judge(ran.in_f32.as_ref().ok_or(missing)))
            }
            _ => None,
        };
        Report {
            case: *self,
            ran,
            in_f64,
            in_f32,
        }
    }
}

impl Report {
    /// Whether a verdict is worse than recorded.
    pub fn fell_short(&self) -> bool {
        self.in_f64.fell_short || self.in_f32.is_some_and(|judged| judged.fell_short)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_verdict_is_worse_than_recorded_where_the_error_is_larger_or_no_number() {
        let judge = |known: Known, error: f64| {
            let measured = Measured {
                error,
                ..Measured::absolute(1.0, 1.0)
            };
            let Judged {
                verdict,
                fell_short,
            } = known.judge(Ok(&measured));
            (verdict, fell_short)
        };
        let exact = Known::Holds { within: 1e-9 };
        assert_eq!(judge(exact, 1e-9), (Verdict::Holds, false));
        assert_eq!(judge(exact, 2e-9), (Verdict::Degrades, true));
        assert_eq!(judge(exact, f64::NAN), (Verdict::Degrades, true));
        let (within, most) = (1e-9, 1e-3);
        let poor = Known::Degrades { within, most };
        assert_eq!(judge(poor, 1e-10), (Verdict::Holds, false));
        assert_eq!(judge(poor, 1e-3), (Verdict::Degrades, false));
        assert_eq!(judge(poor, 2e-3), (Verdict::Degrades, true));
        assert_eq!(judge(poor, f64::NAN), (Verdict::Degrades, true));
        let none = Known::Refused { saying: "too many" };
        assert_eq!(judge(none, 0.0), (Verdict::Taken, true));
        assert!(!none.judge(Err("found too many patches")).fell_short);
        assert!(none.judge(Err("found too few patches")).fell_short);
        assert!(exact.judge(Err("found too many patches")).fell_short);
    }
}
