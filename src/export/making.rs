//! A file in the making. It is written part by part, so that whoever makes it can say how far it is, and stop between two parts.

use std::io::{self, Write};

type WritePart<'a> = Box<dyn FnMut(usize, &mut dyn Write) -> io::Result<()> + Send + 'a>;

pub struct Making<'a> {
    parts: usize,
    next: usize,
    write: WritePart<'a>,
}

impl<'a> Making<'a> {
    /// Of so many parts; `write` gets their numbers in turn.
    pub fn new(
        parts: usize,
        write: impl FnMut(usize, &mut dyn Write) -> io::Result<()> + Send + 'a,
    ) -> Self {
        Making {
            parts,
            next: 0,
            write: Box::new(write),
        }
    }

    /// Of one part, which is there already.
    pub fn of(bytes: Vec<u8>) -> Self {
        Making::new(1, move |_, out| out.write_all(&bytes))
    }

    /// Writes the next part; whether there was one.
    pub fn write_next(&mut self, out: &mut dyn Write) -> io::Result<bool> {
        let goes_on = self.next < self.parts;
        if goes_on {
            (self.write)(self.next, out)?;
            self.next += 1;
        }
        Ok(goes_on)
    }

    /// How many parts are written, and how many there are.
    pub fn progress(&self) -> (usize, usize) {
        (self.next, self.parts)
    }

    /// Writes all parts. `progress` hears how many are written, and how many there are.
    pub fn write_all(
        mut self,
        out: &mut dyn Write,
        progress: &dyn Fn(usize, usize),
    ) -> io::Result<()> {
        while self.write_next(out)? {
            progress(self.next, self.parts);
        }
        Ok(())
    }
}
